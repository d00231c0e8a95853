// Largest magnitudes of comparable columns, the reference for rounding noise.

import { largestMagnitude } from "../base/numbers";
import type { Chart, Column } from "../scene/scene";

/** Largest magnitude of the columns of a group with the same unit. Columns without one are compared by chart title. */
export class ColumnMagnitudes {
  private readonly largest = new Map<string, number>();

  constructor(charts: Chart[]) {
    for (const chart of charts) {
      for (const column of chart.columns) {
        const key = comparisonKey(chart, column);
        this.largest.set(key, Math.max(this.largest.get(key) ?? 0, largestMagnitude(column.values)));
      }
    }
  }

  of(chart: Chart, column: Column): number {
    return this.largest.get(comparisonKey(chart, column)) ?? 0;
  }
}

function comparisonKey(chart: Chart, column: Column): string {
  return [chart.group, column.unit || chart.title.split(": ").at(-1)].join("\n");
}
