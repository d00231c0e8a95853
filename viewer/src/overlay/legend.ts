// Colour legend: name and unit of the field, colour map, values.

import { cssGradient } from "../base/colours";
import { h } from "../base/dom";
import { formatNumber } from "../base/numbers";
import { legendValues } from "../scene/fields";
import type { Scene } from "../scene/scene";

export class ColourLegend {
  readonly element = h("div", { class: "legend", role: "img" });

  /** Shows the legend of a field, or nothing if there is no such field. */
  show(scene: Scene, name: string): void {
    const field = scene.fields.find((f) => f.name === name);
    this.element.hidden = !field;
    if (!field) return;
    const values = legendValues(scene, field).map((v) => formatNumber(v, 3));
    const bar = h("div", { class: "bar" });
    bar.style.background = cssGradient(field.diverging, "to top");
    const unit = field.unit ? h("span", { class: "unit" }, field.unit) : null;
    this.element.replaceChildren(
      h("div", { class: "name" }, field.name, unit),
      h("div", { class: "scale" }, bar, h("ol", {}, ...values.map((v) => h("li", {}, v)))),
    );
    this.element.setAttribute("aria-label", `${field.name} from ${values[4]} to ${values[0]} ${field.unit}`);
  }
}
