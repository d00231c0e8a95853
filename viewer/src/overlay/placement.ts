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
  point: [number, number];
  width: number;
  height: number;
}

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

/** Occupied rectangles of a view. */
export class Occupancy {
  private readonly taken: Rectangle[];

  constructor(
    private readonly width: number,
    private readonly height: number,
    covered: Rectangle[],
    private readonly points: [number, number][],
  ) {
    this.taken = [...covered];
  }

  /** Placement of a box in the first free slot, starting with `preferred`; -1 if there is none. */
  place(box: PlacedBox, preferred: number, slots: number): number {
    for (const avoidPoints of [true, false]) {
      for (let i = -1; i < slots; i++) {
        const slot = i < 0 ? preferred : i;
        const rectangle = slotRectangle(box, slot);
        if (slot >= slots || !this.isFree(rectangle, avoidPoints ? box.point : null)) continue;
        this.taken.push(rectangle);
        return slot;
      }
    }
    return -1;
  }

  /** True if a rectangle is free; with `own`, also of the symbols at other points. */
  private isFree({ left, top, right, bottom }: Rectangle, own: [number, number] | null): boolean {
    if (left < GAP || top < GAP || right > this.width - GAP || bottom > this.height - GAP) return false;
    for (const t of this.taken) {
      if (left < t.right + GAP && t.left < right + GAP && top < t.bottom + GAP && t.top < bottom + GAP)
        return false;
    }
    if (!own) return true;
    for (const [x, y] of this.points) {
      const apart = Math.abs(x - own[0]) > SYMBOL || Math.abs(y - own[1]) > SYMBOL;
      if (apart && x > left - SYMBOL && x < right + SYMBOL && y > top - SYMBOL && y < bottom + SYMBOL)
        return false;
    }
    return true;
  }
}

/** Point of a rectangle nearest to a point. */
export function nearestPoint(
  { left, top, right, bottom }: Rectangle,
  [x, y]: [number, number],
): [number, number] {
  return [Math.min(right, Math.max(left, x)), Math.min(bottom, Math.max(top, y))];
}
