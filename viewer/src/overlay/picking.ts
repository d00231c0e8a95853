// What is under the pointer: body, place along it, value of the field.

import { h, quantity } from "../base/dom";
import type { Settings } from "../base/settings";
import type { Stage } from "../draw/viewport";
import { arc, type Instant, radius, station, valueAt } from "../scene/blend";
import type { Body, Scene } from "../scene/scene";

export interface Hit {
  body: Body;
  /** Index of the station within the body. */
  index: number;
}

/** Pixels by which one may miss. */
const REACH = 6;

/** The station that is drawn closest to a place on the canvas, if the pointer is on its section or nearly. */
export function pick(
  stage: Stage,
  scene: Scene,
  settings: Settings,
  now: Instant,
  x: number,
  y: number,
): Hit | null {
  let best = 0;
  let found: Hit | null = null;
  for (const body of scene.bodies) {
    const wide = radius(body) * settings.thickness;
    let before: [number, number] | null = null;
    for (let i = 0; i < body.count; i++) {
      const at = station(scene, body.first + i, now);
      const spot = stage.project(at);
      if (spot) {
        const [away, share] = before
          ? toSegment(before, spot, x, y)
          : [Math.hypot(spot[0] - x, spot[1] - y), 1];
        const score = away - wide * stage.magnification(at) - REACH;
        if (score < best) {
          best = score;
          found = { body, index: share < 0.5 ? i - 1 : i };
        }
      }
      before = spot;
    }
  }
  return found;
}

/** Distance of a place from a segment, and where on the segment (0 to 1) it is closest. */
function toSegment(a: [number, number], b: [number, number], x: number, y: number): [number, number] {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / square)) : 0;
  return [Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y), t];
}

/** Lines that say what stands at a station. */
export function describe(scene: Scene, settings: Settings, now: Instant, { body, index }: Hit): string[] {
  const unit = scene.units?.length ?? "";
  const at = station(scene, body.first + index, { ...now, scale: 1 });
  const lines = [body.name];
  if (body.count > 1) {
    const length = quantity(arc(scene, body, body.count - 1), unit);
    lines.push(`s = ${quantity(arc(scene, body, index), unit)} of ${length}`);
  }
  lines.push(`at (${at.map((c) => quantity(c, "")).join(", ")})${unit && ` ${unit}`}`);
  const field = scene.fields.find((f) => f.name === settings.field);
  if (field)
    lines.push(`${field.name}: ${quantity(valueAt(scene, field, body.first + index, now), field.unit)}`);
  return lines;
}

/** The note beside the pointer. */
export class Tip {
  readonly element = h("div", { class: "tip", hidden: true });

  show(lines: string[] | null, x: number, y: number, width: number): void {
    this.element.hidden = lines === null;
    if (!lines) return;
    this.element.replaceChildren(h("strong", {}, lines[0]), ...lines.slice(1).map((l) => h("div", {}, l)));
    const wide = this.element.offsetWidth;
    const left = x + 16 + wide > width ? x - 12 - wide : x + 16;
    this.element.style.transform = `translate(${Math.max(4, left)}px, ${y + 12}px)`;
  }
}
