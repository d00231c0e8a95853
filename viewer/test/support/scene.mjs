// Common parts of the test scenes.

import { f32, f64, i16, u16 } from "./container.mjs";

/** Scaled directors of a section whose normal is rotated by `phi` about z. */
export function rotatedDirectors(phi) {
  const [c, s] = [Math.cos(phi), Math.sin(phi)];
  return [c, s, 0, -s, c, 0, 0, 0, 1].map((x) => Math.round(32767 * x));
}

/** Field values as 16-bit codes of a range. */
export const encodeField = (values, [low, high]) =>
  u16(values.map((v) => (Number.isNaN(v) ? 65535 : Math.round(((v - low) / (high - low)) * 65534))));

/** Scene without bodies. */
export function emptyScene() {
  return {
    ...{ program: "ancf 0.1.0", title: "scene", text: 'title = "scene"\n', sha256: "ab".repeat(32) },
    ...{ analysis: "dynamics", units: { length: "m", time: "s", force: "N" }, live: false },
    outcome: { kind: "finished", message: "" },
    summary: [
      ["steps", "2000"],
      ["Newton iterations", "5523"],
      ["wall time", "0.092 s"],
    ],
    ...{ messages: [], size: 1, stations: 0, bodies: [], fields: [], markers: [], reactions: [], links: [] },
    bounds: [
      [0, 0, 0],
      [1, 1, 1],
    ],
    frames: { count: 0, values: f64([]), labels: null },
    centres: f32([]),
    directors: i16([]),
    reference: { centres: f32([]), directors: i16([]) },
    ...{ obstacles: [], charts: [], abscissa: { name: "t", unit: "s", values: f64([]) } },
  };
}
