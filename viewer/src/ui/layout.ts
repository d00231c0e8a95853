// Layout of the page: header, 3-D view with its overlay, transport bar, side panel.

import { h, iconButton } from "../base/dom";
import { ICONS } from "../base/icons";
import type { Scene } from "../scene/scene";

export class PageLayout {
  readonly element: HTMLElement;
  readonly canvas = h("canvas", {
    tabindex: 0,
    "aria-label": "3-D view of the model: drag to rotate, wheel to zoom",
  });
  readonly overlay = h("div", { class: "overlay" });
  /** Buttons at the upper edge of the 3-D view. */
  readonly tools = h("div", { class: "tools", role: "group", "aria-label": "views" });
  /** Buttons in the header of the page. */
  readonly actions = h("div", { class: "actions" });
  private readonly title = h("h1", {}, "ancf");
  private readonly outcome = h("span", { class: "outcome", role: "status" });
  /** Message of a stopped or failed run, or of unreadable data. */
  private readonly banners = h("div", { class: "banners" });
  private readonly connection = h("p", { class: "banner", role: "status", hidden: true });
  private readonly placeholder = h("p", { class: "placeholder", hidden: true });
  private readonly displayButton: HTMLButtonElement;

  constructor(
    panel: HTMLElement,
    transport: HTMLElement,
    private readonly display: HTMLElement,
  ) {
    this.displayButton = iconButton("Display options (d)", ICONS.sliders, () => this.toggleDisplayOptions());
    this.displayButton.setAttribute("aria-controls", display.id);
    this.displayButton.id = "display-button";
    display.hidden = true;
    this.displayButton.setAttribute("aria-expanded", "false");
    this.tools.append(this.displayButton);
    const stage = h(
      "section",
      { class: "stage", "aria-label": "3-D view" },
      this.canvas,
      this.overlay,
      this.tools,
    );
    stage.append(display, this.placeholder);
    const view = h("div", { class: "view" }, stage, transport);
    const heading = h("div", { class: "heading" }, this.title, this.outcome);
    const header = h("header", {}, heading, this.actions);
    const main = h("main", {}, view, panel);
    this.element = h("div", { class: "ancf" }, header, this.banners, this.connection, main);
    (document.getElementById("app") ?? document.body).append(this.element);
  }

  toggleDisplayOptions(): void {
    this.display.hidden = !this.display.hidden;
    this.displayButton.setAttribute("aria-expanded", String(!this.display.hidden));
  }

  /** Shows the title and the outcome of the run. */
  load(scene: Scene): void {
    document.title = scene.title ? `${scene.title} – ancf` : "ancf";
    this.title.textContent = scene.title || "ancf";
    const { kind, message } = scene.outcome;
    this.outcome.textContent = kind;
    this.outcome.dataset.kind = kind;
    if (kind === "failed" || kind === "stopped") this.showBanner(kind, message || `The run has ${kind}.`);
    else this.banners.replaceChildren();
  }

  /** Shows a message below the header, in the colours of an outcome. */
  private showBanner(kind: "failed" | "stopped", message: string): void {
    this.banners.replaceChildren(h("p", { class: `banner ${kind}`, role: "alert" }, message));
  }

  /** Shows a message in place of all content. */
  showError(message: string): void {
    this.element.classList.add("failed");
    this.showBanner("failed", message);
  }

  /** Shows a message in place of the 3-D view, or hides it if empty. */
  showPlaceholder(message: string): void {
    this.placeholder.textContent = message;
    this.placeholder.hidden = message === "";
  }

  /** Shows a message on the connection to the server, or hides it if null. */
  showConnection(message: string | null): void {
    this.connection.textContent = message ?? "";
    this.connection.hidden = message === null;
  }
}
