// Ticks of the axes, and points without neighbours.

import { formatNumber } from "../base/numbers";

/** Coordinates of a column, null where no point is drawn. */
export type Coordinates = (number | null)[];

/** Upper limit on the number of ticks of a logarithmic axis. */
const MAX_LOG_TICKS = 8;

/** Exponents of the ticks of a logarithmic axis: integers, and those of 2 and 5 if there are few decades. */
export function logTicks(low: number, high: number): number[] {
  const [from, to] = [Math.ceil(low - 1e-9), Math.floor(high + 1e-9)];
  const step = Math.max(1, Math.ceil((to - from + 1) / MAX_LOG_TICKS));
  const first = Math.ceil(from / step) * step;
  const exponents: number[] = [];
  for (let i = 0; first + i * step <= to && i < MAX_LOG_TICKS; i++) exponents.push(first + i * step);
  if (to - from > 2) return exponents;
  const all = exponents.flatMap((e) => [e, e + Math.log10(2), e + Math.log10(5)]);
  return all.filter((e) => e <= high);
}

/** Number of significant digits that distinguishes ticks at distance `step`. */
function significantDigits(ticks: Coordinates, step: number): number {
  const largest = Math.max(0, ...ticks.map((v) => Math.abs(v ?? 0)));
  const digits = step > 0 && largest > 0 ? Math.ceil(Math.log10(largest / step)) + 1 : 5;
  return Math.min(15, Math.max(5, digits));
}

/** Labels of ticks, with enough digits to distinguish them. */
export function tickLabels(ticks: Coordinates): string[] {
  const [a, b] = ticks.filter((v) => v != null);
  const digits = significantDigits(ticks, Math.abs((b ?? a ?? 0) - (a ?? 0)));
  return ticks.map((v) => (v == null ? "" : formatNumber(v, digits)));
}

/** Indices of points without a neighbour, which a line does not show. */
export function isolatedPoints(list: Coordinates): number[] {
  const indices: number[] = [];
  list.forEach((v, i) => {
    if (v !== null && (list[i - 1] ?? null) === null && (list[i + 1] ?? null) === null) indices.push(i);
  });
  return indices;
}
