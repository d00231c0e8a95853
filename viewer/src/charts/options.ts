// Options of uPlot for a chart: axes, scales, series.

import type uPlot from "uplot";
import { cssColour, paletteColour } from "../base/colours";
import { formatQuantity } from "../base/units";
import type { Chart } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import { type AxisRange, type AxisScale, paddedRange } from "./scales";
import { type Coordinates, isolatedPoints, logTicks, tickLabels } from "./ticks";

/** Chart with its axes and the coordinates of each column. */
export interface PreparedChart {
  chart: Chart;
  abscissa: Abscissa;
  scale: AxisScale;
  coordinates: Coordinates[];
}

/** Height of a chart in CSS pixels. */
export const HEIGHT = 206;

/** Value of a CSS custom property. */
function cssProperty(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Unit that all columns share, "" if they differ. */
export function commonUnit(chart: Chart): string {
  const first = chart.columns[0]?.unit ?? "";
  return chart.columns.every((c) => c.unit === first) ? first : "";
}

/** Range of the whole abscissa. */
export function fullRange({ xs, discrete }: Abscissa): AxisRange {
  const [low, high] = [xs[0] ?? 0, xs[xs.length - 1] ?? 1];
  if (discrete) return [low - 0.5, high + 0.5];
  return high > low ? [low, high] : paddedRange(low, high, 0);
}

/** True if a range of the abscissa is not that of all rows. */
function isZoomed({ xs }: Abscissa, low: number, high: number): boolean {
  return xs.length > 1 && high > low && !(low === xs[0] && high === xs[xs.length - 1]);
}

export function plotOptions(prepared: PreparedChart, width: number): uPlot.Options {
  const { chart, abscissa, scale } = prepared;
  return {
    ...{ width, height: HEIGHT, padding: [8, 14, 0, 0] },
    cursor: { drag: { x: false, y: false }, sync: { key: "ancf" }, points: { size: 6 } },
    scales: {
      x: {
        time: false,
        range: (_, low, high) => (isZoomed(abscissa, low, high) ? [low, high] : fullRange(abscissa)),
      },
      y: { range: (_, low, high) => scale.range(low, high) },
    },
    axes: axes(prepared),
    legend: { live: true },
    series: [
      { label: abscissa.label, value: (_, v) => (v == null ? "–" : formatQuantity(v, abscissa.unit)) },
      ...chart.columns.map((_, i) => series(prepared, i)),
    ],
  };
}

function axes({ chart, abscissa, scale }: PreparedChart): uPlot.Axis[] {
  const [ink, rule] = [cssProperty("--ink-2"), cssProperty("--rule")];
  const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 4 } };
  const font = "11px system-ui, sans-serif";
  const xLabels = (_: uPlot, ticks: Coordinates) => tickLabels(ticks);
  const yLabels = (_: uPlot, ticks: Coordinates) =>
    tickLabels(ticks.map((v) => (v == null ? null : scale.value(v))));
  const label = abscissa.unit ? `${abscissa.label} [${abscissa.unit}]` : abscissa.label;
  const splits = (_: uPlot, __: number, low: number, high: number) => logTicks(low, high);
  return [
    {
      ...{ ...axis, font, size: 24, gap: 4, space: abscissa.discrete ? 28 : 60, values: xLabels },
      ...{ label, labelSize: 16, labelGap: 0, labelFont: font },
      ...(abscissa.discrete ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
    },
    { ...axis, font, gap: 4, size: axisWidth, values: yLabels, ...(chart.log ? { splits } : {}) },
  ];
}

/** Series of a column: a line, or points if the rows are discrete. */
function series({ chart, abscissa, scale, coordinates }: PreparedChart, index: number): uPlot.Series {
  const { label, unit, values } = chart.columns[index];
  const stroke = cssColour(paletteColour(index));
  const isolated = isolatedPoints(coordinates[index]);
  const points = abscissa.discrete
    ? { show: true, size: 7, fill: stroke }
    : { show: false, size: 4, fill: stroke, filter: () => isolated };
  const common = commonUnit(chart);
  return {
    ...{ label, stroke, width: 1.6, pxAlign: 0, points },
    ...(abscissa.discrete ? { paths: () => null } : {}),
    value: (_, __, ___, row) => {
      const value = row == null ? Number.NaN : scale.displayed(values[row], index);
      return Number.isNaN(value) ? "–" : formatQuantity(value, unit === common ? "" : unit);
    },
  };
}

/** Width of the vertical axis for its longest label. */
function axisWidth(_: uPlot, labels: string[] | null): number {
  const longest = Math.max(3, ...(labels ?? []).map((v) => v?.length ?? 0));
  return 14 + 6.4 * longest;
}
