// Largest magnitudes and variations of comparable columns, the references for rounding noise and ranking.

import { largestMagnitude, valueRange } from "../base/numbers";
import type { Chart, Column } from "../scene/scene";

/** Largest values of the columns of a group with the same unit. Columns without one are compared by chart title. */
export class ColumnMagnitudes {
  private readonly largest = new Map<string, [magnitude: number, variation: number]>();

  constructor(charts: Chart[]) {
    for (const chart of charts) {
      for (const column of chart.columns) {
        const key = comparisonKey(chart, column);
        const [magnitude, variation] = this.largest.get(key) ?? [0, 0];
        const [low, high] = valueRange(column.values) ?? [0, 0];
        this.largest.set(key, [
          Math.max(magnitude, largestMagnitude(column.values)),
          Math.max(variation, high - low),
        ]);
      }
    }
  }

  of(chart: Chart, column: Column): number {
    return this.largest.get(comparisonKey(chart, column))?.[0] ?? 0;
  }

  /** Largest variation of comparable columns. */
  variation(chart: Chart, column: Column): number {
    return this.largest.get(comparisonKey(chart, column))?.[1] ?? 0;
  }
}

function comparisonKey(chart: Chart, column: Column): string {
  return [chart.group, column.unit || chart.title.split(": ").at(-1)].join("\n");
}
