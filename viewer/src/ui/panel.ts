// Beside the picture: charts, shapes, summary, messages, the model's text.

import { h, save } from "../base/dom";
import type { Charts } from "../charts/charts";
import { isModal, type Scene } from "../scene/scene";

type Tab = "Shapes" | "Charts" | "Run";

export class Panel {
  readonly element = h("aside", { class: "panel", "aria-label": "charts and summary" });
  private readonly tabs = h("div", { class: "tabs", role: "tablist" });
  private readonly shapes = h("div", { class: "shapes" });
  private readonly run = h("div", { class: "run" });
  private readonly bodies: Map<Tab, HTMLElement>;
  private open: Tab | null = null;

  constructor(
    charts: Charts,
    private readonly choose: (frame: number) => void,
  ) {
    this.bodies = new Map<Tab, HTMLElement>([
      ["Shapes", this.shapes],
      ["Charts", charts.element],
      ["Run", this.run],
    ]);
    for (const [name, body] of this.bodies) {
      body.setAttribute("role", "tabpanel");
      body.id = `panel-${name}`;
      const tab = h("button", {
        ...{ type: "button", role: "tab", id: `tab-${name}`, "aria-controls": body.id },
        onclick: () => this.show(name),
      });
      tab.textContent = name;
      body.setAttribute("aria-labelledby", tab.id);
      tab.addEventListener("keydown", (event) => this.arrows(event as KeyboardEvent));
      this.tabs.append(tab);
    }
    this.element.append(this.tabs, ...this.bodies.values());
  }

  load(scene: Scene): void {
    const has: Record<Tab, boolean> = {
      Shapes: isModal(scene) && scene.frames.count > 0,
      Charts: scene.charts.length > 0,
      Run: true,
    };
    for (const tab of this.tabs.querySelectorAll("button")) tab.hidden = !has[tab.textContent as Tab];
    this.shapes.replaceChildren(...this.list(scene));
    const opened = [...this.run.querySelectorAll("details")].map((d) => d.open);
    this.run.replaceChildren(messages(scene), summary(scene), model(scene));
    this.run.querySelectorAll("details").forEach((d, i) => {
      d.open = opened[i] ?? d.open;
    });
    const first = (Object.keys(has) as Tab[]).find((t) => has[t]) ?? "Run";
    this.show(this.open && has[this.open] ? this.open : first);
  }

  /** Marks the shape that is seen. */
  mark(frame: number): void {
    this.shapes.querySelectorAll("button").forEach((b, i) => {
      b.setAttribute("aria-pressed", String(i === frame));
    });
  }

  private show(name: Tab): void {
    this.open = name;
    for (const [tab, body] of this.bodies) body.hidden = tab !== name;
    for (const tab of this.tabs.querySelectorAll("button")) {
      const chosen = tab.textContent === name;
      tab.setAttribute("aria-selected", String(chosen));
      tab.tabIndex = chosen ? 0 : -1;
    }
  }

  private arrows(event: KeyboardEvent): void {
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    const seen = [...this.tabs.querySelectorAll<HTMLElement>("button:not([hidden])")];
    const next = seen[(seen.indexOf(event.target as HTMLElement) + way + seen.length) % seen.length];
    next.focus();
    next.click();
  }

  private list(scene: Scene): HTMLElement[] {
    if (!isModal(scene)) return [];
    const kind = scene.analysis === "buckling" ? "load factor" : "mode";
    return Array.from(scene.frames.values, (value, i) => {
      const label = scene.frames.labels?.[i] ?? `${kind} ${value}`;
      return h("button", { type: "button", class: "shape", onclick: () => this.choose(i) }, label);
    });
  }
}

function messages(scene: Scene): HTMLElement {
  const items = scene.messages.map((m) => h("li", { class: /^error/i.test(m) ? "error" : "" }, m));
  const list =
    items.length > 0 ? h("ul", { class: "messages" }, ...items) : h("p", { class: "empty" }, "No messages.");
  return h("section", {}, h("h3", {}, "Messages"), list);
}

function summary(scene: Scene): HTMLElement {
  const rows = scene.summary.map(([name, value]) =>
    h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value)),
  );
  if (scene.units) {
    const { length, time, force } = scene.units;
    rows.push(h("tr", {}, h("th", { scope: "row" }, "units"), h("td", {}, `${length}, ${time}, ${force}`)));
  }
  if (!scene.summary.some(([name]) => name === "program")) {
    rows.push(h("tr", {}, h("th", { scope: "row" }, "program"), h("td", {}, scene.program)));
  }
  if (scene.sha256) {
    rows.push(
      h("tr", {}, h("th", { scope: "row" }, "model's SHA-256"), h("td", { class: "hash" }, scene.sha256)),
    );
  }
  return h("section", {}, h("h3", {}, "Summary"), h("table", {}, h("tbody", {}, ...rows)));
}

function model(scene: Scene): HTMLElement {
  const copy = h("button", { type: "button", class: "plain" }, "Copy");
  const source = h("pre", { tabindex: 0, "aria-label": "text of the model" }, scene.text);
  copy.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(scene.text);
      copy.textContent = "Copied";
    } catch {
      // Pages from disk may not use the clipboard: the text is selected, one key is left to press.
      getSelection()?.selectAllChildren(source);
      copy.textContent = "Selected: press Ctrl+C";
    }
  });
  const file = `${scene.title.replace(/[^\w-]+/g, "_") || "model"}.toml`;
  const store = () => save(file, new Blob([scene.text], { type: "application/toml" }));
  const keep = h("button", { type: "button", class: "plain", onclick: store }, "Save");
  return h("details", {}, h("summary", {}, "Model"), h("div", { class: "buttons" }, copy, keep), source);
}
