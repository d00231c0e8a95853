// Axes perpendicular to the vertical direction of the scene.

import type { Vector } from "../scene/scene";

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Horizontal axes of the front view: to the right, and towards the observer. */
export function horizontalAxes(up: Vector): [right: Vector, toward: Vector] {
  const vertical = up.map(Math.abs).indexOf(Math.max(...up.map(Math.abs)));
  const right: Vector = vertical === 0 ? [0, 1, 0] : [1, 0, 0];
  const toward: Vector = [
    right[1] * up[2] - right[2] * up[1],
    right[2] * up[0] - right[0] * up[2],
    right[0] * up[1] - right[1] * up[0],
  ];
  return [right, toward];
}
