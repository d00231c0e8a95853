// Scenes of vibration shapes.

import { f32, f64, i16 } from "./container.mjs";
import { circle } from "./outlines.mjs";
import { emptyScene } from "./scene.mjs";

/** Three vibration shapes of a mast along z. */
export function modes() {
  const count = 41;
  const along = Array.from({ length: count }, (_, i) => i / (count - 1));
  const shapes = [1, 3, 5].map((n) => along.map((s) => 0.1 * Math.sin((n * Math.PI * s) / 2) * s));
  return {
    ...emptyScene(),
    ...{ title: "mast", analysis: "modes", size: 1, stations: count, up: [0, 0, 1] },
    bounds: [
      [-0.1, -0.03, 0],
      [0.1, 0.03, 1],
    ],
    frames: {
      count: 3,
      values: f64([1, 2, 3]),
      labels: ["mode 1: 12.3 Hz", "mode 2: 77.1 Hz", "mode 3: 216 Hz"],
    },
    bodies: [
      {
        ...{ name: "mast", kind: "beam", first: 0, count, outline: circle(0.03), inner: circle(0.024) },
        ...{ scale: f32(along.flatMap((s) => [1 - 0.6 * s, 1 - 0.6 * s])), nodes: [0, 20, 40], box: null },
      },
    ],
    centres: f32(shapes.flatMap((w) => along.flatMap((s, i) => [w[i], 0, s]))),
    directors: i16(
      shapes.flatMap(() => along.flatMap(() => [0, 0, 1, 1, 0, 0, 0, 1, 0].map((x) => 32767 * x))),
    ),
    reference: {
      centres: f32(along.flatMap((s) => [0, 0, s])),
      directors: i16(along.flatMap(() => [0, 0, 1, 1, 0, 0, 0, 1, 0].map((x) => 32767 * x))),
    },
    markers: [{ name: "foot", kind: "joint", detail: "clamp", at: f32([0, 0, 0, 0, 0, 0, 0, 0, 0]) }],
    abscissa: { name: "mode", unit: "", values: f64([]) },
  };
}

/** Shapes of the mast with a chart of the frequencies; the first shape is rigid. */
export function frequencies() {
  const scene = modes();
  const labels = ["mode 1: 0 Hz", "mode 2: 77.12 Hz", "mode 3: 216 Hz"];
  const values = f64([0, 77.1234, 216.001]);
  const columns = [{ name: "frequency", label: "frequency", unit: "Hz", values }];
  return {
    ...scene,
    frames: { ...scene.frames, labels },
    charts: [{ title: "frequency", group: "solver", log: false, columns }],
    abscissa: { name: "mode", unit: "", values: f64([1, 2, 3]) },
  };
}

/** Two whirls of the mast, forward and backward about z, and a real shape. The imaginary parts follow as frames 3 and 4. */
export function whirls() {
  const scene = modes();
  const [forward, backward, real] = [0, 1, 2].map((f) =>
    Array.from(scene.centres.data.slice(f * 123, f * 123 + 123)),
  );
  // Re cos wt - Im sin wt: a forward whirl has the imaginary part -y where the real part is x.
  const turned = (shape, sense) =>
    shape.map((_, i) => (i % 3 === 1 ? sense * shape[i - 1] : i % 3 === 2 ? shape[i] : 0));
  const all = [forward, backward, real, turned(forward, -1), turned(backward, 1)];
  const frame = Array.from(scene.reference.directors.data);
  return {
    ...scene,
    frames: { ...scene.frames, imaginary: [3, 4, null] },
    centres: f32(all.flat()),
    directors: i16(all.flatMap(() => frame)),
    markers: [{ name: "foot", kind: "joint", detail: "clamp", at: f32(new Array(15).fill(0)) }],
  };
}
