// Vertical scales of charts: conversion of values to numbers of moderate size, which uPlot requires.

import { largestMagnitude, ROUNDING_NOISE } from "../base/numbers";
import type { Chart } from "../scene/scene";
import type { ColumnMagnitudes } from "./magnitudes";
import type { Coordinates } from "./ticks";

/** Number of decades below the largest value that a logarithmic chart shows. */
const MAX_DECADES = 18;
/** Relative resolution of single precision. */
const SINGLE_PRECISION = 2e-7;

export type AxisRange = [number, number];

/** Vertical scale of a chart. Coordinates are multiples of a power of ten, or exponents. */
export interface AxisScale {
  /** Coordinate of a value of a column; null if the value is not drawn. */
  coordinate(x: number, column: number): number | null;
  /** Value as displayed, without rounding noise. */
  displayed(x: number, column: number): number;
  /** Value at a coordinate. */
  value(coordinate: number): number;
  /** Range of the axis for coordinates from `low` to `high`. */
  range(low: number | null, high: number | null): AxisRange;
}

function powerOfTen(exponent: number): number {
  return Number(`1e${exponent}`);
}

export class LinearScale implements AxisScale {
  /** Noise level of each column. */
  private readonly noise: number[];
  /** Power of ten that corresponds to coordinate one. */
  private readonly unit: number;
  /** Resolution of the coordinates. */
  private readonly resolution: number;

  constructor(chart: Chart, magnitudes: ColumnMagnitudes) {
    this.noise = chart.columns.map((c) => ROUNDING_NOISE * magnitudes.of(chart, c));
    const sizes = chart.columns.map((c, i) => {
      const size = largestMagnitude(c.values);
      return size < this.noise[i] ? 0 : size;
    });
    const largest = Math.max(0, ...sizes);
    this.unit = largest > 0 ? powerOfTen(Math.max(-300, Math.floor(Math.log10(largest)))) : 1;
    const single = chart.columns.some((c) => c.values instanceof Float32Array);
    const precision = single ? SINGLE_PRECISION : ROUNDING_NOISE;
    this.resolution = Math.max(precision * largest, ...this.noise) / this.unit;
  }

  coordinate(x: number, column: number): number | null {
    return Number.isFinite(x) ? this.displayed(x, column) / this.unit : null;
  }

  displayed(x: number, column: number): number {
    return Math.abs(x) < this.noise[column] ? 0 : x;
  }

  value(coordinate: number): number {
    return coordinate * this.unit;
  }

  range(low: number | null, high: number | null): AxisRange {
    return low == null || high == null ? [0, 1] : paddedRange(low, high, this.resolution);
  }
}

/** Range with a margin. Values that differ by at most `resolution` get a small range around their mean. */
export function paddedRange(low: number, high: number, resolution: number): AxisRange {
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low <= resolution) {
    const half = size === 0 ? 1 : Math.max(0.05 * size, resolution);
    const middle = (low + high) / 2;
    return [middle - half, middle + half];
  }
  const margin = 0.08 * (high - low);
  const [below, above] = [low - margin, high + margin];
  return [low >= 0 && below < 0 ? 0 : below, high <= 0 && above > 0 ? 0 : above];
}

export class LogarithmicScale implements AxisScale {
  /** Smallest exponent that is drawn. */
  private readonly minExponent: number;

  /** Logarithms are those of magnitudes if the values have both signs. */
  constructor(
    chart: Chart,
    private readonly absolute: boolean,
  ) {
    const largest = Math.max(0, ...chart.columns.map((c) => largestMagnitude(c.values)));
    this.minExponent = largest > 0 ? Math.log10(largest) - MAX_DECADES : 0;
  }

  coordinate(value: number): number | null {
    const x = this.absolute ? Math.abs(value) : value;
    if (!(x > 0 && Number.isFinite(x))) return null;
    const exponent = Math.log10(x);
    return exponent < this.minExponent ? null : exponent;
  }

  displayed(x: number): number {
    return x;
  }

  value(coordinate: number): number {
    const integer = Math.round(coordinate);
    return Math.abs(coordinate - integer) < 1e-9 ? powerOfTen(integer) : 10 ** coordinate;
  }

  range(low: number | null, high: number | null): AxisRange {
    if (low == null || high == null) return [-1, 0];
    const [from, to] = [Math.floor(low + 1e-9), Math.ceil(high - 1e-9)];
    return to > from ? [from, to] : [to - 1, to + 1];
  }
}

/** Share of the abscissa that counts as the start. */
const START = 0.03;
/** Factor by which a spike extends the range. */
const SPIKE = 3;
/** Smallest range after the start, relative to the whole range. */
const MIN_SHARE = 1e-3;

/** Range of the coordinates between two abscissas; null if there are none. */
function rangeBetween(
  xs: number[],
  columns: Coordinates[],
  from: number,
  to: number,
): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const column of columns) {
    for (let i = 0; i < xs.length; i++) {
      const y = column[i];
      if (y === null || xs[i] < from || xs[i] > to) continue;
      low = Math.min(low, y);
      high = Math.max(high, y);
    }
  }
  return low <= high ? [low, high] : null;
}

/** Range after the start if the start has a spike; null if it has none. */
export function rangeWithoutSpike(xs: number[], columns: Coordinates[]): [number, number] | null {
  const [first, last] = [xs[0], xs[xs.length - 1]];
  const start = first + START * (last - first);
  const whole = rangeBetween(xs, columns, first, last);
  const rest = rangeBetween(xs, columns, start, last);
  if (!whole || !rest) return null;
  const [size, without] = [whole[1] - whole[0], rest[1] - rest[0]];
  return size > SPIKE * without && without > MIN_SHARE * size ? rest : null;
}
