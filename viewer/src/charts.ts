// Charts of probes, energies and the solver, linked to the time of the picture.

import uPlot from "uplot";
import type { Abscissa } from "./abscissa";
import { css, nth } from "./colours";
import { h, quantity, text } from "./dom";
import type { Chart, Scene } from "./scene";

/** A column as uPlot wants it: null where there is no number, or none that a logarithm has. */
function column(values: ArrayLike<number>, log: boolean): (number | null)[] {
  return Array.from(values, (v) => (Number.isFinite(v) && !(log && v <= 0) ? v : null));
}

function style(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** The unit that all columns share, "" if they differ. */
function commonUnit(chart: Chart): string {
  const first = chart.columns[0]?.unit ?? "";
  return chart.columns.every((c) => c.unit === first) ? first : "";
}

/** One chart: its element, a line at the time, and the values there in the legend. */
class Plot {
  readonly element: HTMLElement;
  private readonly plot: uPlot;
  private readonly line = h("div", { class: "now", "aria-hidden": "true" });
  private readonly place = h("div", { class: "plot" });
  private hovered = false;
  private x: number | null = null;

  constructor(
    chart: Chart,
    private readonly abscissa: Abscissa,
    pick: (x: number) => void,
    width: number,
  ) {
    const unit = commonUnit(chart);
    const title = h("h3", {}, chart.title, unit ? h("small", {}, ` ${unit}`) : null);
    const log = chart.log ? h("small", { class: "note" }, "logarithmic") : null;
    this.element = h("figure", { class: "chart" }, h("figcaption", {}, title, log), this.place);
    this.element.setAttribute("aria-label", `chart ${chart.title}`);
    const data = [abscissa.xs, ...chart.columns.map((c) => column(c.values, chart.log))] as uPlot.AlignedData;
    // uPlot knows its scales only once it has drawn: then the line finds its place.
    const hooks = { draw: [() => this.show(this.x)] };
    this.plot = new uPlot({ ...options(chart, abscissa, width), hooks }, data, this.place);
    this.plot.over.append(this.line);
    this.listen(pick);
  }

  private listen(pick: (x: number) => void): void {
    const { over } = this.plot;
    const at = (event: PointerEvent) =>
      pick(this.plot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    over.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      at(event);
    });
    over.addEventListener("pointermove", (event) => {
      this.hovered = true;
      if (event.buttons & 1) at(event);
    });
    over.addEventListener("pointerleave", () => {
      this.hovered = false;
      this.show(this.x);
    });
    over.addEventListener("wheel", (event) => this.zoom(event), { passive: false });
    over.addEventListener("dblclick", () => {
      const { xs } = this.abscissa;
      this.plot.setScale("x", { min: xs[0], max: xs[xs.length - 1] });
      this.show(this.x);
    });
  }

  /** Wheel with Ctrl, or two fingers on a touch pad: closer to the place under the pointer. */
  private zoom(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const { min, max } = this.plot.scales.x;
    const { xs } = this.abscissa;
    if (min == null || max == null) return;
    const x = this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, "x");
    const factor = Math.exp(Math.max(-1, Math.min(1, event.deltaY / 200)));
    const low = Math.max(xs[0], x - (x - min) * factor);
    const high = Math.min(xs[xs.length - 1], x + (max - x) * factor);
    if (high > low) this.plot.setScale("x", { min: low, max: high });
    this.show(this.x);
  }

  /** Moves the line to `x` and, unless the pointer is on the chart, shows the values there. */
  show(x: number | null): void {
    this.x = x;
    const { min, max } = this.plot.scales.x;
    const seen = x !== null && min != null && max != null && x >= min && x <= max;
    this.line.hidden = !seen;
    if (x === null) return;
    if (seen) this.line.style.transform = `translateX(${this.plot.valToPos(x, "x")}px)`;
    if (!this.hovered) this.plot.setLegend({ idx: this.abscissa.row(x) }, false);
  }

  resize(width: number): void {
    this.plot.setSize({ width, height: HEIGHT });
    this.show(this.x);
  }

  destroy(): void {
    this.plot.destroy();
  }
}

const HEIGHT = 190;

