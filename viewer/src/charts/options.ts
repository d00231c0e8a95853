// Options of uPlot for a chart: axes, scales, series.

import type uPlot from "uplot";
import { cssColour, paletteColour } from "../base/colours";
import { formatNumber } from "../base/numbers";
import { type DisplayUnit, displayUnit, formatQuantity } from "../base/units";
import type { Chart } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import type { SharedMargin } from "./margin";
import { type AxisRange, type AxisScale, paddedRange } from "./scales";
import { type Coordinates, isolatedPoints, logTicks, tickLabels } from "./ticks";

/** Curves with common axes. */
export interface Panel {
  chart: Chart;
  /** Indices of the columns that are drawn. */
  columns: number[];
  abscissa: Abscissa;
  scale: AxisScale;
  /** Coordinates of the drawn columns. */
  coordinates: Coordinates[];
  /** Unit of the values for display. */
  unit: DisplayUnit;
  margin: SharedMargin;
  /** Range of the vertical axis without a spike; null for the range of the values. */
  reduced: () => AxisRange | null;
}

/** Value of a CSS custom property. */
function cssProperty(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
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

export function plotOptions(panel: Panel, width: number, height: number): uPlot.Options {
  const { abscissa, scale, columns, reduced } = panel;
  const end = abscissa.xs.at(-1);
  return {
    ...{ width, height, padding: [8, 14, 0, 0] },
    cursor: { drag: { x: false, y: false }, sync: { key: "ancf" }, points: { size: 6 } },
    scales: {
      x: {
        time: false,
        range: (_, low, high) => (isZoomed(abscissa, low, high) ? [low, high] : fullRange(abscissa)),
      },
      y: { range: (_, low, high) => scale.range(...(reduced() ?? [low, high])) },
    },
    axes: axes(panel),
    legend: { live: true },
    series: [
      { label: abscissa.label, value: (_, v) => (v == null ? "–" : formatQuantity(v, abscissa.unit, end)) },
      ...columns.map((_, i) => series(panel, i)),
    ],
  };
}

function axes({ chart, abscissa, scale, unit, margin }: Panel): uPlot.Axis[] {
  const [ink, rule] = [cssProperty("--ink-2"), cssProperty("--rule")];
  const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 4 } };
  const font = "11px system-ui, sans-serif";
  const time = displayUnit(abscissa.unit, abscissa.xs.at(-1) ?? 0);
  const xLabels = (_: uPlot, ticks: Coordinates) =>
    tickLabels(ticks.map((v) => (v == null ? null : v / time.size)));
  const yLabels = (_: uPlot, ticks: Coordinates) =>
    tickLabels(ticks.map((v) => (v == null ? null : scale.value(v) / unit.size)));
  const label = time.name ? `${abscissa.label} [${time.name}]` : abscissa.label;
  const splits = (_: uPlot, __: number, low: number, high: number) => logTicks(low, high);
  return [
    {
      ...{ ...axis, font, size: 24, gap: 4, space: abscissa.discrete ? 28 : 60, values: xLabels },
      ...{ label, labelSize: 16, labelGap: 0, labelFont: font },
      ...(abscissa.discrete ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
    },
    {
      ...{ ...axis, font, gap: 4, values: yLabels, ...(chart.log ? { splits } : {}) },
      size: (_, labels) => margin.request(axisWidth(labels)),
    },
  ];
}

/** Series of a drawn column: a line, or points if the rows are discrete. */
function series({ chart, columns, abscissa, scale, coordinates, unit }: Panel, index: number): uPlot.Series {
  const { label, values, unit: own } = chart.columns[columns[index]];
  const stroke = cssColour(paletteColour(columns[index]));
  const isolated = isolatedPoints(coordinates[index]);
  const points = abscissa.discrete
    ? { show: true, size: 7, fill: stroke }
    : { show: false, size: 4, fill: stroke, filter: () => isolated };
  const common = columns.every((i) => chart.columns[i].unit === own);
  return {
    ...{ label, stroke, width: 1.6, pxAlign: 0, points },
    ...(abscissa.discrete ? { paths: () => null } : {}),
    value: (_, __, ___, row) => {
      const value = row == null ? Number.NaN : scale.displayed(values[row], columns[index]);
      if (Number.isNaN(value)) return "–";
      return common ? formatNumber(value / unit.size) : formatQuantity(value, own);
    },
  };
}

/** Width of the vertical axis for its longest label. */
function axisWidth(labels: string[] | null): number {
  const longest = Math.max(3, ...(labels ?? []).map((v) => v?.length ?? 0));
  return 14 + 6.4 * longest;
}
