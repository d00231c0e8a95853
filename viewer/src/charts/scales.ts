// What numbers of a chart are drawn where: without rounding noise, and within what uPlot's axes can bear.

import type { Chart, Column } from "../scene/scene";

/** Numbers below this part of the largest of their kind are rounding noise. */
export const NOISE = 1e-12;
/** A logarithmic chart shows no more decades than these below its largest number. */
const DECADES = 18;
/** Relative steps between numbers of single precision. */
const SINGLE = 2e-7;
/** A logarithmic axis has at most this many ticks. */
const TICKS = 8;

/** A number, or zero if it is nothing beside the largest of its kind. */
export function clean(x: number, largest: number): number {
  return Math.abs(x) < NOISE * largest ? 0 : x;
}

export function largest(values: ArrayLike<number>): number {
  let most = 0;
  for (let i = 0; i < values.length; i++) {
    const size = Math.abs(values[i]);
    if (size > most && Number.isFinite(size)) most = size;
  }
  return most;
}

/** The largest number of each kind: the columns of a group of charts with the same unit, or else heading. */
export class Kinds {
  private readonly most = new Map<string, number>();

  constructor(charts: Chart[]) {
    for (const chart of charts) {
      for (const column of chart.columns) {
        const key = kind(chart, column);
        this.most.set(key, Math.max(this.most.get(key) ?? 0, largest(column.values)));
      }
    }
  }

  of(chart: Chart, column: Column): number {
    return this.most.get(kind(chart, column)) ?? 0;
  }
}

function kind(chart: Chart, column: Column): string {
  return [chart.group, column.unit || chart.title.split(": ").at(-1)].join("\n");
}

export type Range = [number, number];

/** The vertical axis of a chart; uPlot gets numbers of moderate size: multiples of a power of ten, or exponents. */
export interface Scale {
  /** Where a number of a column is drawn; null: nowhere. */
  place(x: number, column: number): number | null;
  /** What is told of a number. */
  shown(x: number, column: number): number;
  /** Number at a place. */
  at(place: number): number;
  /** Range for places from `low` to `high`. */
  range(low: number | null, high: number | null): Range;
}

export function power(exponent: number): number {
  return Number(`1e${exponent}`);
}

export class Linear implements Scale {
  private readonly noise: number[];
  private readonly unit: number;
  private readonly grain: number;

  constructor(chart: Chart, kinds: Kinds) {
    this.noise = chart.columns.map((c) => NOISE * kinds.of(chart, c));
    const sizes = chart.columns.map((c, i) => {
      const most = largest(c.values);
      return most < this.noise[i] ? 0 : most;
    });
    const most = Math.max(0, ...sizes);
    this.unit = most > 0 ? power(Math.max(-300, Math.floor(Math.log10(most)))) : 1;
    const single = chart.columns.some((c) => c.values instanceof Float32Array);
    this.grain = Math.max((single ? SINGLE : NOISE) * most, ...this.noise) / this.unit;
  }

  place(x: number, column: number): number | null {
    return Number.isFinite(x) ? this.shown(x, column) / this.unit : null;
  }

  shown(x: number, column: number): number {
    return Math.abs(x) < this.noise[column] ? 0 : x;
  }

  at(place: number): number {
    return place * this.unit;
  }

  range(low: number | null, high: number | null): Range {
    return low == null || high == null ? [0, 1] : around(low, high, this.grain);
  }
}

/** The range with a margin; of what is constant but for `grain`: the value and a small part to both sides. */
export function around(low: number, high: number, grain: number): Range {
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low <= grain) {
    const half = size === 0 ? 1 : Math.max(0.05 * size, grain);
    const middle = (low + high) / 2;
    return [middle - half, middle + half];
  }
  const margin = 0.08 * (high - low);
  const [below, above] = [low - margin, high + margin];
  return [low >= 0 && below < 0 ? 0 : below, high <= 0 && above > 0 ? 0 : above];
}

export class Logarithmic implements Scale {
  private readonly floor: number;

  constructor(chart: Chart) {
    const most = Math.max(0, ...chart.columns.map((c) => largest(c.values)));
    this.floor = most > 0 ? Math.log10(most) - DECADES : 0;
  }

  place(x: number): number | null {
    if (!(x > 0 && Number.isFinite(x))) return null;
    const exponent = Math.log10(x);
    return exponent < this.floor ? null : exponent;
  }

  shown(x: number): number {
    return x;
  }

  at(place: number): number {
    const whole = Math.round(place);
    return Math.abs(place - whole) < 1e-9 ? power(whole) : 10 ** place;
  }

  range(low: number | null, high: number | null): Range {
    if (low == null || high == null) return [-1, 0];
    const [from, to] = [Math.floor(low + 1e-9), Math.ceil(high - 1e-9)];
    return to > from ? [from, to] : [to - 1, to + 1];
  }
}

/** Exponents of the ticks of a logarithmic axis: whole decades, and 2 and 5 where there are few. */
export function decades(low: number, high: number): number[] {
  const [from, to] = [Math.ceil(low - 1e-9), Math.floor(high + 1e-9)];
  const step = Math.max(1, Math.ceil((to - from + 1) / TICKS));
  const first = Math.ceil(from / step) * step;
  const list: number[] = [];
  for (let i = 0; first + i * step <= to && i < TICKS; i++) list.push(first + i * step);
  if (to - from > 2) return list;
  const all = list.flatMap((e) => [e, e + Math.log10(2), e + Math.log10(5)]);
  return all.filter((e) => e <= high);
}

/** Digits by which ticks differ that are `step` apart. */
export function digits(ticks: (number | null)[], step: number): number {
  const most = Math.max(0, ...ticks.map((v) => Math.abs(v ?? 0)));
  const wanted = step > 0 && most > 0 ? Math.ceil(Math.log10(most / step)) + 1 : 5;
  return Math.min(15, Math.max(5, wanted));
}

/** Indices of numbers without a neighbour, which no line reaches. */
export function isolated(list: (number | null)[]): number[] {
  const found: number[] = [];
  list.forEach((v, i) => {
    if (v !== null && (list[i - 1] ?? null) === null && (list[i + 1] ?? null) === null) found.push(i);
  });
  return found;
}
