// Display options: field of the colours, scale factors, visible objects.

import { h } from "../base/dom";
import { formatNumber } from "../base/numbers";
import type { Settings, SettingsStore, Switch } from "../base/settings";
import type { Scene } from "../scene/scene";

const SWITCHES: [name: Switch, label: string, key: string][] = [
  ["ghost", "reference configuration", "g"],
  ["labels", "names", "l"],
  ["nodes", "node numbers", "n"],
  ["reactions", "reactions", "r"],
  ["markers", "joints, probes, loads", "m"],
  ["grid", "grid", ""],
  ["repeat", "repeat", "o"],
];

/** Creates a slider with a logarithmic scale between two powers of ten. A double click on the value resets it. */
function logSlider(label: string, powers: [number, number], set: (v: number) => void) {
  const output = h("output", {}, "1×");
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
    output.textContent = `${formatNumber(v, 3)}×`;
  };
  input.addEventListener("input", () => set(Number((10 ** Number(input.value)).toPrecision(2))));
  output.addEventListener("dblclick", () => set(1));
  return { row: h("label", { class: "slider-row" }, h("span", {}, label), input, output), show };
}

export class DisplayOptions {
  readonly element = h("div", { class: "display", id: "display" });
  private readonly field = h("select", { "aria-label": "colour by" });
  private readonly switches = new Map<keyof Settings, HTMLInputElement>();
  private readonly deformation;
  private readonly thickness;

  constructor(private readonly settings: SettingsStore) {
    this.field.addEventListener("change", () => settings.set("field", this.field.value));
    this.deformation = logSlider("deformation", [-1, 4], (v) => settings.set("deformation", v));
    this.thickness = logSlider("section size", [-1, 2], (v) => settings.set("thickness", v));
    const boxes = SWITCHES.map(([name, label, key]) => {
      const input = h("input", { type: "checkbox", onchange: () => settings.toggle(name) });
      this.switches.set(name, input);
      return h("label", { class: "check" }, input, label, key ? h("kbd", {}, key) : null);
    });
    this.element.append(
      h("label", { class: "slider-row" }, h("span", {}, "colour by"), this.field),
      this.deformation.row,
      this.thickness.row,
      h("div", { class: "checks" }, ...boxes),
    );
    settings.listen(() => this.update());
  }

  /** Offers the fields of the scene, and hides switches of objects that it does not have. */
  load(scene: Scene): void {
    const options = scene.fields.map((f) => h("option", { value: f.name }, f.name));
    this.field.replaceChildren(h("option", { value: "" }, "body"), ...options);
    const counts = { reactions: scene.reactions.length, markers: scene.markers.length };
    for (const [name, input] of this.switches) {
      const box = input.closest("label");
      if (box) box.hidden = name in counts && counts[name as keyof typeof counts] === 0;
    }
    this.update();
  }

  private update(): void {
    const { values } = this.settings;
    this.field.value = values.field;
    this.deformation.show(values.deformation);
    this.thickness.show(values.thickness);
    for (const [name, input] of this.switches) input.checked = values[name] === true;
  }
}
