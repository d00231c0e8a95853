// Scene of a vibrating cantilever with known displacements.

import { f32, f64, i16 } from "./container.mjs";
import { rectangle } from "./outlines.mjs";
import { emptyScene, encodeField, rotatedDirectors } from "./scene.mjs";

/** Deflection at s of a cantilever of length one under an end load (Euler-Bernoulli): w = d (3 s² - s³)/2. */
export const deflection = (s, d) => (d * (3 * s * s - s ** 3)) / 2;
const slope = (s, d) => (d * (6 * s - 3 * s * s)) / 2;

/** Deflection of the tip at time t. */
export const tipDeflection = (t) => -0.25 * Math.sin(Math.PI * t);

/** Number of stations. */
const COUNT = 41;
/** Arc lengths of the stations. */
const ARC_LENGTHS = Array.from({ length: COUNT }, (_, i) => i / (COUNT - 1));

/** Vibrating cantilever with 41 stations and `frames` frames from t = 0 to `until`. */
export function cantilever({ frames = 41, live = false, until = 2, nan = false } = {}) {
  const times = Array.from({ length: frames }, (_, i) => (frames > 1 ? (until * i) / (frames - 1) : 0));
  const rows = Array.from({ length: 401 }, (_, i) => (until * i) / 400);
  return {
    ...emptyScene(),
    title: "cantilever",
    text: 'title = "cantilever"\n\n[[bodies]]\nkind = "beam"\nname = "rod"\n',
    live,
    outcome: live ? { kind: "running", message: "" } : { kind: "finished", message: "" },
    bounds: [
      [0, -0.27, -0.03],
      [1, 0.27, 0.03],
    ],
    size: 1.1,
    stations: COUNT,
    frames: { count: frames, values: f64(times), labels: null },
    bodies: [rod()],
    ...positions(times),
    fields: fields(times, nan),
    ...symbols(times),
    charts: charts(rows),
    abscissa: { name: "t", unit: "s", values: f64(rows) },
  };
}

function rod() {
  return {
    ...{ name: "rod", kind: "beam", first: 0, count: COUNT },
    ...{ outline: rectangle(0.05, 0.03), inner: null, scale: null, box: null },
    nodes: ARC_LENGTHS.map((_, i) => i).filter((i) => i % 4 === 0),
  };
}

/** Arc length and tip deflection for all frames and stations. */
function stations(times) {
  return times.flatMap((t) => ARC_LENGTHS.map((s) => [s, tipDeflection(t)]));
}

function positions(times) {
  const list = stations(times);
  return {
    centres: f32(list.flatMap(([s, d]) => [s, deflection(s, d), 0])),
    directors: i16(list.flatMap(([s, d]) => rotatedDirectors(Math.atan(slope(s, d))))),
    reference: {
      centres: f32(ARC_LENGTHS.flatMap((s) => [s, 0, 0])),
      directors: i16(ARC_LENGTHS.flatMap(() => rotatedDirectors(0))),
    },
  };
}

/** Bending moment and speed; with `nan` the moment of the first eight stations is undefined. */
function fields(times, nan) {
  const moment = stations(times).map(([s, d], i) => (nan && i % COUNT < 8 ? Number.NaN : 300 * d * (1 - s)));
  const speed = times.flatMap((t) =>
    ARC_LENGTHS.map((s) => Math.abs(deflection(s, 0.8 * Math.cos(Math.PI * t)))),
  );
  const field = (name, symbol, unit, diverging, range, values) => ({
    ...{ name, symbol, unit, diverging, range, values: encodeField(values, range) },
  });
  return [
    field("bending moment", "M", "N m", true, [-75, 75], moment),
    field("speed", "v", "m/s", false, [0, 0.8], speed),
  ];
}

/** Markers at both ends, and the reaction at the clamp. */
function symbols(times) {
  const vectors = (vector) => f32(times.flatMap(vector));
  const force = vectors((t) => [0, -40 * tipDeflection(t), 0]);
  const moment = vectors((t) => [0, 0, -300 * tipDeflection(t)]);
  return {
    markers: [
      { name: "root", kind: "joint", detail: "clamp", at: vectors(() => [0, 0, 0]) },
      { name: "tip", kind: "probe", detail: "end of rod", at: vectors((t) => [1, tipDeflection(t), 0]) },
    ],
    reactions: [{ name: "root", marker: 0, force, moment }],
  };
}

/** Charts of the functions of time in five groups. */
function charts(times) {
  const column = (name, label, unit, value) => ({ name, label, unit, values: f32(times.map(value)) });
  const chart = (group, title, columns, log = false) => ({ title, group, log, columns });
  return [
    chart("probes", "tip", [
      column("tip.x", "x", "m", () => 1),
      column("tip.y", "y", "m", tipDeflection),
      column("tip.z", "z", "m", (t) => (t > 1.5 ? Number.NaN : 0.1 * t)),
    ]),
    chart("reactions", "root, force", [column("root.fy", "y", "N", (t) => -40 * tipDeflection(t))]),
    chart("energy", "energies", [
      column("kinetic", "kinetic", "J", (t) => 9 * Math.cos(Math.PI * t) ** 2),
      column("strain", "strain", "J", (t) => 9 * Math.sin(Math.PI * t) ** 2),
      column("total", "total", "J", () => 9),
    ]),
    chart("solver", "step size", [column("step", "h", "s", (t) => 10 ** (-4 + Math.sin(5 * t)))], true),
    chart("solver", "iterations", [column("iterations", "iterations", "", (_, i) => 2 + (i % 3))]),
  ];
}
