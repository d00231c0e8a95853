// What to see: field of the colours, deformation, and what is drawn besides the bodies.

import { h, text } from "../base/dom";
import type { Choice, Settings } from "../base/settings";
import type { Scene } from "../scene/scene";

const SWITCHES: [
  name: "ghost" | "labels" | "nodes" | "reactions" | "markers" | "grid" | "repeat",
  text: string,
  key: string,
][] = [
  ["ghost", "reference shape", "g"],
  ["labels", "names", "l"],
  ["nodes", "node numbers", "n"],
  ["reactions", "reactions", "r"],
  ["markers", "joints and probes", "m"],
  ["grid", "grid", ""],
  ["repeat", "repeat the film", "o"],
];

/** A slider over powers of ten. */
function logSlider(label: string, powers: [number, number], set: (v: number) => void) {
  const out = h("output", {}, "1×");
  const input = h("input", {
    type: "range",
    min: powers[0],
    max: powers[1],
    step: 0.02,
    value: 0,
    "aria-label": label,
  });
  const show = (v: number) => {
    input.value = String(Math.log10(v));
    out.textContent = `${text(v, 3)}×`;
  };
  input.addEventListener("input", () => set(Number((10 ** Number(input.value)).toPrecision(2))));
  out.addEventListener("dblclick", () => set(1));
  return { row: h("label", { class: "slide" }, h("span", {}, label), input, out), show };
}

export class Display {
  readonly element = h("div", { class: "display", id: "display" });
  private readonly field = h("select", { "aria-label": "colour by" });
  private readonly switches = new Map<keyof Settings, HTMLInputElement>();
  private readonly deformation;
  private readonly thickness;

  constructor(private readonly choice: Choice) {
    this.field.addEventListener("change", () => choice.set("field", this.field.value));
    this.deformation = logSlider("deformation", [-1, 4], (v) => choice.set("deformation", v));
    this.thickness = logSlider("section size", [-1, 2], (v) => choice.set("thickness", v));
    const boxes = SWITCHES.map(([name, words, key]) => {
      const input = h("input", { type: "checkbox", onchange: () => choice.toggle(name) });
      this.switches.set(name, input);
      return h("label", { class: "check" }, input, words, key ? h("kbd", {}, key) : null);
    });
    this.element.append(
      h("label", { class: "slide" }, h("span", {}, "colour by"), this.field),
      this.deformation.row,
      this.thickness.row,
      h("div", { class: "checks" }, ...boxes),
    );
    choice.listen(() => this.show());
  }

  load(scene: Scene): void {
    const options = scene.fields.map((f) => h("option", { value: f.name }, f.name));
    this.field.replaceChildren(h("option", { value: "" }, "body"), ...options);
    const has = { reactions: scene.reactions.length, markers: scene.markers.length };
    for (const [name, input] of this.switches) {
      const box = input.closest("label");
      if (box) box.hidden = name in has && has[name as keyof typeof has] === 0;
    }
    this.show();
  }

  private show(): void {
    const { values } = this.choice;
    this.field.value = values.field;
    this.deformation.show(values.deformation);
    this.thickness.show(values.thickness);
    for (const [name, input] of this.switches) input.checked = values[name] === true;
  }
}
