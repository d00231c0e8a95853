// Side panel with tabs: shapes, charts, summary of the run.

import { h } from "../base/dom";
import type { Charts } from "../charts/charts";
import type { FrameBlend } from "../scene/blend";
import { isModal, type Scene } from "../scene/scene";
import { ReactionTables } from "./reactions_table";
import { messageList, modelText, summaryTable } from "./summary";

type Tab = "Shapes" | "Charts" | "Reactions" | "Run";

export class SidePanel {
  readonly element = h("aside", { class: "panel", "aria-label": "charts and summary" });
  private readonly tabs = h("div", { class: "tabs", role: "tablist" });
  private readonly shapes = h("div", { class: "shapes" });
  private readonly reactions = new ReactionTables();
  private readonly run = h("div", { class: "run" });
  private readonly contents: Map<Tab, HTMLElement>;
  private selected: Tab | null = null;

  constructor(
    charts: Charts,
    private readonly selectShape: (frame: number) => void,
    /** Called after the selection of a tab. */
    private readonly changed: () => void,
  ) {
    this.contents = new Map<Tab, HTMLElement>([
      ["Shapes", this.shapes],
      ["Charts", charts.element],
      ["Reactions", this.reactions.element],
      ["Run", this.run],
    ]);
    for (const [name, content] of this.contents) {
      content.setAttribute("role", "tabpanel");
      content.id = `panel-${name}`;
      const tab = h("button", {
        ...{ type: "button", role: "tab", id: `tab-${name}`, "aria-controls": content.id },
        onclick: () => {
          this.select(name);
          this.changed();
        },
      });
      tab.textContent = name;
      content.setAttribute("aria-labelledby", tab.id);
      tab.addEventListener("keydown", (event) => this.moveFocus(event as KeyboardEvent));
      this.tabs.append(tab);
    }
    this.element.append(this.tabs, ...this.contents.values());
  }

  load(scene: Scene): void {
    const available: Record<Tab, boolean> = {
      Shapes: isModal(scene) && scene.frames.count > 0,
      Charts: scene.charts.length > 0,
      Reactions: scene.reactions.length > 0,
      Run: true,
    };
    this.reactions.load(scene);
    for (const tab of this.tabs.querySelectorAll("button")) tab.hidden = !available[tab.textContent as Tab];
    this.shapes.replaceChildren(...this.shapeButtons(scene));
    const opened = [...this.run.querySelectorAll("details")].map((d) => d.open);
    this.run.replaceChildren(messageList(scene), summaryTable(scene), modelText(scene));
    this.run.querySelectorAll("details").forEach((d, i) => {
      d.open = opened[i] ?? d.open;
    });
    // The result of statics is its last state.
    const order: Tab[] = scene.analysis === "statics" ? ["Reactions", "Charts"] : ["Shapes", "Charts"];
    const first = order.find((t) => available[t]) ?? "Run";
    this.select(this.selected && available[this.selected] ? this.selected : first);
  }

  /** Marks the button of the current shape, and shows the reactions between two frames. */
  show(frame: number, blend: FrameBlend, caption: string): void {
    if (this.selected === "Reactions") this.reactions.show(blend, caption);
    if (this.selected !== "Shapes") return;
    for (const button of this.shapes.querySelectorAll("button")) {
      const current = button.dataset.frame === String(frame);
      const folded = button.closest("details");
      if (current && folded && button.getAttribute("aria-pressed") !== "true") folded.open = true;
      button.setAttribute("aria-pressed", String(current));
    }
  }

  private select(name: Tab): void {
    this.selected = name;
    for (const [tab, content] of this.contents) content.hidden = tab !== name;
    for (const tab of this.tabs.querySelectorAll("button")) {
      const selected = tab.textContent === name;
      tab.setAttribute("aria-selected", String(selected));
      tab.tabIndex = selected ? 0 : -1;
    }
  }

  /** Selects the next or previous tab with the arrow keys. */
  private moveFocus(event: KeyboardEvent): void {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const visible = [...this.tabs.querySelectorAll<HTMLElement>("button:not([hidden])")];
    const index = visible.indexOf(event.target as HTMLElement) + step;
    const next = visible[(index + visible.length) % visible.length];
    next.focus();
    next.click();
  }

  private shapeButtons(scene: Scene): HTMLElement[] {
    if (!isModal(scene)) return [];
    const kind = scene.analysis === "buckling" ? "load factor" : "mode";
    const buttons = Array.from(scene.frames.values, (value, i) => {
      const label = scene.frames.labels?.[i] ?? `${kind} ${value}`;
      return h(
        "button",
        { type: "button", class: "shape-button", "data-frame": i, onclick: () => this.selectShape(i) },
        label,
      );
    });
    const isRigid = (_: HTMLElement, i: number) => scene.frames.labels?.[i].endsWith(": rigid") ?? false;
    const rigid = buttons.filter(isRigid);
    if (rigid.length === 0 || rigid.length === buttons.length) return buttons;
    const title = rigid.length === 1 ? "1 rigid-body mode" : `${rigid.length} rigid-body modes`;
    const folded = h("details", { class: "rigid-modes" }, h("summary", {}, title), ...rigid);
    return [folded, ...buttons.filter((b, i) => !isRigid(b, i))];
  }
}
