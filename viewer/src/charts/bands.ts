// Bands of the estimated errors of curves: value ± error.

import type uPlot from "uplot";
import { cssColour, paletteColour } from "../base/colours";
import type { Panel } from "./options";

/** Opacity of a band. */
const OPACITY = 0.22;

/** Returns a hook of uPlot that draws the bands behind the curves. */
export function bandHook({ chart, columns, scale }: Panel): (plot: uPlot) => void {
  return (plot) => {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.globalAlpha = OPACITY;
    columns.forEach((number, i) => {
      const column = chart.columns[number];
      if (!column.errors || !plot.series[i + 1].show) return;
      ctx.fillStyle = cssColour(paletteColour(number));
      for (const part of bandParts(plot.data[0], column.values, column.errors)) {
        const at = (row: number, sign: number): [number, number] => {
          const value = column.values[row] + sign * Math.abs(column.errors?.[row] ?? 0);
          const coordinate = scale.coordinate(value, number) ?? Number.NaN;
          return [plot.valToPos(plot.data[0][row], "x", true), plot.valToPos(coordinate, "y", true)];
        };
        ctx.beginPath();
        for (const row of part) ctx.lineTo(...at(row, 1));
        for (const row of [...part].reverse()) ctx.lineTo(...at(row, -1));
        ctx.fill();
      }
    });
    ctx.restore();
  };
}

/** Returns the runs of rows in which abscissa, value and error are numbers. */
export function bandParts(
  xs: ArrayLike<number | null | undefined>,
  values: ArrayLike<number>,
  errors: ArrayLike<number>,
): number[][] {
  const parts: number[][] = [];
  let last = -2;
  for (let row = 0; row < values.length; row++) {
    if (!Number.isFinite(xs[row]) || !Number.isFinite(values[row]) || !Number.isFinite(errors[row])) continue;
    if (row !== last + 1) parts.push([]);
    parts[parts.length - 1].push(row);
    last = row;
  }
  return parts;
}
