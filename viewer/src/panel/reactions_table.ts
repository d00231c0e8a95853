// Tables of the forces and moments of joints in the current state.

import { h } from "../base/dom";
import { formatNumber } from "../base/numbers";
import { displayUnit } from "../base/units";
import type { FrameBlend } from "../scene/blend";
import { largestReactions, vectorAt } from "../scene/reactions";
import type { Numbers, Scene } from "../scene/scene";

/** Relative size below which a component counts as zero. */
const NOISE = 1e-6;

export class ReactionTables {
  readonly element = h("div", { class: "reactions" });
  private readonly heading = h("p", { class: "note" });
  private scene: Scene | null = null;
  /** Cells with the vector that they show, its component (3 for the magnitude) and the reference for noise. */
  private cells: { cell: HTMLElement; vectors: Numbers; component: number; size: number; noise: number }[] =
    [];

  /** Creates the tables of a scene. */
  load(scene: Scene): void {
    this.scene = scene;
    this.cells = [];
    if (scene.reactions.length === 0) {
      this.element.replaceChildren();
      return;
    }
    const { length, force } = scene.units ?? { length: "", force: "" };
    const [largestForce, largestMoment] = largestReactions(scene.reactions);
    this.element.replaceChildren(
      this.heading,
      this.table("Forces", "F", force, largestForce, "force"),
      ...(largestMoment > 0
        ? [this.table("Moments", "M", scene.units ? `${force} ${length}` : "", largestMoment, "moment")]
        : []),
      h("p", { class: "note" }, "Forces and moments act on end a of each joint."),
    );
  }

  private table(
    title: string,
    symbol: string,
    unit: string,
    largest: number,
    key: "force" | "moment",
  ): HTMLElement {
    const { name, size } = displayUnit(unit, largest);
    const heads = ["joint", `|${symbol}|`, `${symbol}x`, `${symbol}y`, `${symbol}z`];
    const rows = (this.scene?.reactions ?? []).map((reaction) => {
      const cells = [3, 0, 1, 2].map((component) => {
        const cell = h("td");
        this.cells.push({ cell, vectors: reaction[key], component, size, noise: NOISE * largest });
        return cell;
      });
      return h("tr", {}, h("th", { scope: "row" }, reaction.name), ...cells);
    });
    const head = h("thead", {}, h("tr", {}, ...heads.map((text) => h("th", { scope: "col" }, text))));
    const table = h("table", {}, head, h("tbody", {}, ...rows));
    const small = name ? h("small", {}, ` ${name}`) : null;
    return h(
      "section",
      { "aria-label": title },
      h("h2", {}, title, small),
      h(
        "div",
        { class: "scroll", tabindex: 0, role: "region", "aria-label": `table of ${title.toLowerCase()}` },
        table,
      ),
    );
  }

  /** Shows the values between two frames. */
  show(blend: FrameBlend, caption: string): void {
    if (this.heading.textContent !== caption) this.heading.textContent = caption;
    for (const { cell, vectors, component, size, noise } of this.cells) {
      const vector = vectorAt(vectors, blend);
      const value = component === 3 ? Math.hypot(...vector) : vector[component];
      const text = formatNumber(Math.abs(value) < noise ? 0 : value / size);
      if (cell.textContent !== text) cell.textContent = text;
    }
  }
}
