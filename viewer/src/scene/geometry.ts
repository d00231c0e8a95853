// Geometry of bodies in the reference configuration.

import type { Body, Grid, Scene, Vector } from "./scene";

export function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Arc length in the reference configuration from the first station of a body to its station `index`. */
export function arcLength(scene: Scene, body: Body, index: number): number {
  const { centres } = scene.reference;
  let sum = 0;
  for (let i = body.first; i < body.first + index; i++) {
    sum += distance(centres.subarray(3 * i, 3 * i + 3), centres.subarray(3 * i + 3, 3 * i + 6));
  }
  return sum;
}

/** Smallest and largest coordinates of the surface of a rigid body along its directors. */
export function surfaceBox(body: Body): [Vector, Vector] {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  body.surface?.points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return [low, high];
}

/** Station in the middle of a body, counted from its first station. */
export function middleStation({ count, grid }: Body): number {
  if (!grid) return count >> 1;
  const [n, m] = grid.counts;
  return (grid.patches >> 1) * n * m + (m >> 1) * n + (n >> 1);
}

/** Parameters u and v of a station of a shell, or ξ and η in its element of a mesh, from 0 to 1. */
export function surfacePlace({ counts: [n, m] }: Grid, index: number): [u: number, v: number] {
  const own = index % (n * m);
  return [(own % n) / (n - 1), Math.floor(own / n) / (m - 1)];
}

/** Largest distance from the centre line or the middle surface to the surface, or from the centre to the box corners. */
export function bodyRadius(body: Body): number {
  if (body.grid) return body.grid.half;
  if (body.box) return body.kind === "point" ? body.box[0] : Math.hypot(...body.box);
  let radius = 0;
  for (const [y, z] of body.outline) radius = Math.max(radius, Math.hypot(y, z));
  return radius;
}
