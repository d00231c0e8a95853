// Units for display: SI units get a prefix, all other units are shown as they are.

import { formatNumber } from "./numbers";

/** SI unit: symbol with a prefix, factor from the given unit, smallest and largest power of 1000. */
type SiUnit = [symbol: string, factor: number, least: number, most: number];

const SI_UNITS: Record<string, SiUnit> = {
  m: ["m", 1, -3, 1],
  s: ["s", 1, -3, 0],
  N: ["N", 1, -2, 3],
  J: ["J", 1, -3, 3],
  W: ["W", 1, -3, 3],
  "N m": ["N m", 1, -2, 3],
  "m/s": ["m/s", 1, -2, 0],
  "m/s²": ["m/s²", 1, -2, 0],
  "N/m": ["N/m", 1, -1, 3],
  "N/m²": ["Pa", 1, -2, 3],
  "N/mm²": ["Pa", 1e6, -2, 3],
};
const PREFIXES: Record<number, string> = { [-3]: "n", [-2]: "µ", [-1]: "m", 0: "", 1: "k", 2: "M", 3: "G" };

/** Unit for display; a value is divided by `size`. */
export interface DisplayUnit {
  name: string;
  size: number;
}

/** Unit that gives `reference` one to three digits before the decimal point; 0.1 to 1 stays without a prefix. */
export function displayUnit(unit: string, reference: number): DisplayUnit {
  const [symbol, factor, least, most] = SI_UNITS[unit] ?? [];
  const size = Math.abs(reference) * (factor ?? 1);
  if (symbol === undefined || !(size > 0) || !Number.isFinite(size)) return { name: unit, size: 1 };
  // The tolerance keeps 999.96, which is displayed as 1000, out of the smaller unit.
  const thousands = Math.floor(Math.log10(size * 1.00005) / 3);
  const power = size >= 0.1 && size < 1 ? 0 : Math.min(most, Math.max(least, thousands));
  // Outside the range of the prefixes an exponent is shorter.
  if (size < 1e-3 * 1000 ** power || size >= 1e5 * 1000 ** power) return { name: unit, size: 1 };
  return { name: PREFIXES[power] + symbol, size: 1000 ** power / factor };
}

/** Formats a number with its unit. The prefix is that of `reference`, unless the number is small for it. */
export function formatQuantity(x: number, unit: string, reference = x): string {
  const shared = displayUnit(unit, reference);
  const small = x !== 0 && Math.abs(x) < 0.1 * shared.size;
  const { name, size } = small ? displayUnit(unit, x) : shared;
  const number = formatNumber(x / size);
  return name === "" ? number : `${number} ${name}`;
}
