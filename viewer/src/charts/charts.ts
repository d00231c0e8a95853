// Charts of probes, energies and the solver, linked to the time of the animation.

import { h } from "../base/dom";
import type { Chart, Scene } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import { ChartFigure, type FigureState } from "./figure";
import { ColumnMagnitudes } from "./magnitudes";
import { SharedMargin } from "./margin";
import { type RankedChart, rankCharts } from "./ranking";
import { constantsText } from "./table";

/** All charts by groups. Only the plots of the selected group exist. */
export class Charts {
  readonly element = h("div", { class: "charts" });
  private readonly groupButtons = h("div", {
    class: "chips",
    role: "group",
    "aria-label": "groups of charts",
  });
  private readonly list = h("div", { class: "list" });
  private figures: ChartFigure[] = [];
  /** Switches of the charts by title. */
  private readonly states = new Map<string, FigureState>();
  private all: Chart[] = [];
  private abscissa: Abscissa | null = null;
  private magnitudes = new ColumnMagnitudes([]);
  private group = "";
  private x: number | null = null;

  constructor(private readonly select: (x: number) => void) {
    this.element.append(this.groupButtons, this.list);
    new ResizeObserver(() => {
      const width = this.list.clientWidth;
      if (width > 0) for (const figure of this.figures) figure.resize(width);
    }).observe(this.list);
  }

  load(scene: Scene, abscissa: Abscissa): void {
    this.abscissa = abscissa;
    this.all = scene.charts;
    this.magnitudes = new ColumnMagnitudes(this.all);
    const groups = [...new Set(this.all.map((c) => c.group))];
    if (!groups.includes(this.group)) this.group = groups[0] ?? "";
    this.groupButtons.replaceChildren(
      ...groups.map((name) =>
        h(
          "button",
          { type: "button", class: "chip", "data-group": name, onclick: () => this.selectGroup(name) },
          name,
        ),
      ),
    );
    this.rebuild();
  }

  private selectGroup(group: string): void {
    this.group = group;
    this.rebuild();
  }

  /** Creates the plots of the selected group in the colours of the theme. */
  rebuild(): void {
    // Read before the figures are removed: a layout without them would reset the scroll position.
    const width = Math.max(200, this.list.clientWidth || 360);
    for (const figure of this.figures) figure.destroy();
    this.figures = [];
    const { abscissa, magnitudes } = this;
    if (!abscissa) return;
    for (const button of this.groupButtons.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.group === this.group));
    }
    const charts = abscissa.xs.length > 0 ? this.all.filter((c) => c.group === this.group) : [];
    const ranking = rankCharts(charts, magnitudes, abscissa.discrete);
    const margin = new SharedMargin();
    const context = { abscissa, magnitudes, margin, select: this.select };
    const figure = (ranked: RankedChart, index: number): ChartFigure =>
      new ChartFigure(ranked, context, this.stateOf(ranked.chart), width, (button) => {
        const next = figure(ranked, index);
        this.figures[index].element.replaceWith(next.element);
        this.figures[index].destroy();
        this.figures[index] = next;
        margin.settle();
        next.show(this.x);
        next.focus(button);
      });
    this.figures = ranking.charts.map(figure);
    margin.settle();
    const none = h("p", { class: "empty" }, "No history was recorded.");
    const elements = this.figures.map((figure) => figure.element);
    this.list.replaceChildren(
      ...(charts.length > 0 ? elements : [none]),
      ...this.constantCharts(ranking.constant),
    );
    this.show(this.x);
  }

  private stateOf({ group, title }: Chart): FigureState {
    const key = `${group}\n${title}`;
    const state = this.states.get(key) ?? { log: false, wholeRange: false, table: false };
    this.states.set(key, state);
    return state;
  }

  /** List of the charts without variation. */
  private constantCharts(charts: Chart[]): HTMLElement[] {
    if (charts.length === 0) return [];
    const items = charts.map((chart) => {
      const all = chart.columns.map((_, i) => i);
      return h("li", {}, h("b", {}, chart.title), `: ${constantsText(chart, all, this.magnitudes)}`);
    });
    const title = charts.length === 1 ? "1 constant quantity" : `${charts.length} constant quantities`;
    return [h("details", { class: "constant" }, h("summary", {}, title), h("ul", {}, ...items))];
  }

  /** Shows the values at `x` in all charts. */
  show(x: number | null): void {
    this.x = x;
    for (const figure of this.figures) figure.show(x);
  }
}
