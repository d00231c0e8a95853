// Placement of boxes beside their points: without overlaps, and outside covered areas.

import type { Rectangle } from "../view/camera";

/** Gap between two boxes in pixels. */
const GAP = 2;
/** Distance of the nearest placements from the point in pixels. */
const NEAR = 10;
/** Distances of a displaced box from its point in pixels. */
const DISTANCES = [NEAR, 30, 54, 84, 120, 160];
/** Half of the size of a symbol, which boxes of other points do not cover, in pixels. */
const SYMBOL = 6;

/** Directions from the point to the box, the best first. */
const DIRECTIONS = [
  [1, -0.7],
  [1, 0.7],
  [-1, -0.7],
  [-1, 0.7],
  [0, -1],
  [0, 1],
  [1, 0],
  [-1, 0],
];

/** Box to place beside a point. */
export interface PlacedBox {
  point: Point;
  width: number;
  height: number;
}

/** Number of placements at the smallest distance. */
export const NEAR_SLOTS = DIRECTIONS.length;
/** Number of placements of a box. */
export const SLOTS = DISTANCES.length * DIRECTIONS.length;

/** Rectangle of a box in one of its placements. */
export function slotRectangle({ point, width, height }: PlacedBox, slot: number): Rectangle {
  const distance = DISTANCES[Math.floor(slot / DIRECTIONS.length)];
  const [dx, dy] = DIRECTIONS[slot % DIRECTIONS.length];
  const left = point[0] + dx * distance + (dx > 0 ? 0 : dx < 0 ? -width : -0.5 * width);
  const top = point[1] + dy * distance + (dy > 0.9 ? 0 : dy < -0.9 ? -height : (0.5 * dy - 0.5) * height);
  return { left, top, right: left + width, bottom: top + height };
}

type Point = [number, number];
type Segment = [Point, Point];

/** True if a segment has a point in a rectangle (Liang & Barsky, 1984). */
function crosses([[x0, y0], [x1, y1]]: Segment, { left, top, right, bottom }: Rectangle): boolean {
  let [from, to] = [0, 1];
  for (const [p, q] of [
    [x0 - x1, x0 - left],
    [x1 - x0, right - x0],
    [y0 - y1, y0 - top],
    [y1 - y0, bottom - y0],
  ]) {
    if (p === 0 && q < 0) return false;
    if (p < 0) from = Math.max(from, q / p);
    if (p > 0) to = Math.min(to, q / p);
  }
  return from < to;
}

/** Occupied rectangles and lines of a view. */
export class Occupancy {
  private readonly boxes: Rectangle[] = [];
  private readonly lines: Segment[] = [];

  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly covered: Rectangle[],
    private readonly points: Point[],
  ) {}

  /**
   * Occupies the nearest free slot of a box and returns it; -1 if there is none. Boxes do not cover symbols and lines of
   * other boxes unless there is no other slot.
   */
  place(box: PlacedBox, slots: number): number {
    for (const strict of [true, false]) {
      for (let slot = 0; slot < slots; slot++) if (this.occupy(box, slot, strict)) return slot;
    }
    return -1;
  }

  /** Occupies a slot. Returns false, without a change, if it is not free, or, if `strict`, not clear of symbols and lines. */
  occupy(box: PlacedBox, slot: number, strict: boolean): boolean {
    const rectangle = slotRectangle(box, slot);
    const line: Segment = [box.point, nearestPoint(rectangle, box.point)];
    if (!this.isFree(rectangle) || (strict && !this.isClear(rectangle, line))) return false;
    this.boxes.push(rectangle);
    this.lines.push(line);
    return true;
  }

  /** True if a rectangle is inside the view and overlaps no other one. */
  private isFree({ left, top, right, bottom }: Rectangle): boolean {
    if (left < GAP || top < GAP || right > this.width - GAP || bottom > this.height - GAP) return false;
    for (const list of [this.covered, this.boxes]) {
      for (const t of list) {
        if (left < t.right + GAP && t.left < right + GAP && top < t.bottom + GAP && t.top < bottom + GAP)
          return false;
      }
    }
    return true;
  }

  /** True if a rectangle covers no symbol of another point, and neither it nor its line crosses others. */
  private isClear(rectangle: Rectangle, line: Segment): boolean {
    const { left, top, right, bottom } = rectangle;
    const [own] = line;
    for (const [x, y] of this.points) {
      const apart = Math.abs(x - own[0]) > SYMBOL || Math.abs(y - own[1]) > SYMBOL;
      if (apart && x > left - SYMBOL && x < right + SYMBOL && y > top - SYMBOL && y < bottom + SYMBOL)
        return false;
    }
    return !this.boxes.some((box) => crosses(line, box)) && !this.lines.some((l) => crosses(l, rectangle));
  }
}

/** Point of a rectangle nearest to a point. */
export function nearestPoint(
  { left, top, right, bottom }: Rectangle,
  [x, y]: [number, number],
): [number, number] {
  return [Math.min(right, Math.max(left, x)), Math.min(bottom, Math.max(top, y))];
}
