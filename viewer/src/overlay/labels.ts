// Labels over the 3-D view: name and values beside a point, with a line to the point if there is no space beside it.

import { h } from "../base/dom";
import type { Viewport } from "../draw/viewport";
import type { Rectangle } from "../view/camera";
import { candidateLabels, type Label, type LabelSource } from "./candidates";
import { NEAR_SLOTS, nearestPoint, Occupancy, type PlacedBox, SLOTS, slotRectangle } from "./placement";

/** Upper limit on the number of labels. */
const MAX_LABELS = 120;
/** Height of a line and horizontal padding of a label in pixels. */
const LINE = 17;
const PADDING = 12;
/** Distance of a label from its point in pixels above which a line connects them. */
const LEADER = 20;
/** Width of the view in pixels below which each value has its own line. */
const NARROW = 560;
/** Time for which a displaced label keeps its placement, even if it covers a symbol or a line, in ms. */
const DWELL = 800;
/** Change of the frame, relative to their number, above which all labels are placed again. */
const JUMP = 0.05;

const SVG = "http://www.w3.org/2000/svg";

/** Elements of a label. */
interface LabelElements {
  box: HTMLElement;
  name: HTMLElement;
  values: HTMLElement;
  line: SVGElement;
}

/** Label with its box and the selected slot, -1 if it has none. */
interface LabelBox extends PlacedBox {
  label: Label;
  values: string;
  slot: number;
}

export class Labels {
  readonly element = h("div", { class: "labels", "aria-hidden": "true" });
  private readonly lines = document.createElementNS(SVG, "svg");
  private readonly pool: LabelElements[] = [];
  private readonly widths = new Map<string, number>();
  private readonly context = document.createElement("canvas").getContext("2d");
  /** Placement of each label in the last frame, and the time of its selection in ms. */
  private slots = new Map<string, { slot: number; since: number }>();
  /** Fractional frame of the last drawing. */
  private position = 0;

  constructor(
    private readonly viewport: Viewport,
    /** Areas of the view under buttons and legends. */
    private readonly covered: () => Rectangle[],
  ) {
    this.element.append(this.lines);
  }

  draw(source: LabelSource): void {
    const { width, height } = this.viewport;
    const visible: { label: Label; point: [number, number] }[] = [];
    for (const label of candidateLabels(source)) {
      const point = this.viewport.project(label.position);
      if (point && point[0] >= 0 && point[1] >= 0 && point[0] <= width && point[1] <= height)
        visible.push({ label, point });
    }
    const markers = visible.filter(({ label }) => label.kind === "marker").map(({ point }) => point);
    const occupancy = new Occupancy(width, height, this.covered(), markers);
    const boxes = visible.slice(0, MAX_LABELS).map(({ label, point }): LabelBox => {
      const values = label.values.join(width < NARROW ? "\n" : ", ");
      return { label, values, slot: -1, ...this.box(label, values, point) };
    });
    this.forgetAfterJump(source);
    const slots = this.placeAll(boxes, occupancy);
    let shown = 0;
    for (const box of boxes) {
      if (box.slot >= 0) this.show(shown++, box.label, box.values, slotRectangle(box, box.slot), box.point);
    }
    this.slots = slots;
    for (let i = shown; i < this.pool.length; i++) {
      this.pool[i].box.hidden = true;
      this.pool[i].line.toggleAttribute("hidden", true);
    }
  }

  /** Forgets the placements if the frame has changed by more than playback does. */
  private forgetAfterJump({ scene, blend }: LabelSource): void {
    const position = blend.first + blend.weight;
    if (Math.abs(position - this.position) > JUMP * scene.frames.count) this.slots.clear();
    this.position = position;
  }

  /** Sets the slots of all boxes. Labels keep their placement; displaced ones look for a nearer one from time to time. */
  private placeAll(boxes: LabelBox[], occupancy: Occupancy): Labels["slots"] {
    const now = performance.now();
    const slots: Labels["slots"] = new Map();
    for (const box of boxes) {
      const known = this.slots.get(box.label.key);
      if (!known) continue;
      const recent = now - known.since < DWELL;
      if (!recent && known.slot >= NEAR_SLOTS) continue;
      if (!occupancy.occupy(box, known.slot, !recent)) continue;
      box.slot = known.slot;
      slots.set(box.label.key, known);
    }
    for (const box of boxes) {
      if (box.slot >= 0) continue;
      box.slot = occupancy.place(box, box.label.kind === "marker" ? SLOTS : NEAR_SLOTS);
      if (box.slot >= 0) slots.set(box.label.key, { slot: box.slot, since: now });
    }
    return slots;
  }

  /** Box of a label: a line for its name, and lines for its values. */
  private box(label: Label, values: string, point: [number, number]): PlacedBox {
    if (label.kind === "node") return { point, width: 6.5 * label.name.length + 6, height: 12 };
    const lines = values === "" ? [] : values.split("\n");
    const width = Math.max(this.width(label.name, 600), ...lines.map((line) => this.width(line, 400)));
    return { point, width: Math.ceil(width) + PADDING, height: LINE * (1 + lines.length) + 2 };
  }

  private show(
    index: number,
    label: Label,
    values: string,
    { left, top, right, bottom }: Rectangle,
    point: [number, number],
  ): void {
    const { box, name, values: text, line } = this.elements(index);
    box.hidden = false;
    if (name.textContent !== label.name) name.textContent = label.name;
    if (text.textContent !== values) text.textContent = values;
    if (box.className !== label.kind) box.className = label.kind;
    box.style.transform = `translate(${Math.round(left)}px, ${Math.round(top)}px)`;
    const [x, y] = nearestPoint({ left, top, right, bottom }, point);
    const displaced = Math.hypot(x - point[0], y - point[1]) > LEADER;
    line.toggleAttribute("hidden", !displaced);
    if (displaced)
      line.setAttribute(
        "d",
        `M${point[0].toFixed(1)} ${point[1].toFixed(1)}L${x.toFixed(1)} ${y.toFixed(1)}`,
      );
  }

  private elements(index: number): LabelElements {
    if (!this.pool[index]) {
      const [name, values] = [h("b"), h("span")];
      const box = h("div", {}, name, values);
      const line = document.createElementNS(SVG, "path");
      this.pool[index] = { box, name, values, line };
      this.element.append(box);
      this.lines.append(line);
    }
    return this.pool[index];
  }

  /** Width of a text in pixels. All digits count as the widest one, so that the box does not change with the value. */
  private width(text: string, weight: number): number {
    const key = `${weight} ${text.replace(/[1-9]/g, "0")}`;
    const known = this.widths.get(key);
    if (known !== undefined) return known;
    if (!this.context) return 7 * text.length;
    this.context.font = `${weight} 12px ${getComputedStyle(document.body).fontFamily}`;
    const width = this.context.measureText(key.slice(4)).width;
    if (this.widths.size > 5000) this.widths.clear();
    this.widths.set(key, width);
    return width;
  }
}
