// Colour legend: name and unit of the field, colour map, values.

import { cssGradient } from "../base/colours";
import { h } from "../base/dom";
import { formatNumber } from "../base/numbers";
import type { Settings } from "../base/settings";
import { colourScale, legendValues } from "../scene/fields";
import type { Scene } from "../scene/scene";

export class ColourLegend {
  readonly element = h("div", { class: "legend", role: "img" });

  /** Shows the legend of the selected field, or nothing if there is none. */
  show(scene: Scene, settings: Settings): void {
    const field = scene.fields.find((f) => f.name === settings.field);
    this.element.hidden = !field;
    if (!field) return;
    const scale = colourScale(field, settings);
    const values = legendValues(scene, field, scale).map((v) => formatNumber(v, 3));
    const bar = h("div", { class: "bar" });
    bar.style.background = cssGradient(scale.map, "to top");
    const unit = scale.unit.name ? h("span", { class: "unit" }, scale.unit.name) : null;
    this.element.replaceChildren(
      h("div", { class: "name" }, field.name, unit && " ", unit),
      h("div", { class: "scale" }, bar, h("ol", {}, ...values.map((v) => h("li", {}, v)))),
    );
    this.element.setAttribute(
      "aria-label",
      `${field.name} from ${values[4]} to ${values[0]} ${scale.unit.name}`.trim(),
    );
  }
}
