// Names over the picture: of bodies, joints, probes, nodes; values of reactions. None covers another.

import { h, quantity } from "../base/dom";
import type { Settings } from "../base/settings";
import { clean } from "../charts/scales";
import { greatest } from "../draw/symbols";
import type { Stage } from "../draw/viewport";
import { type Instant, place, station } from "../scene/blend";
import type { Reaction, Scene, Vector } from "../scene/scene";

/** More labels than this are no help. */
const MOST = 120;
/** More nodes than this are not even looked at. */
const MOST_NODES = 3000;
/** Of more bodies than this the names are seen under the pointer only. */
const MOST_BODIES = 40;
const CELL = 8;
const LINE = 18;
/** How many lines further down a reaction may be written than it should. */
const DOWN = 5;

interface Label {
  /** Its lines; all in one if there is room. */
  lines: string[];
  kind: "body" | "marker" | "reaction" | "node";
  at: Vector;
}

/** Position of a marker: scaled like the bodies if it has a place in the reference shape. */
function marker(scene: Scene, index: number, reference: Float32Array, now: Instant): Vector {
  const { at } = scene.markers[index];
  const from = 3 * (scene.stations + index);
  const own = reference.subarray(from, from + 3);
  return Number.isNaN(own[0])
    ? place(at, [0, 0, 0] as never, 1, 0, { ...now, scale: 1 })
    : place(at, own, 1, 0, now);
}

function size(vectors: ArrayLike<number>, now: Instant): number {
  const x = [0, 1, 2].map((k) => {
    const [a, b] = [vectors[3 * now.first + k], vectors[3 * now.second + k]];
    return a + now.weight * (b - a);
  });
  return Math.hypot(...x);
}

/** The greatest force and moment of all reactions and times, found once. */
const GREATEST = new WeakMap<Reaction[], [number, number]>();

function greatestOf(reactions: Reaction[]): [number, number] {
  const known = GREATEST.get(reactions);
  if (known) return known;
  const most = (of: (r: Reaction) => Reaction["force"]) =>
    Math.max(0, ...reactions.map((r) => greatest(of(r))));
  const found: [number, number] = [most((r) => r.force), most((r) => r.moment)];
  GREATEST.set(reactions, found);
  return found;
}

/** "F 119.4 N" and "M 3.103 N m"; rounding noise is left out. */
function told(scene: Scene, reaction: Reaction, now: Instant): string[] {
  const force = scene.units?.force ?? "";
  const length = scene.units?.length ?? "";
  const [most, turning] = greatestOf(scene.reactions);
  const f = clean(size(reaction.force, now), most);
  const m = clean(size(reaction.moment, now), turning);
  return [
    ...(f > 0 ? [`F ${quantity(f, force)}`] : []),
    ...(m > 0 ? [`M ${quantity(m, force && `${force} ${length}`)}`] : []),
  ];
}

/** All labels of an instant, the most important first. */
function wanted(scene: Scene, reference: Float32Array, settings: Settings, now: Instant): Label[] {
  const list: Label[] = [];
  const pulls = new Map(scene.reactions.map((r) => [r.marker, r]));
  if (settings.labels) {
    scene.markers.forEach((m, i) => {
      list.push({ lines: [m.name], kind: "marker", at: marker(scene, i, reference, now) });
    });
  }
  if (settings.reactions) {
    for (const [i, r] of pulls) {
      const lines = told(scene, r, now);
      if (lines.length > 0) list.push({ lines, kind: "reaction", at: marker(scene, i, reference, now) });
    }
  }
  if (settings.labels) {
    const few = scene.bodies.length <= MOST_BODIES;
    for (const b of few ? scene.bodies : []) {
      if (b.count > 0)
        list.push({ lines: [b.name], kind: "body", at: station(scene, b.first + (b.count >> 1), now) });
    }
  }
  if (settings.nodes) {
    let left = MOST_NODES;
    for (const b of scene.bodies) {
      b.nodes.slice(0, Math.max(0, left)).forEach((s, i) => {
        list.push({ lines: [String(i)], kind: "node", at: station(scene, s, now) });
      });
      left -= b.nodes.length;
    }
  }
  return list;
}

/** A text and its upper left corner. */
type Place = [text: string, x: number, y: number];

export class Labels {
  readonly element = h("div", { class: "labels", "aria-hidden": "true" });
  private readonly pool: HTMLElement[] = [];
  private readonly widths = new Map<string, number>();

  constructor(private readonly stage: Stage) {}

  draw(scene: Scene, reference: Float32Array, settings: Settings, now: Instant): void {
    const taken = new Set<number>();
    let shown = 0;
    for (const label of wanted(scene, reference, settings, now)) {
      if (shown >= MOST) break;
      const spot = this.stage.project(label.at);
      if (!spot || spot[0] < 0 || spot[1] < 0 || spot[0] > this.stage.width || spot[1] > this.stage.height)
        continue;
      const place = this.places(label, spot).find(([text, x, y]) => !this.occupied(taken, text, x, y));
      if (place) this.put(shown++, label.kind, place);
    }
    for (let i = shown; i < this.pool.length; i++) this.pool[i].hidden = true;
  }

  /** Where a label may stand, the best first: a reaction rather elsewhere and in two lines than not at all. */
  private places(label: Label, spot: [number, number]): Place[] {
    const one = label.lines.join(", ");
    const at = (text: string): Place => [
      text,
      ...offset(label.kind, spot, this.width(text), this.stage.width),
    ];
    if (label.kind !== "reaction") return [at(one)];
    const [, x, y] = at(label.lines.join("\n"));
    const text = label.lines.join("\n");
    const other = spot[0] - this.width(text) - 10;
    const list = [at(one)];
    for (let i = 0; i <= DOWN; i++) {
      list.push([text, x, y + i * LINE]);
      if (other > 0) list.push([text, other, y + i * LINE]);
    }
    return list;
  }

  private put(index: number, kind: Label["kind"], [text, x, y]: Place): void {
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

  private width(text: string): number {
    const known = this.widths.get(text);
    if (known !== undefined) return known;
    const width = 12 + 6.6 * Math.max(...text.split("\n").map((line) => line.length));
    if (this.widths.size > 5000) this.widths.clear();
    this.widths.set(text, width);
    return width;
  }

  /** Marks the cells under a label; true if one of them was marked before. */
  private occupied(taken: Set<number>, text: string, x: number, y: number): boolean {
    const [width, height] = [this.width(text), LINE * text.split("\n").length];
    const cells: number[] = [];
    for (let i = Math.floor(x / CELL); i <= (x + width) / CELL; i++) {
      for (let j = Math.floor(y / CELL); j <= (y + height) / CELL; j++) {
        const cell = i * 4096 + j;
        if (taken.has(cell)) return true;
        cells.push(cell);
      }
    }
    for (const cell of cells) taken.add(cell);
    return false;
  }
}

/** Upper left corner of a label beside its point, within the picture. */
function offset(
  kind: Label["kind"],
  [x, y]: [number, number],
  width: number,
  limit: number,
): [number, number] {
  const left = x + width + 14 > limit ? x - width - 10 : x + 10;
  if (kind === "marker") return [left, y - 22];
  if (kind === "reaction") return [left, y + 6];
  if (kind === "body") return [Math.max(2, x - width / 2), y - 34];
  return [x + 4, y + 2];
}
