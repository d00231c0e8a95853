// Charts of probes, energies and the solver, linked to the time of the animation.

import { h } from "../base/dom";
import type { Scene } from "../scene/scene";
import type { Abscissa } from "./abscissa";
import { ColumnMagnitudes } from "./magnitudes";
import { ChartPlot } from "./plot";

/** All charts by groups. Only the plots of the selected group exist. */
export class Charts {
  readonly element = h("div", { class: "charts" });
  private readonly groupButtons = h("div", {
    class: "chips",
    role: "group",
    "aria-label": "groups of charts",
  });
  private readonly list = h("div", { class: "list" });
  private plots: ChartPlot[] = [];
  private scene: Scene | null = null;
  private abscissa: Abscissa | null = null;
  private magnitudes = new ColumnMagnitudes([]);
  private group = "";
  private x: number | null = null;

  constructor(private readonly select: (x: number) => void) {
    this.element.append(this.groupButtons, this.list);
    new ResizeObserver(() => {
      const width = this.list.clientWidth;
      if (width > 0) for (const plot of this.plots) plot.resize(width);
    }).observe(this.list);
  }

  load(scene: Scene, abscissa: Abscissa): void {
    [this.scene, this.abscissa] = [scene, abscissa];
    this.magnitudes = new ColumnMagnitudes(scene.charts);
    const groups = [...new Set(scene.charts.map((c) => c.group))];
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
    for (const plot of this.plots) plot.destroy();
    this.plots = [];
    const { scene, abscissa } = this;
    if (!scene || !abscissa) return;
    for (const button of this.groupButtons.querySelectorAll("button")) {
      button.setAttribute("aria-pressed", String(button.dataset.group === this.group));
    }
    const width = Math.max(200, this.list.clientWidth || 360);
    const charts = abscissa.xs.length > 0 ? scene.charts.filter((c) => c.group === this.group) : [];
    this.plots = charts.map((c) => new ChartPlot(c, this.magnitudes, abscissa, this.select, width));
    const none = h("p", { class: "empty" }, "No history was recorded.");
    this.list.replaceChildren(...(charts.length > 0 ? this.plots.map((p) => p.element) : [none]));
    this.show(this.x);
  }

  /** Shows the values at `x` in all charts. */
  show(x: number | null): void {
    this.x = x;
    for (const plot of this.plots) plot.show(x);
  }
}
