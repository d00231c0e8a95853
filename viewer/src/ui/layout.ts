// The page: header, picture with its overlay, player, panel.

import { h, iconButton } from "../base/dom";
import { ICONS } from "../base/icons";
import type { Scene } from "../scene/scene";

const OUTCOMES = { finished: "finished", stopped: "stopped", failed: "failed", running: "running" };

export class Layout {
  readonly element: HTMLElement;
  readonly canvas = h("canvas", {
    tabindex: 0,
    "aria-label": "picture of the model: drag to turn, wheel to zoom",
  });
  readonly overlay = h("div", { class: "overlay" });
  readonly banner = h("div", { class: "banners" });
  /** Buttons at the upper edge of the picture, and of the page. */
  readonly tools = h("div", { class: "tools", role: "group", "aria-label": "views" });
  readonly actions = h("div", { class: "actions" });
  private readonly title = h("h1", {}, "ancf");
  private readonly chip = h("span", { class: "outcome", role: "status" });
  private readonly note = h("p", { class: "nothing", hidden: true });
  private readonly trouble_ = h("p", { class: "banner", role: "status", hidden: true });

  constructor(panel: HTMLElement, transport: HTMLElement, display: HTMLElement) {
    const fold = iconButton("What to see (d)", ICONS.sliders, () => this.unfold());
    fold.setAttribute("aria-controls", display.id);
    fold.id = "unfold";
    display.hidden = true;
    fold.setAttribute("aria-expanded", "false");
    this.tools.append(fold);
    const stage = h(
      "section",
      { class: "stage", "aria-label": "picture" },
      this.canvas,
      this.overlay,
      this.tools,
    );
    stage.append(display, this.note);
    const view = h("div", { class: "view" }, stage, transport);
    const head = h("header", {}, h("div", { class: "heading" }, this.title, this.chip), this.actions);
    const main = h("main", {}, view, panel);
    this.element = h("div", { class: "ancf" }, head, this.banner, this.trouble_, main);
    (document.getElementById("app") ?? document.body).append(this.element);
  }

  unfold(): void {
    const display = this.element.querySelector<HTMLElement>("#display");
    if (!display) return;
    display.hidden = !display.hidden;
    this.element.querySelector("#unfold")?.setAttribute("aria-expanded", String(!display.hidden));
  }

  load(scene: Scene): void {
    document.title = scene.title ? `${scene.title} – ancf` : "ancf";
    this.title.textContent = scene.title || "ancf";
    const { kind, message } = scene.outcome;
    this.chip.textContent = OUTCOMES[kind] ?? kind;
    this.chip.dataset.kind = kind;
    const bad = kind === "failed" || kind === "stopped";
    const words = message || `The run has ${kind}.`;
    const banner = h("p", { class: `banner ${kind}`, role: "alert" }, words);
    this.banner.replaceChildren(...(bad ? [banner] : []));
  }

  /** A sentence instead of the picture; none if empty. */
  say(sentence: string): void {
    this.note.textContent = sentence;
    this.note.hidden = sentence === "";
  }

  /** A sentence below the header; none if null. */
  trouble(sentence: string | null): void {
    this.trouble_.textContent = sentence ?? "";
    this.trouble_.hidden = sentence === null;
  }
}
