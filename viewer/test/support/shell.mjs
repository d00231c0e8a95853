// Scene of a plate that bends to a parabola, with a supported edge and a pressure.

import { f32, f64, i16 } from "./container.mjs";
import { emptyScene, encodeField } from "./scene.mjs";

const HALF = 0.01;
const PARTS = 4;
/** Numbers of stations along u and v. */
export const COUNTS = [6 * PARTS + 1, 3 * PARTS + 1];

/** Position, then normal and two tangents of the plate z = c x² at (u, v). */
function point(u, v, c) {
  const [slope, size] = [2 * c * u, Math.hypot(1, 2 * c * u)];
  const tangent = [1 / size, 0, slope / size];
  const normal = [-slope / size, 0, 1 / size];
  return { at: [u, 0.5 * v, c * u * u], directors: [...normal, ...tangent, 0, 1, 0] };
}

export function plate({ count = 11, curvature = 0.5, body = {} } = {}) {
  const [n, m] = COUNTS;
  const places = Array.from({ length: n * m }, (_, k) => [(k % n) / (n - 1), Math.floor(k / n) / (m - 1)]);
  const frame = (c) => places.map(([u, v]) => point(u, v, c));
  const frames = Array.from({ length: count }, (_, f) => frame((curvature * f) / (count - 1)));
  const scaled = (points) => points.flatMap((p) => p.directors.map((x) => Math.round(32767 * x)));
  const rest = frame(0);
  const stress = frames.flatMap(() => places.map(([u]) => u));
  const middle = ((m - 1) / 2) * n + (n - 1) / 2;
  return {
    ...emptyScene(),
    ...{ title: "plate", stations: n * m, size: 1.2, up: [0, 0, 1] },
    bounds: [
      [0, 0, 0],
      [1, 0.5, curvature],
    ],
    frames: { count, values: f64(frames.map((_, f) => f)), labels: null },
    bodies: [
      {
        ...{ name: "plate", kind: "shell", first: 0, count: n * m, outline: [], inner: null, scale: null },
        ...{ grid: { patches: 1, counts: COUNTS, parts: PARTS, half: HALF }, nodes: [0], box: null, ...body },
      },
    ],
    centres: f32(frames.flatMap((points) => points.flatMap((p) => p.at))),
    directors: i16(frames.flatMap(scaled)),
    reference: { centres: f32(rest.flatMap((p) => p.at)), directors: i16(scaled(rest)) },
    fields: [
      {
        ...{ name: "von Mises stress", symbol: "σv", unit: "N/m²", diverging: false, range: [0, 1] },
        values: encodeField(stress, [0, 1]),
      },
    ],
    supports: [{ marker: null, stations: Array.from({ length: m }, (_, j) => j * n) }],
    loads: [
      {
        ...{ kind: "pressure", moment: false, stations: [middle] },
        vectors: f32(frames.flatMap((points) => points[middle].directors.slice(0, 3).map((x) => 50 * x))),
      },
    ],
    abscissa: { name: "t", unit: "s", values: f64([]) },
  };
}