function options(chart: Chart, abscissa: Abscissa, width: number): uPlot.Options {
  const [ink, rule] = [style("--ink-2"), style("--rule")];
  const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 4 } };
  const font = "11px system-ui, sans-serif";
  const numbers = (_: uPlot, ticks: (number | null)[]) => ticks.map((v) => (v == null ? "" : text(v, 5)));
  const common = commonUnit(chart);
  return {
    ...{ width, height: HEIGHT, padding: [8, 14, 0, 0] },
    cursor: { drag: { x: false, y: false }, sync: { key: "ancf" }, points: { size: 6 } },
    scales: { x: { time: false }, y: chart.log ? { distr: 3 } : {} },
    axes: [
      { ...axis, font, size: 26, gap: 4, space: 60, values: numbers },
      { ...axis, font, gap: 4, size: axisWidth, values: chart.log ? logNumbers : numbers },
    ],
    legend: { live: true },
    series: [
      { label: abscissa.label, value: (_, v) => (v == null ? "–" : quantity(v, abscissa.unit)) },
      ...chart.columns.map((c, i) => ({
        label: c.label,
        stroke: css(nth(i)),
        width: 1.6,
        pxAlign: 0,
        points: { show: abscissa.xs.length < 2 },
        value: (_: uPlot, v: number | null) =>
          v == null ? "–" : quantity(v, c.unit === common ? "" : c.unit),
      })),
    ],
  };
}

/** Decades only: the other ticks of a logarithmic axis have no number. */
function logNumbers(_: uPlot, ticks: (number | null)[]): string[] {
  return ticks.map((v) =>
    v != null && Math.abs(Math.log10(v) - Math.round(Math.log10(v))) < 1e-9 ? text(v, 5) : "",
  );
}

function axisWidth(_: uPlot, values: string[] | null): number {
  const longest = Math.max(3, ...(values ?? []).map((v) => v?.length ?? 0));
  return 14 + 6.4 * longest;
}

/** All charts, by groups; only those of the chosen group exist. */
export class Charts {
  readonly element = h("div", { class: "charts" });
  private readonly chips = h("div", { class: "chips", role: "group", "aria-label": "groups of charts" });
  private readonly list = h("div", { class: "list" });
  private plots: Plot[] = [];
  private scene: Scene | null = null;
  private abscissa: Abscissa | null = null;
  private group = "";
  private x: number | null = null;

  constructor(private readonly pick: (x: number) => void) {
    this.element.append(this.chips, this.list);
    new ResizeObserver(() => {
      const width = this.list.clientWidth;
      if (width > 0) for (const plot of this.plots) plot.resize(width);
    }).observe(this.list);
  }

  load(scene: Scene, abscissa: Abscissa): void {
    [this.scene, this.abscissa] = [scene, abscissa];
    const groups = [...new Set(scene.charts.map((c) => c.group))];
    if (!groups.includes(this.group)) this.group = groups[0] ?? "";
    this.chips.replaceChildren(
      ...groups.map((name) =>
        h(
          "button",
          { type: "button", class: "chip", "data-group": name, onclick: () => this.choose(name) },
          name,
        ),
      ),
    );
    this.rebuild();
  }

  choose(group: string): void {
    this.group = group;
    this.rebuild();
  }

  /** Draws anew, in the colours of the theme. */
  rebuild(): void {
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    const { scene, abscissa } = this;
    if (!scene || !abscissa) return;
    for (const chip of this.chips.querySelectorAll("button")) {
      chip.setAttribute("aria-pressed", String(chip.dataset.group === this.group));
    }
    const width = Math.max(200, this.list.clientWidth || 360);
    const charts = abscissa.xs.length > 0 ? scene.charts.filter((c) => c.group === this.group) : [];
    this.plots = charts.map((c) => new Plot(c, abscissa, this.pick, width));
    const none = h("p", { class: "empty" }, "Nothing was recorded over time.");
    this.list.replaceChildren(...(charts.length > 0 ? this.plots.map((p) => p.element) : [none]));
    this.show(this.x);
  }

  show(x: number | null): void {
    this.x = x;
    for (const plot of this.plots) plot.show(x);
  }
}
