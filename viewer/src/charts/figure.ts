// Figure of a chart: title, switches, plots, unchanging columns, table.

import { h } from "../base/dom";
import type { Chart } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import type { ColumnMagnitudes } from "./magnitudes";
import type { SharedMargin } from "./margin";
import type { Panel } from "./options";
import { PanelPlot } from "./plot";
import type { RankedChart } from "./ranking";
import { LinearScale, LogarithmicScale, rangeWithoutSpike } from "./scales";
import { chartUnit, constantsText, description, extremesTable, saveCsv } from "./table";

/** Parts of the panel of charts that all figures share. */
export interface FigureContext {
  abscissa: Abscissa;
  magnitudes: ColumnMagnitudes;
  margin: SharedMargin;
  /** Moves the animation to an abscissa. */
  select: (x: number) => void;
}

/** Switches of a chart, which updates of a live run keep. */
export interface FigureState {
  log: boolean;
  /** True if a spike at the start determines the vertical range. */
  wholeRange: boolean;
  /** True if the table is open. */
  table: boolean;
}

export class ChartFigure {
  readonly element = h("figure", { class: "chart" });
  private readonly plots: PanelPlot[] = [];
  private readonly logarithmic: boolean;
  private readonly chart: Chart;

  constructor(
    private readonly ranked: RankedChart,
    private readonly context: FigureContext,
    private readonly state: FigureState,
    width: number,
    /** Creates the figure again after a change of a switch. */
    changed: (button: string) => void,
  ) {
    this.logarithmic = ranked.chart.log || state.log;
    this.chart = { ...ranked.chart, log: this.logarithmic };
    const panels = ranked.panels.map((columns) => this.panel(columns));
    const reduced = panels.some((panel) => panel.reduced() !== null);
    for (const [i, panel] of panels.entries()) {
      const text = description(this.chart, panel.columns, context.magnitudes);
      const plot = new PanelPlot(panel, width, panels.length === 1, text, context.select);
      if (panels.length > 1) plot.element.prepend(h("div", { class: "panel-unit" }, panel.unit.name));
      if (i > 0) plot.element.classList.add("further");
      this.plots.push(plot);
    }
    const units = [...new Set(panels.map((panel) => panel.unit.name))];
    const unit = panels.length === 1 && units[0] ? h("small", {}, ` ${units[0]}`) : null;
    const title = h("h2", {}, this.chart.title, unit);
    this.element.append(
      h("figcaption", {}, title, this.tools(changed)),
      ...this.notes(reduced),
      ...this.plots.map((plot) => plot.element),
      ...this.constants(),
      extremesTable(this.chart, context, state),
    );
    this.element.setAttribute("aria-label", `chart ${this.chart.title}`);
  }

  private panel(columns: number[]): Panel {
    const { chart } = this;
    const { abscissa, magnitudes, margin } = this.context;
    const drawn = { ...chart, columns: columns.map((i) => chart.columns[i]) };
    const absolute = this.state.log && drawn.columns.some((c) => c.values.some((x) => x < 0));
    const scale = this.logarithmic
      ? new LogarithmicScale(drawn, absolute)
      : new LinearScale(drawn, magnitudes);
    const own = (column: number) => columns.indexOf(column);
    const coordinates = drawn.columns.map((c, i) => Array.from(c.values, (v) => scale.coordinate(v, i)));
    const spiky = !this.logarithmic && !abscissa.discrete && !this.state.wholeRange;
    const range = spiky ? rangeWithoutSpike(abscissa.xs, coordinates) : null;
    return {
      ...{ chart, columns, abscissa, coordinates, margin },
      unit: chartUnit(chart, columns),
      scale: {
        coordinate: (x, column) => scale.coordinate(x, own(column)),
        displayed: (x, column) => scale.displayed(x, own(column)),
        value: (coordinate) => scale.value(coordinate),
        range: (low, high) => scale.range(low, high),
      },
      reduced: () => range,
    };
  }

  /** Buttons of the figure. */
  private tools(changed: (button: string) => void): HTMLElement {
    const { chart, state } = this;
    const button = (name: string, pressed: boolean | null, onclick: () => void) => {
      const attributes = pressed === null ? {} : { "aria-pressed": String(pressed) };
      return h("button", { type: "button", class: "small", onclick, ...attributes }, name);
    };
    const toggle = (name: "log" | "wholeRange", text: string) => () => {
      state[name] = !state[name];
      changed(text);
    };
    const hasSpike = this.hasSpike();
    return h(
      "span",
      { class: "chart-tools" },
      this.ranked.chart.log ? null : button("Log", state.log, toggle("log", "Log")),
      hasSpike ? button("Full range", state.wholeRange, toggle("wholeRange", "Full range")) : null,
      button("CSV", null, () => saveCsv(chart, this.context.abscissa)),
    );
  }

  /** True if the range of the axes can be reduced. */
  private hasSpike(): boolean {
    const { abscissa } = this.context;
    if (this.logarithmic || abscissa.discrete) return false;
    const values = (i: number) =>
      Array.from(this.chart.columns[i].values, (x) => (Number.isFinite(x) ? x : null));
    return this.ranked.panels.some((columns) => rangeWithoutSpike(abscissa.xs, columns.map(values)) !== null);
  }

  private notes(reduced: boolean): HTMLElement[] {
    const { chart, ranked } = this;
    const texts = [
      this.logarithmic ? (ranked.chart.log ? "logarithmic" : "logarithm of magnitudes") : "",
      chart.columns.some((c) => c.errors) ? "band: ± estimated error" : "",
      reduced ? "spike at the start cut off" : "",
    ].filter((text) => text !== "");
    return texts.length > 0 ? [h("p", { class: "note" }, texts.join("; "))] : [];
  }

  private constants(): HTMLElement[] {
    const { constant } = this.ranked;
    if (constant.length === 0) return [];
    const text = constantsText(this.chart, constant, this.context.magnitudes);
    return text === "" ? [] : [h("p", { class: "note" }, `constant: ${text}`)];
  }

  show(x: number | null): void {
    for (const plot of this.plots) plot.show(x);
  }

  resize(width: number): void {
    for (const plot of this.plots) plot.resize(width);
  }

  /** Moves the focus to the button with a text. */
  focus(text: string): void {
    for (const button of this.element.querySelectorAll("button")) {
      if (button.textContent === text) button.focus();
    }
  }

  destroy(): void {
    for (const plot of this.plots) plot.destroy();
  }
}
