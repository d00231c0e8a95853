// Plot of one chart: curves, a line at the current abscissa, and a legend with the values there.

import uPlot from "uplot";
import { h } from "../base/dom";
import type { Chart } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import { bandHook } from "./bands";
import type { ColumnMagnitudes } from "./magnitudes";
import { commonUnit, fullRange, HEIGHT, plotOptions } from "./options";
import { LinearScale, LogarithmicScale } from "./scales";

export class ChartPlot {
  readonly element: HTMLElement;
  private readonly plot: uPlot;
  /** Line at the current abscissa. */
  private readonly line = h("div", { class: "time-line", "aria-hidden": "true" });
  private readonly container = h("div", { class: "plot" });
  private hovered = false;
  private x: number | null = null;

  constructor(
    chart: Chart,
    magnitudes: ColumnMagnitudes,
    private readonly abscissa: Abscissa,
    select: (x: number) => void,
    width: number,
  ) {
    const scale = chart.log ? new LogarithmicScale(chart) : new LinearScale(chart, magnitudes);
    const coordinates = chart.columns.map((c, i) => Array.from(c.values, (v) => scale.coordinate(v, i)));
    const unit = commonUnit(chart);
    const title = h("h3", {}, chart.title, unit ? h("small", {}, ` ${unit}`) : null);
    const log = chart.log ? h("small", { class: "note" }, "logarithmic") : null;
    const hasBands = chart.columns.some((c) => c.errors);
    const band = hasBands ? h("small", { class: "note" }, "band: ± estimated error") : null;
    this.element = h("figure", { class: "chart" }, h("figcaption", {}, title, log, band), this.container);
    this.element.setAttribute("aria-label", `chart ${chart.title}`);
    // The scales of uPlot are defined after its first drawing. The line is placed then.
    const hooks = { drawAxes: [bandHook(chart, scale)], draw: [() => this.show(this.x)] };
    // The columns of the legend are as wide as its longest entry.
    const longest = Math.max(0, ...chart.columns.map((c) => c.label.length + (unit ? 0 : c.unit.length)));
    this.container.style.setProperty("--entry", `${94 + 7 * longest}px`);
    const options = plotOptions({ chart, abscissa, scale, coordinates }, width);
    this.plot = new uPlot({ ...options, hooks }, [abscissa.xs, ...coordinates], this.container);
    this.plot.over.append(this.line);
    this.listen(select);
  }

  /** Abscissa under the pointer. */
  private abscissaAt(event: MouseEvent): number {
    return this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, "x");
  }

  private listen(select: (x: number) => void): void {
    const { over } = this.plot;
    over.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      over.setPointerCapture(event.pointerId);
      select(this.abscissaAt(event));
    });
    over.addEventListener("pointermove", (event) => {
      this.hovered = true;
      if (event.buttons & 1) select(this.abscissaAt(event));
    });
    over.addEventListener("pointerleave", () => {
      this.hovered = false;
      this.show(this.x);
    });
    over.addEventListener("wheel", (event) => this.zoom(event), { passive: false });
    over.addEventListener("dblclick", () => {
      const [min, max] = fullRange(this.abscissa);
      this.plot.setScale("x", { min, max });
      this.show(this.x);
    });
  }

  /** Zooms about the pointer, with Ctrl and the wheel or with two fingers on a touch pad. */
  private zoom(event: WheelEvent): void {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const { min, max } = this.plot.scales.x;
    const [first, last] = fullRange(this.abscissa);
    if (min == null || max == null) return;
    const x = this.abscissaAt(event);
    const factor = Math.exp(Math.max(-1, Math.min(1, event.deltaY / 200)));
    const low = Math.max(first, x - (x - min) * factor);
    const high = Math.min(last, x + (max - x) * factor);
    if (high > low) this.plot.setScale("x", { min: low, max: high });
    this.show(this.x);
  }

  /** Moves the line to `x`. The legend shows the values there unless the pointer is on the chart. */
  show(x: number | null): void {
    this.x = x;
    const { min, max } = this.plot.scales.x;
    const visible = x !== null && min != null && max != null && x >= min && x <= max;
    this.line.hidden = !visible;
    if (x === null) return;
    if (visible) this.line.style.transform = `translateX(${this.plot.valToPos(x, "x")}px)`;
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
