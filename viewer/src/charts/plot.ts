// Plot of the curves of a chart that share axes, with a line at the current abscissa and the values there.

import uPlot from "uplot";
import { h } from "../base/dom";
import type { Abscissa } from "./abscissa";
import { bandHook } from "./bands";
import { fullRange, type Panel, plotOptions } from "./options";

/** Height of a panel in CSS pixels: of the only one, and of one of several. */
const HEIGHTS = [206, 150];

/** Curves with common axes, and a legend with their values. */
export class PanelPlot {
  readonly element = h("div", { class: "plot" });
  private readonly plot: uPlot;
  private readonly abscissa: Abscissa;
  /** Line at the current abscissa. */
  private readonly line = h("div", { class: "time-line", "aria-hidden": "true" });
  private readonly height: number;
  private readonly unlisten: () => void;
  private hovered = false;
  private x: number | null = null;

  constructor(panel: Panel, width: number, single: boolean, text: string, select: (x: number) => void) {
    const { chart, columns, abscissa, coordinates, margin } = panel;
    this.abscissa = abscissa;
    this.height = HEIGHTS[single ? 0 : 1];
    // The scales of uPlot are defined after its first drawing. The line is placed then.
    const hooks = { drawAxes: [bandHook(panel)], draw: [() => this.show(this.x)] };
    // The columns of the legend are as wide as its longest entry.
    const longest = Math.max(0, ...columns.map((i) => chart.columns[i].label.length));
    this.element.style.setProperty("--entry", `${100 + 7 * longest}px`);
    const options = plotOptions(panel, width, this.height);
    this.plot = new uPlot({ ...options, hooks }, [abscissa.xs, ...coordinates], this.element);
    this.plot.over.append(this.line);
    this.plot.ctx.canvas.setAttribute("role", "img");
    this.plot.ctx.canvas.setAttribute("aria-label", text);
    this.unlisten = margin.listen(() => this.plot.redraw(false, true));
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
    this.plot.setSize({ width, height: this.height });
    this.show(this.x);
  }

  destroy(): void {
    this.unlisten();
    this.plot.destroy();
  }
}
