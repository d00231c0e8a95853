// Display options: field of the colours, scale factors, visible objects.

import { MAP_NAMES } from "../base/colours";
import { h } from "../base/dom";
import { formatNumber } from "../base/numbers";
import type { Settings, SettingsStore, Switch } from "../base/settings";
import { colourScale } from "../scene/fields";
import type { Field, Scene } from "../scene/scene";

const SWITCHES: [name: Switch, label: string, key: string][] = [
  ["ghost", "reference configuration", "g"],
  ["labels", "names", "l"],
  ["nodes", "node numbers", "n"],
  ["mesh", "edges of shell elements", "e"],
  ["reactions", "reactions", "r"],
  ["markers", "joints, probes, loads", "m"],
  ["grid", "grid", ""],
  ["shadows", "shadows", ""],
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
  private readonly map = h("select", { "aria-label": "colour map" });
  private readonly limits = ["minimum", "maximum"].map((name) =>
    h("input", { type: "number", step: "any", "aria-label": name, class: "limit" }),
  );
  private readonly limitUnit = h("span", { class: "unit" });
  private readonly switches = new Map<keyof Settings, HTMLInputElement>();
  private scene: Scene | null = null;
  private readonly deformation;
  private readonly thickness;

  constructor(private readonly settings: SettingsStore) {
    this.field.addEventListener("change", () => settings.set("field", this.field.value));
    this.map.append(
      h("option", { value: "" }, "automatic"),
      ...MAP_NAMES.map((name) => h("option", { value: name }, name)),
    );
    this.map.addEventListener("change", () => settings.set("colourMap", this.map.value));
    for (const input of this.limits) input.addEventListener("change", () => this.setLimits());
    const reset = h("button", { type: "button", class: "small", onclick: () => this.resetLimits() }, "Reset");
    this.deformation = logSlider("deformation", [-1, 4], (v) => settings.set("deformation", v));
    this.thickness = logSlider("section size", [-1, 2], (v) => settings.set("thickness", v));
    const boxes = SWITCHES.map(([name, label, key]) => {
      const input = h("input", { type: "checkbox", onchange: () => settings.toggle(name) });
      this.switches.set(name, input);
      return h("label", { class: "check" }, input, label, key ? h("kbd", {}, key) : null);
    });
    this.element.append(
      h("label", { class: "slider-row" }, h("span", {}, "colour by"), this.field),
      h("label", { class: "slider-row" }, h("span", {}, "colour map"), this.map),
      h(
        "div",
        { class: "limits", role: "group", "aria-label": "range of the colours" },
        h("span", {}, "range ", this.limitUnit),
        ...this.limits,
        reset,
      ),
      this.deformation.row,
      this.thickness.row,
      h("div", { class: "checks" }, ...boxes),
    );
    settings.listen(() => this.update());
  }

  private get selectedField(): Field | undefined {
    return this.scene?.fields.find((f) => f.name === this.settings.values.field);
  }

  /** Applies the limits of the inputs, which are in the unit of the legend. An empty one is automatic. */
  private setLimits(): void {
    const field = this.selectedField;
    if (!field) return;
    const { size } = colourScale(field, this.settings.values).unit;
    const [low, high] = this.limits.map(({ value }) => (value === "" ? null : Number(value) * size));
    if (low !== null && high !== null && !(low < high)) {
      this.limits[1].setCustomValidity("The maximum must be above the minimum.");
      this.limits[1].reportValidity();
      return;
    }
    this.limits[1].setCustomValidity("");
    this.settings.set("limits", { ...this.settings.values.limits, [field.name]: [low, high] });
  }

  private resetLimits(): void {
    const { [this.settings.values.field]: _, ...others } = this.settings.values.limits;
    this.settings.set("limits", others);
  }

  /** Shows the limits of the user as values and those of the data as placeholders. */
  private updateLimits(): void {
    const field = this.selectedField;
    const { values } = this.settings;
    for (const input of this.limits) input.disabled = !field;
    if (!field) return;
    const { low, high, unit } = colourScale(field, values);
    this.limitUnit.textContent = unit.name;
    const own = values.limits[field.name] ?? [null, null];
    [low, high].forEach((limit, i) => {
      const text = String(Number((limit / unit.size).toPrecision(4)));
      this.limits[i].value = own[i] === null ? "" : text;
      this.limits[i].placeholder = text;
    });
  }

  /** Offers the fields of the scene, and hides switches of objects that it does not have. */
  load(scene: Scene): void {
    this.scene = scene;
    const options = scene.fields.map((f) => h("option", { value: f.name }, f.name));
    this.field.replaceChildren(h("option", { value: "" }, "body"), ...options);
    const mesh = scene.bodies.filter((body) => body.grid).length;
    const markers = scene.markers.length + scene.supports.length + scene.loads.length;
    const counts = { reactions: scene.reactions.length, markers, mesh };
    for (const [name, input] of this.switches) {
      const box = input.closest("label");
      if (box) box.hidden = name in counts && counts[name as keyof typeof counts] === 0;
    }
    this.update();
  }

  private update(): void {
    const { values } = this.settings;
    this.field.value = values.field;
    this.map.value = values.colourMap;
    this.updateLimits();
    this.deformation.show(values.deformation);
    this.thickness.show(values.thickness);
    for (const [name, input] of this.switches) input.checked = values[name] === true;
  }
}
