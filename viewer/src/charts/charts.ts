// Charts of probes, energies and the solver, linked to the time of the picture.

import uPlot from "uplot";
import { css, nth } from "../base/colours";
import { h, quantity, text } from "../base/dom";
import type { Chart, Scene } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import {
  around,
  decades,
  digits,
  isolated,
  Kinds,
  Linear,
  Logarithmic,
  type Range,
  type Scale,
} from "./scales";

type Places = (number | null)[];

/** A chart with what stands below it and how its numbers are drawn. */
interface Drawn {
  chart: Chart;
  abscissa: Abscissa;
  scale: Scale;
  /** One list for each column. */
  places: Places[];
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
    kinds: Kinds,
    private readonly abscissa: Abscissa,
    pick: (x: number) => void,
    width: number,
  ) {
    const scale = chart.log ? new Logarithmic(chart) : new Linear(chart, kinds);
    const places = chart.columns.map((c, i) => Array.from(c.values, (v) => scale.place(v, i)));
    const unit = commonUnit(chart);
    const title = h("h3", {}, chart.title, unit ? h("small", {}, ` ${unit}`) : null);
    const log = chart.log ? h("small", { class: "note" }, "logarithmic") : null;
    this.element = h("figure", { class: "chart" }, h("figcaption", {}, title, log), this.place);
    this.element.setAttribute("aria-label", `chart ${chart.title}`);
    // uPlot knows its scales only once it has drawn: then the line finds its place.
    const hooks = { draw: [() => this.show(this.x)] };
    // Legends stand in columns that are as wide as the longest entry.
    const longest = Math.max(0, ...chart.columns.map((c) => c.label.length + (unit ? 0 : c.unit.length)));
    this.place.style.setProperty("--entry", `${94 + 7 * longest}px`);
    const drawn = { chart, abscissa, scale, places };
    this.plot = new uPlot({ ...options(drawn, width), hooks }, [abscissa.xs, ...places], this.place);
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
      const [min, max] = whole(this.abscissa);
      this.plot.setScale("x", { min, max });
      this.show(this.x);
    });
  }

  /** Wheel with Ctrl, or two fingers on a touch pad: closer to the place under the pointer. */
  private zoom(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const { min, max } = this.plot.scales.x;
    const [first, last] = whole(this.abscissa);
    if (min == null || max == null) return;
    const x = this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, "x");
    const factor = Math.exp(Math.max(-1, Math.min(1, event.deltaY / 200)));
    const low = Math.max(first, x - (x - min) * factor);
    const high = Math.min(last, x + (max - x) * factor);
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

const HEIGHT = 206;

/** All of the horizontal axis. */
function whole({ xs, discrete }: Abscissa): Range {
  const [low, high] = [xs[0] ?? 0, xs[xs.length - 1] ?? 1];
  if (discrete) return [low - 0.5, high + 0.5];
  return high > low ? [low, high] : around(low, high, 0);
}

/** Whether a range of the horizontal axis is another than that of all rows. */
function zoomed({ xs }: Abscissa, low: number, high: number): boolean {
  return xs.length > 1 && high > low && !(low === xs[0] && high === xs[xs.length - 1]);
}

function options(drawn: Drawn, width: number): uPlot.Options {
  const { chart, abscissa, scale } = drawn;
  const [ink, rule] = [style("--ink-2"), style("--rule")];
  const axis = { stroke: ink, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 4 } };
  const font = "11px system-ui, sans-serif";
  const along = (_: uPlot, ticks: Places) => numbers(ticks);
  const up = (_: uPlot, ticks: Places) => numbers(ticks.map((v) => (v == null ? null : scale.at(v))));
  const label = abscissa.unit ? `${abscissa.label} [${abscissa.unit}]` : abscissa.label;
  const splits = (_: uPlot, __: number, low: number, high: number) => decades(low, high);
  return {
    ...{ width, height: HEIGHT, padding: [8, 14, 0, 0] },
    cursor: { drag: { x: false, y: false }, sync: { key: "ancf" }, points: { size: 6 } },
    scales: {
      x: {
        time: false,
        range: (_, low, high) => (zoomed(abscissa, low, high) ? [low, high] : whole(abscissa)),
      },
      y: { range: (_, low, high) => scale.range(low, high) },
    },
    axes: [
      {
        ...{ ...axis, font, size: 24, gap: 4, space: abscissa.discrete ? 28 : 60, values: along },
        ...{ label, labelSize: 16, labelGap: 0, labelFont: font },
        ...(abscissa.discrete ? { incrs: [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] } : {}),
      },
      { ...axis, font, gap: 4, size: axisWidth, values: up, ...(chart.log ? { splits } : {}) },
    ],
    legend: { live: true },
    series: [
      { label: abscissa.label, value: (_, v) => (v == null ? "–" : quantity(v, abscissa.unit)) },
      ...chart.columns.map((_, i) => series(drawn, i)),
    ],
  };
}

/** A line, or points where nothing lies between the rows. */
function series({ chart, abscissa, scale, places }: Drawn, index: number): uPlot.Series {
  const { label, unit, values } = chart.columns[index];
  const stroke = css(nth(index));
  const alone = isolated(places[index]);
  const points = abscissa.discrete
    ? { show: true, size: 7, fill: stroke }
    : { show: false, size: 4, fill: stroke, filter: () => alone };
  const common = commonUnit(chart);
  return {
    ...{ label, stroke, width: 1.6, pxAlign: 0, points },
    ...(abscissa.discrete ? { paths: () => null } : {}),
    value: (_, __, ___, row) => {
      const value = row == null ? Number.NaN : scale.shown(values[row], index);
      return Number.isNaN(value) ? "–" : quantity(value, unit === common ? "" : unit);
    },
  };
}

/** Ticks as text, with as many digits as tell them apart. */
function numbers(ticks: Places): string[] {
  const [a, b] = ticks.filter((v) => v != null);
  const count = digits(ticks, Math.abs((b ?? a ?? 0) - (a ?? 0)));
  return ticks.map((v) => (v == null ? "" : text(v, count)));
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
  private kinds = new Kinds([]);
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
    this.kinds = new Kinds(scene.charts);
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
    this.plots = charts.map((c) => new Plot(c, this.kinds, abscissa, this.pick, width));
    const none = h("p", { class: "empty" }, "Nothing was recorded over time.");
    this.list.replaceChildren(...(charts.length > 0 ? this.plots.map((p) => p.element) : [none]));
    this.show(this.x);
  }

  show(x: number | null): void {
    this.x = x;
    for (const plot of this.plots) plot.show(x);
  }
}
