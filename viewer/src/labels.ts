// Names over the picture: of bodies, joints, probes, nodes; values of reactions. None covers another.

import { h, quantity } from "./dom";
import { type Instant, place, station } from "./instant";
import type { Scene, Vector } from "./scene";
import type { Settings } from "./settings";
import type { Stage } from "./stage";

/** More labels than this are no help. */
const MOST = 120;
/** More nodes than this are not even looked at. */
const MOST_NODES = 3000;
/** Of more bodies than this the names are seen under the pointer only. */
const MOST_BODIES = 40;
const CELL = 8;

interface Label {
  text: string;
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

/** All labels of an instant, the most important first. */
function wanted(scene: Scene, reference: Float32Array, settings: Settings, now: Instant): Label[] {
  const list: Label[] = [];
  const force = scene.units?.force ?? "";
  const length = scene.units?.length ?? "";
  const pulls = new Map(scene.reactions.map((r) => [r.marker, r]));
  if (settings.labels) {
    scene.markers.forEach((m, i) => {
      list.push({ text: m.name, kind: "marker", at: marker(scene, i, reference, now) });
    });
  }
  if (settings.reactions) {
    for (const [i, r] of pulls) {
      const [f, m] = [size(r.force, now), size(r.moment, now)];
      const parts = [
        f > 0 ? quantity(f, force) : "",
        m > 0 ? quantity(m, force && `${force} ${length}`) : "",
      ];
      const text = parts.filter(Boolean).join(", ");
      if (text) list.push({ text, kind: "reaction", at: marker(scene, i, reference, now) });
    }
  }
  if (settings.labels) {
    const few = scene.bodies.length <= MOST_BODIES;
    for (const b of few ? scene.bodies : []) {
      if (b.count > 0)
        list.push({ text: b.name, kind: "body", at: station(scene, b.first + (b.count >> 1), now) });
    }
  }
  if (settings.nodes) {
    let left = MOST_NODES;
    for (const b of scene.bodies) {
      b.nodes.slice(0, Math.max(0, left)).forEach((s, i) => {
        list.push({ text: String(i), kind: "node", at: station(scene, s, now) });
      });
      left -= b.nodes.length;
    }
  }
  return list;
}

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
      const width = this.width(label.text);
      const [x, y] = offset(label.kind, spot, width, this.stage.width);
      if (this.occupied(taken, x, y, width)) continue;
      this.put(shown++, label, x, y);
    }
    for (let i = shown; i < this.pool.length; i++) this.pool[i].hidden = true;
  }

  private put(index: number, label: Label, x: number, y: number): void {
    let element = this.pool[index];
    if (!element) {
      element = h("span");
      this.pool.push(element);
      this.element.append(element);
    }
    element.hidden = false;
    if (element.textContent !== label.text) element.textContent = label.text;
    element.className = label.kind;
    element.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }

  private width(text: string): number {
    const known = this.widths.get(text);
    if (known !== undefined) return known;
    const width = 12 + 6.6 * text.length;
    if (this.widths.size > 5000) this.widths.clear();
    this.widths.set(text, width);
    return width;
  }

  /** Marks the cells under a label; true if one of them was marked before. */
  private occupied(taken: Set<number>, x: number, y: number, width: number): boolean {
    const cells: number[] = [];
    for (let i = Math.floor(x / CELL); i <= (x + width) / CELL; i++) {
      for (let j = Math.floor(y / CELL); j <= (y + 18) / CELL; j++) {
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
