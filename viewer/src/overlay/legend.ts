// What the colours mean: the map, its range and unit.

import { gradient, span } from "../base/colours";
import { h, text } from "../base/dom";
import { clean, largest } from "../charts/scales";
import type { Field, Scene } from "../scene/scene";

export class Legend {
  readonly element = h("div", { class: "legend", role: "img" });

  show(scene: Scene, name: string): void {
    const field = scene.fields.find((f) => f.name === name);
    this.element.hidden = !field;
    if (!field) return;
    const values = ticks(scene, field);
    const bar = h("div", { class: "bar" });
    bar.style.background = gradient(field.diverging, "to top");
    const unit = field.unit ? h("span", { class: "unit" }, field.unit) : null;
    this.element.replaceChildren(
      h("div", { class: "name" }, field.name, unit),
      h("div", { class: "scale" }, bar, h("ol", {}, ...values.map((v) => h("li", {}, text(v, 3))))),
    );
    this.element.setAttribute(
      "aria-label",
      `${field.name} from ${text(values[4], 3)} to ${text(values[0], 3)} ${field.unit}`,
    );
  }
}

/** Five values from the top of the map to its bottom, without rounding noise. */
export function ticks(scene: Scene, field: Field): number[] {
  const like = scene.fields.filter((f) => f === field || (f.unit === field.unit && f.unit !== ""));
  const most = Math.max(...like.map((f) => largest(f.range)));
  const [low, high] = span(field.range, field.diverging);
  const at = (i: number) => (field.diverging && i === 2 ? 0 : high + (i / 4) * (low - high));
  return [0, 1, 2, 3, 4].map((i) => clean(at(i), most));
}
