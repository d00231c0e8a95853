// Scenes with charts of a few rows.

import { cantilever } from "./cantilever.mjs";
import { f64 } from "./container.mjs";

/** Scene with charts of a few rows; columns are [label, unit, numbers]. */
export function chartScene(charts) {
  const count = charts[0].columns[0][2].length;
  const times = Array.from({ length: count }, (_, i) => (count > 1 ? (2 * i) / (count - 1) : 0));
  return {
    ...cantilever({ frames: 3 }),
    abscissa: { name: "t", unit: "s", values: f64(times) },
    charts: charts.map(({ title, columns, log = false, group = "probes" }) => ({
      ...{ title, group, log },
      columns: columns.map(([label, unit, values, errors]) => ({
        ...{ name: label, label, unit, values: f64(values) },
        ...(errors ? { errors: f64(errors) } : {}),
      })),
    })),
  };
}
