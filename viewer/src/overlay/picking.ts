// Picking: station under the pointer, with its position and the value of the field.

import { largestMagnitude, suppressNoise } from "../base/numbers";
import type { Settings } from "../base/settings";
import { formatQuantity } from "../base/units";
import type { Viewport } from "../draw/viewport";
import { type FrameBlend, fieldAt, stationPosition } from "../scene/blend";
import { arcLength, bodyRadius, surfacePlace } from "../scene/geometry";
import type { Body, Field, Scene } from "../scene/scene";

type CanvasPoint = [x: number, y: number];

export interface PickedStation {
  body: Body;
  /** Index of the station within the body. */
  index: number;
}

/** Picking tolerance in pixels. */
const TOLERANCE = 6;

/** Station nearest to a point of the canvas, if the point is on its section or within the tolerance. */
export function pickStation(
  viewport: Viewport,
  scene: Scene,
  settings: Settings,
  blend: FrameBlend,
  pointer: CanvasPoint,
): PickedStation | null {
  let best = 0;
  let picked: PickedStation | null = null;
  for (const body of scene.bodies) {
    if (body.grid) continue;
    const radius = bodyRadius(body) * settings.thickness;
    let previous: CanvasPoint | null = null;
    for (let i = 0; i < body.count; i++) {
      const position = stationPosition(scene, body.first + i, blend);
      const point = viewport.project(position);
      if (point) {
        const [distance, share] = segmentDistance(previous ?? point, point, pointer);
        const score = distance - radius * viewport.pixelsPerUnit(position) - TOLERANCE;
        if (score < best) {
          best = score;
          picked = { body, index: previous && share < 0.5 ? i - 1 : i };
        }
      }
      previous = point;
    }
  }
  return picked ?? pickSurface(viewport, scene, blend, pointer);
}

/** Station of a shell nearest to a point of the canvas, on the nearest surface at the point. */
function pickSurface(
  viewport: Viewport,
  scene: Scene,
  blend: FrameBlend,
  pointer: CanvasPoint,
): PickedStation | null {
  let nearest = 0;
  let picked: PickedStation | null = null;
  for (const body of scene.bodies) {
    if (!body.grid) continue;
    const [n, m] = body.grid.counts;
    const positions = Array.from({ length: body.count }, (_, i) =>
      stationPosition(scene, body.first + i, blend),
    );
    const points = positions.map((position) => viewport.project(position));
    for (let i = 0; i + n + 1 < body.count; i++) {
      if (i % n === n - 1 || i % (n * m) >= n * (m - 1)) continue;
      const corners = [i, i + 1, i + n + 1, i + n];
      const quad = corners.map((k) => points[k]);
      if (!isInside(quad, pointer)) continue;
      // Size of a unit of length in pixels: larger values are nearer.
      const size = viewport.pixelsPerUnit(positions[i]);
      if (size <= nearest) continue;
      nearest = size;
      const away = quad.map((point) => Math.hypot(...subtract(point as CanvasPoint, pointer)));
      picked = { body, index: corners[away.indexOf(Math.min(...away))] };
    }
  }
  return picked;
}

/** True if a point is inside a quadrilateral with corners in order. */
function isInside(quad: (CanvasPoint | null)[], pointer: CanvasPoint): boolean {
  if (!quad.every((corner) => corner !== null)) return false;
  const sides = quad.map((corner, k) => {
    const [ax, ay] = subtract(quad[(k + 1) % 4] as CanvasPoint, corner);
    const [bx, by] = subtract(pointer, corner);
    return ax * by - ay * bx;
  });
  return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}

function subtract(a: CanvasPoint, b: CanvasPoint): CanvasPoint {
  return [a[0] - b[0], a[1] - b[1]];
}

/** Distance of a point from a segment, and the position of the nearest point on the segment (0 to 1). */
function segmentDistance(a: CanvasPoint, b: CanvasPoint, [x, y]: CanvasPoint): [number, number] {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / square)) : 0;
  return [Math.hypot(a[0] + t * dx - x, a[1] + t * dy - y), t];
}

/** Value of a field with its unit. Rounding noise is zero. */
function fieldText(field: Field, value: number): string {
  const largest = largestMagnitude(field.range);
  return formatQuantity(suppressNoise(value, largest), field.unit, largest);
}

/** Lines of text on a picked station: body, arc length or parameters of a shell, position, value of the field. */
export function describeStation(
  scene: Scene,
  settings: Settings,
  blend: FrameBlend,
  { body, index }: PickedStation,
): string[] {
  const unit = scene.units?.length ?? "";
  const station = body.first + index;
  const position = stationPosition(scene, station, { ...blend, scale: 1, imaginary: 0 });
  const lines = [body.name];
  if (body.grid) {
    const [u, v] = surfacePlace(body.grid, index).map((x) => formatQuantity(x, ""));
    const { counts, patches } = body.grid;
    const element = Math.floor(index / (counts[0] * counts[1]));
    lines.push(patches > 1 ? `element ${element}, ξ = ${u}, η = ${v}` : `u = ${u}, v = ${v}`);
  } else if (body.count > 1) {
    const length = formatQuantity(arcLength(scene, body, body.count - 1), unit);
    lines.push(`s = ${formatQuantity(arcLength(scene, body, index), unit)} of ${length}`);
  }
  const coordinates = position.map((c) => formatQuantity(c, "")).join(", ");
  lines.push(`at (${coordinates})${unit && ` ${unit}`}`);
  const field = scene.fields.find((f) => f.name === settings.field);
  if (field) lines.push(`${field.name}: ${fieldText(field, fieldAt(scene, field, station, blend))}`);
  return lines;
}
