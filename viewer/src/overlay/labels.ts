// Placement of labels over the 3-D view, without overlaps.

import { h } from "../base/dom";
import type { Viewport } from "../draw/viewport";
import { candidateLabels, type Label, type LabelKind, type LabelSource } from "./candidates";

/** Upper limit on the number of labels. */
const MAX_LABELS = 120;
/** Size of the cells that record the occupied area, in pixels. */
const CELL = 8;
/** Height of a line in pixels. */
const LINE = 18;
/** Upper limit on the downward shift of a reaction label, in lines. */
const MAX_SHIFT = 5;

/** Text and its upper left corner. */
type Placement = [text: string, x: number, y: number];

export class Labels {
  readonly element = h("div", { class: "labels", "aria-hidden": "true" });
  private readonly pool: HTMLElement[] = [];
  private readonly widths = new Map<string, number>();

  constructor(private readonly viewport: Viewport) {}

  draw(source: LabelSource): void {
    const { width, height } = this.viewport;
    const occupied = new Set<number>();
    let shown = 0;
    for (const label of candidateLabels(source)) {
      if (shown >= MAX_LABELS) break;
      const point = this.viewport.project(label.position);
      if (!point || point[0] < 0 || point[1] < 0 || point[0] > width || point[1] > height) continue;
      const free = this.placements(label, point).find((p) => this.occupy(occupied, p));
      if (free) this.show(shown++, label.kind, free);
    }
    for (let i = shown; i < this.pool.length; i++) this.pool[i].hidden = true;
  }

  /** Possible placements of a label, the best first. Reactions may be moved and split into two lines. */
  private placements(label: Label, point: [number, number]): Placement[] {
    const place = (text: string): Placement => [
      text,
      ...corner(label.kind, point, this.width(text), this.viewport.width),
    ];
    const single = place(label.lines.join(", "));
    if (label.kind !== "reaction") return [single];
    const text = label.lines.join("\n");
    const [, x, y] = place(text);
    const left = point[0] - this.width(text) - 10;
    const list = [single];
    for (let i = 0; i <= MAX_SHIFT; i++) {
      list.push([text, x, y + i * LINE]);
      if (left > 0) list.push([text, left, y + i * LINE]);
    }
    return list;
  }

  private show(index: number, kind: LabelKind, [text, x, y]: Placement): void {
    let element = this.pool[index];
    if (!element) {
      element = h("span");
      this.pool.push(element);
      this.element.append(element);
    }
    element.hidden = false;
    if (element.textContent !== text) element.textContent = text;
    element.className = kind;
    element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  /** Estimated width of a text in pixels. */
  private width(text: string): number {
    const known = this.widths.get(text);
    if (known !== undefined) return known;
    const width = 12 + 6.6 * Math.max(...text.split("\n").map((line) => line.length));
    if (this.widths.size > 5000) this.widths.clear();
    this.widths.set(text, width);
    return width;
  }

  /** Occupies the cells under a label. Returns false, without a change, if one of them is occupied. */
  private occupy(occupied: Set<number>, [text, x, y]: Placement): boolean {
    const [width, height] = [this.width(text), LINE * text.split("\n").length];
    const cells: number[] = [];
    for (let i = Math.floor(x / CELL); i <= (x + width) / CELL; i++) {
      for (let j = Math.floor(y / CELL); j <= (y + height) / CELL; j++) {
        const cell = i * 4096 + j;
        if (occupied.has(cell)) return false;
        cells.push(cell);
      }
    }
    for (const cell of cells) occupied.add(cell);
    return true;
  }
}

/** Upper left corner of a label beside its point, within the width of the view. */
function corner(kind: LabelKind, [x, y]: [number, number], width: number, limit: number): [number, number] {
  const left = x + width + 14 > limit ? x - width - 10 : x + 10;
  if (kind === "marker") return [left, y - 22];
  if (kind === "reaction") return [left, y + 6];
  if (kind === "body") return [Math.max(2, x - width / 2), y - 34];
  return [x + 4, y + 2];
}
