// Scene with a large number of stations.

import { f32, f64, i16, u16 } from "./container.mjs";
import { circle } from "./outlines.mjs";
import { emptyScene, rotatedDirectors } from "./scene.mjs";

/** Parallel beams with `count` stations each. */
export function manyBeams(bodies = 100, count = 1000, frames = 3) {
  const stations = bodies * count;
  const centres = new Float32Array(3 * stations * frames);
  const reference = new Float32Array(3 * stations);
  const directors = new Int16Array(9 * stations * frames);
  const straight = rotatedDirectors(0);
  const values = new Uint16Array(stations * frames);
  for (let f = 0; f < frames; f++) {
    for (let i = 0; i < stations; i++) {
      const [s, row] = [(i % count) / (count - 1), Math.floor(i / count)];
      const k = f * stations + i;
      centres.set([s, 0.1 * f * s * Math.sin(9 * s + row), row / bodies], 3 * k);
      if (f === 0) reference.set([s, 0, row / bodies], 3 * i);
      directors.set(straight, 9 * k);
      values[k] = Math.round(65534 * s);
    }
  }
  const field = {
    name: "axial force",
    symbol: "N",
    unit: "N",
    diverging: false,
    range: [0, 1],
    values: u16(values),
  };
  return {
    ...emptyScene(),
    ...{ title: "many beams", stations, size: 1.4, fields: [field] },
    bounds: [
      [0, -0.2, 0],
      [1, 0.2, 1],
    ],
    frames: { count: frames, values: f64(Array.from({ length: frames }, (_, f) => f)), labels: null },
    bodies: Array.from({ length: bodies }, (_, b) => ({
      ...{
        name: `beam ${b}`,
        kind: "beam",
        first: b * count,
        count,
        outline: circle(0.003, 16),
        inner: null,
      },
      ...{ scale: null, nodes: [b * count, (b + 1) * count - 1], box: null },
    })),
    centres: f32(centres),
    directors: i16(directors),
    reference: { centres: f32(reference), directors: i16(directors.subarray(0, 9 * stations)) },
    abscissa: { name: "t", unit: "s", values: f64([]) },
  };
}
