// Scene with a rigid body that has a surface.

import { f32, f64, i16, u32 } from "./container.mjs";
import { emptyScene, rotatedDirectors } from "./scene.mjs";

/** Length of the bar of the bracket along its x-axis, and of that along its y-axis, both from the centre of mass. */
export const BARS = [1, 0.5];
const WIDTH = 0.2;
const CORNERS = [
  [0, 0],
  [BARS[0], 0],
  [BARS[0], WIDTH],
  [WIDTH, WIDTH],
  [WIDTH, BARS[1]],
  [0, BARS[1]],
];
const FRAMES = 5;

/** Plate in the shape of an L, which turns by a right angle about z. A point mass marks the origin of the view. */
export function bracket(changes = {}) {
  const identity = rotatedDirectors(0);
  const angles = Array.from({ length: FRAMES }, (_, i) => (0.5 * Math.PI * i) / (FRAMES - 1));
  const surface = {
    points: f32(CORNERS.flatMap(([x, y]) => [x, y, 0])),
    normals: i16(CORNERS.flatMap(() => [0, 0, 32767])),
    corners: u32([0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5]),
    ...changes,
  };
  const body = { name: "bracket", kind: "rigid", first: 0, count: 1, outline: [], inner: null, scale: null };
  const box = [...BARS, 0];
  return {
    ...emptyScene(),
    ...{ title: "bracket", size: 1, stations: 1, up: [0, 0, 1] },
    frames: { count: FRAMES, values: f64(angles.map((_, i) => i)), labels: null },
    bodies: [{ ...body, nodes: [0], box, surface }],
    centres: f32(angles.flatMap(() => [0, 0, 0])),
    directors: i16(angles.flatMap(rotatedDirectors)),
    reference: { centres: f32([0, 0, 0]), directors: i16(identity) },
    bounds: [
      [-1.2, -1.2, 0],
      [1.2, 1.2, 0],
    ],
    abscissa: { name: "t", unit: "s", values: f64(angles.map((_, i) => i)) },
  };
}
