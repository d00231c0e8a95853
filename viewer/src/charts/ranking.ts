// Selection and order of charts: those that vary most come first, columns without variation are not drawn.

import { valueRange } from "../base/numbers";
import type { Chart, Column } from "../scene/scene";
import type { ColumnMagnitudes } from "./magnitudes";

/** Relative size of a variation that counts as none. */
const CONSTANT = 1e-6;
/** Share of the height that a curve must cover; otherwise it gets axes of its own. */
const FLAT = 0.12;
/** Groups of charts whose columns are components of vectors, which may have separate axes. */
const VECTOR_GROUPS = ["probes", "reactions", "joints"];

export interface RankedChart {
  chart: Chart;
  /** Indices of the drawn columns by axes. */
  panels: number[][];
  /** Indices of the columns without variation that are not drawn. */
  constant: number[];
}

export interface Ranking {
  charts: RankedChart[];
  /** Charts without variation, if there are others. */
  constant: Chart[];
}

function variation({ values }: Column): number {
  const [low, high] = valueRange(values) ?? [0, 0];
  return high - low;
}

/** Indices of columns by axes, those of the largest variation first. A column joins the first axes on which no curve is flat. */
function separateAxes(chart: Chart, columns: number[]): number[][] {
  if (chart.log || !VECTOR_GROUPS.includes(chart.group)) return [columns];
  const panels: number[][] = [];
  for (const column of columns) {
    const fitting = panels.find((panel) => {
      const ranges = [...panel, column].map((i) => valueRange(chart.columns[i].values) ?? [0, 0]);
      const span = Math.max(...ranges.map((r) => r[1])) - Math.min(...ranges.map((r) => r[0]));
      return ranges.every(([low, high]) => high - low >= FLAT * span);
    });
    if (fitting) fitting.push(column);
    else panels.push([column]);
  }
  const largest = (panel: number[]) => Math.max(...panel.map((i) => variation(chart.columns[i])));
  return panels.sort((a, b) => largest(b) - largest(a));
}

/** Ranks the charts of a group. Discrete charts keep their order and all columns. */
export function rankCharts(charts: Chart[], magnitudes: ColumnMagnitudes, discrete: boolean): Ranking {
  const rated = charts.map((chart) => {
    const sizes = chart.columns.map(variation);
    const moving = chart.columns
      .map((_, i) => i)
      .filter((i) => sizes[i] > CONSTANT * magnitudes.of(chart, chart.columns[i]));
    const shares = moving.map((i) => sizes[i] / magnitudes.variation(chart, chart.columns[i]));
    return { chart, moving, score: Math.max(0, ...shares) };
  });
  const all = (chart: Chart) => chart.columns.map((_, i) => i);
  if (discrete || rated.every(({ moving }) => moving.length === 0)) {
    return { charts: charts.map((chart) => ({ chart, panels: [all(chart)], constant: [] })), constant: [] };
  }
  const varying = rated.filter(({ moving }) => moving.length > 0).sort((a, b) => b.score - a.score);
  return {
    charts: varying.map(({ chart, moving }) => ({
      chart,
      panels: separateAxes(chart, moving),
      constant: all(chart).filter((i) => !moving.includes(i)),
    })),
    constant: rated.filter(({ moving }) => moving.length === 0).map(({ chart }) => chart),
  };
}
