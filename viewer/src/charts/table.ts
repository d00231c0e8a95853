// Text alternatives of a chart: summary, table of extremes, values as CSV.

import { h, saveFile } from "../base/dom";
import { valueRange } from "../base/numbers";
import { displayUnit, formatQuantity } from "../base/units";
import type { Chart } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import type { ColumnMagnitudes } from "./magnitudes";

/** Relative size below which a value of a linear chart counts as zero. */
const NOISE = 1e-6;

/** Value of a column as text. Noise is zero. */
function valueText(chart: Chart, column: number, x: number, magnitudes: ColumnMagnitudes): string {
  const { unit, values } = chart.columns[column];
  const [low, high] = valueRange(values) ?? [0, 0];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const noise = chart.log ? 0 : NOISE * magnitudes.of(chart, chart.columns[column]);
  return Math.abs(x) < noise ? formatQuantity(0, unit) : formatQuantity(x, unit, size);
}

/** Text such as "x 0 m, y 1 m" of columns without variation. Columns without values are omitted. */
export function constantsText(chart: Chart, columns: number[], magnitudes: ColumnMagnitudes): string {
  return columns
    .filter((i) => valueRange(chart.columns[i].values) !== null)
    .map((i) => `${chart.columns[i].label} ${valueText(chart, i, chart.columns[i].values[0], magnitudes)}`)
    .join(", ");
}

/** Description of a chart for screen readers: the range of each curve. */
export function description(chart: Chart, columns: number[], magnitudes: ColumnMagnitudes): string {
  const ranges = columns.map((i) => {
    const range = valueRange(chart.columns[i].values);
    if (!range) return `${chart.columns[i].label} without values`;
    const [low, high] = range.map((x) => valueText(chart, i, x, magnitudes));
    return `${chart.columns[i].label} from ${low} to ${high}`;
  });
  return `${chart.title}: ${ranges.join("; ")}`;
}

/** Table of the first, last, least and largest values of all columns, created when it is opened. */
export function extremesTable(
  chart: Chart,
  { abscissa, magnitudes }: { abscissa: Abscissa; magnitudes: ColumnMagnitudes },
  state: { table: boolean },
): HTMLElement {
  const details = h("details", { class: "chart-table", open: state.table }, h("summary", {}, "Table"));
  const fill = () => {
    if (details.open && details.children.length === 1) details.append(table(chart, abscissa, magnitudes));
  };
  details.addEventListener("toggle", () => {
    state.table = details.open;
    fill();
  });
  fill();
  return details;
}

function table(chart: Chart, abscissa: Abscissa, magnitudes: ColumnMagnitudes): HTMLElement {
  const heads = ["", "first", "last", "minimum", "maximum"].map((text) =>
    text === "" ? h("td") : h("th", { scope: "col" }, text),
  );
  const rows = chart.columns.map(({ label, values }, i) => {
    const text = (row: number) => (row < 0 ? "–" : valueText(chart, i, values[row], magnitudes));
    const at = (row: number) => {
      if (row < 0) return null;
      const name = abscissa.label === "" ? "" : `${abscissa.label} = `;
      return h("small", {}, ` ${name}${formatQuantity(abscissa.xs[row], abscissa.unit, abscissa.xs.at(-1))}`);
    };
    const finite = Array.from(values.keys()).filter((row) => Number.isFinite(values[row]));
    const extreme = (sign: number) =>
      finite.reduce((best, row) => (best < 0 || sign * values[row] > sign * values[best] ? row : best), -1);
    const [least, largest] = [extreme(-1), extreme(1)];
    return h(
      "tr",
      {},
      h("th", { scope: "row" }, label),
      h("td", {}, text(finite[0] ?? -1)),
      h("td", {}, text(finite.at(-1) ?? -1)),
      h("td", {}, text(least), at(least)),
      h("td", {}, text(largest), at(largest)),
    );
  });
  const body = h("table", {}, h("thead", {}, h("tr", {}, ...heads)), h("tbody", {}, ...rows));
  body.setAttribute("aria-label", `values of ${chart.title}`);
  return h(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": `table of ${chart.title}` },
    body,
  );
}

/** Saves all columns of a chart as CSV, with the abscissa and with units in the header. */
export function saveCsv(chart: Chart, abscissa: Abscissa): void {
  const quote = (text: string) => (/[",\n]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text);
  const head = (name: string, unit: string) => quote(unit === "" ? name : `${name} [${unit}]`);
  const names = chart.columns.map((c) => head(c.name, c.unit));
  const rows = abscissa.xs.map((x, row) => [x, ...chart.columns.map((c) => c.values[row])].join(","));
  const text = `${[[head(abscissa.label, abscissa.unit), ...names].join(","), ...rows].join("\n")}\n`;
  const file = `${chart.title.replace(/[^\w-]+/g, "_")}.csv`;
  saveFile(file, new Blob([text], { type: "text/csv" }));
}

/** Unit of a chart for display: that of its largest value. */
export function chartUnit(chart: Chart, columns: number[]) {
  const units = new Set(columns.map((i) => chart.columns[i].unit));
  const [unit] = units;
  const sizes = columns.flatMap((i) => valueRange(chart.columns[i].values) ?? [0]);
  return displayUnit(units.size === 1 ? unit : "", Math.max(0, ...sizes.map(Math.abs)));
}
