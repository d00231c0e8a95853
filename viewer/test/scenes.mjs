// Scenes whose pictures are known: an exact cantilever, shapes of vibration, obstacles, very many stations.

import { f32, f64, i16, u16 } from "./container.mjs";
import { circle, rectangle } from "./outlines.mjs";

export const unit = (frames) => new Array(frames).fill(0);

/** Three directors of a section whose normal has the angle `phi` in the plane x, y. */
export function turned(phi) {
  const [c, s] = [Math.cos(phi), Math.sin(phi)];
  return [c, s, 0, -s, c, 0, 0, 0, 1].map((x) => Math.round(32767 * x));
}

/** Cantilever of length one under an end load: w = d (3 s² - s³)/2. */
export const bend = (s, d) => (d * (3 * s * s - s ** 3)) / 2;
const slope = (s, d) => (d * (6 * s - 3 * s * s)) / 2;

const scaled = (values, [low, high]) =>
  u16(values.map((v) => (Number.isNaN(v) ? 65535 : Math.round(((v - low) / (high - low)) * 65534))));

export function empty() {
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

/** Deflection of the tip at a time. */
export const tip = (t) => -0.25 * Math.sin(Math.PI * t);

/** A swinging cantilever: `frames` from t = 0 to 2, 41 stations. */
export function cantilever({ frames = 41, live = false, until = 2, nan = false } = {}) {
  const count = 41;
  const times = Array.from({ length: frames }, (_, i) => (frames > 1 ? (until * i) / (frames - 1) : 0));
  const along = Array.from({ length: count }, (_, i) => i / (count - 1));
  const stations = times.flatMap((t) => along.map((s) => [s, tip(t)]));
  const moment = stations.map(([s, d], i) => (nan && i % count < 8 ? Number.NaN : 300 * d * (1 - s)));
  const speed = times.flatMap((t) => along.map((s) => Math.abs(bend(s, 0.8 * Math.cos(Math.PI * t)))));
  const rows = Array.from({ length: 401 }, (_, i) => (until * i) / 400);
  return {
    ...empty(),
    ...{
      title: "cantilever",
      live,
      text: 'title = "cantilever"\n\n[[bodies]]\nkind = "beam"\nname = "rod"\n',
    },
    outcome: live ? { kind: "running", message: "" } : { kind: "finished", message: "" },
    bounds: [
      [0, -0.27, -0.03],
      [1, 0.27, 0.03],
    ],
    ...{ size: 1.1, stations: count },
    frames: { count: frames, values: f64(times), labels: null },
    bodies: [
      {
        ...{
          name: "rod",
          kind: "beam",
          first: 0,
          count,
          outline: rectangle(0.05, 0.03),
          inner: null,
          scale: null,
        },
        ...{ nodes: along.map((_, i) => i).filter((i) => i % 4 === 0), box: null },
      },
    ],
    centres: f32(stations.flatMap(([s, d]) => [s, bend(s, d), 0])),
    directors: i16(stations.flatMap(([s, d]) => turned(Math.atan(slope(s, d))))),
    reference: {
      centres: f32(along.flatMap((s) => [s, 0, 0])),
      directors: i16(along.flatMap(() => turned(0))),
    },
    fields: [
      {
        ...{ name: "bending moment", symbol: "M", unit: "N m", diverging: true, range: [-75, 75] },
        values: scaled(moment, [-75, 75]),
      },
      {
        name: "speed",
        symbol: "v",
        unit: "m/s",
        diverging: false,
        range: [0, 0.8],
        values: scaled(speed, [0, 0.8]),
      },
    ],
    markers: [
      { name: "root", kind: "joint", detail: "clamp", at: f32(times.flatMap(() => [0, 0, 0])) },
      { name: "tip", kind: "probe", detail: "end of rod", at: f32(times.flatMap((t) => [1, tip(t), 0])) },
    ],
    reactions: [
      {
        ...{ name: "root", marker: 0, force: f32(times.flatMap((t) => [0, -40 * tip(t), 0])) },
        moment: f32(times.flatMap((t) => [0, 0, -300 * tip(t)])),
      },
    ],
    charts: charts(rows),
    abscissa: { name: "t", unit: "s", values: f64(rows) },
  };
}

function charts(t) {
  const column = (name, label, unit, values) => ({ name, label, unit, values: f32(values) });
  return [
    {
      ...{ title: "tip", group: "probes", log: false },
      columns: [
        column(
          "tip.x",
          "x",
          "m",
          t.map(() => 1),
        ),
        column("tip.y", "y", "m", t.map(tip)),
        column(
          "tip.z",
          "z",
          "m",
          t.map((x) => (x > 1.5 ? Number.NaN : 0.1 * x)),
        ),
      ],
    },
    {
      ...{ title: "root, force", group: "reactions", log: false },
      columns: [
        column(
          "root.fy",
          "y",
          "N",
          t.map((x) => -40 * tip(x)),
        ),
      ],
    },
    {
      ...{ title: "energies", group: "energy", log: false },
      columns: [
        column(
          "kinetic",
          "kinetic",
          "J",
          t.map((x) => 9 * Math.cos(Math.PI * x) ** 2),
        ),
        column(
          "strain",
          "strain",
          "J",
          t.map((x) => 9 * Math.sin(Math.PI * x) ** 2),
        ),
        column(
          "total",
          "total",
          "J",
          t.map(() => 9),
        ),
      ],
    },
    {
      ...{ title: "step size", group: "solver", log: true },
      columns: [
        column(
          "step",
          "h",
          "s",
          t.map((x) => 10 ** (-4 + Math.sin(5 * x))),
        ),
      ],
    },
    {
      ...{ title: "iterations", group: "solver", log: false },
      columns: [
        column(
          "iterations",
          "iterations",
          "",
          t.map((_, i) => 2 + (i % 3)),
        ),
      ],
    },
  ];
}

/** Three shapes of a cantilever standing along z. */
export function modes() {
  const count = 41;
  const along = Array.from({ length: count }, (_, i) => i / (count - 1));
  const shapes = [1, 3, 5].map((n) => along.map((s) => 0.1 * Math.sin((n * Math.PI * s) / 2) * s));
  return {
    ...empty(),
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

/** The same with frequencies in a chart, the first shape rigid. */
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

/** A box and a ball hung on springs over a floor, beside a sphere and a cylinder. */
export function machine() {
  const frames = 21;
  const times = Array.from({ length: frames }, (_, i) => i / 20);
  const high = (t) => 0.5 + 0.2 * Math.cos(2 * Math.PI * t);
  const far = (t) => [0.7, 0.3 * Math.sin(2 * Math.PI * t), 0.35];
  const still = turned(0);
  return {
    ...empty(),
    ...{ title: "box on springs over a floor", size: 1.5, stations: 2, up: [0, 0, 1] },
    outcome: {
      kind: "failed",
      message: "Newton's method found no equilibrium at t = 1 s: try a smaller step.",
    },
    messages: ["warning: the box touches the floor at t = 0.5 s", "error: no convergence at t = 1 s"],
    bounds: [
      [-0.6, -0.5, 0],
      [0.9, 0.5, 1.2],
    ],
    frames: { count: frames, values: f64(times), labels: null },
    bodies: [body("box", "rigid", 0, [0.15, 0.1, 0.08]), body("ball", "point", 1, [0.06, 0.06, 0.06])],
    centres: f32(times.flatMap((t) => [0, 0, high(t), ...far(t)])),
    directors: i16(times.flatMap((t) => [...turned(0.5 * t), ...still])),
    reference: { centres: f32([0, 0, 0.5, 0.7, 0, 0.35]), directors: i16([...still, ...still]) },
    markers: [
      { name: "hook", kind: "joint", detail: "fixed", at: f32(times.flatMap(() => [0, 0, 1.2])) },
      { name: "push", kind: "load", detail: "force", at: f32(times.flatMap((t) => far(t))) },
    ],
    links: [
      link(
        "spring",
        "spring",
        times.flatMap((t) => [0, 0, 1.2, 0, 0, high(t) + 0.08]),
      ),
      link(
        "damper",
        "damper",
        times.flatMap((t) => [0.1, 0, 1.2, 0.1, 0, high(t) + 0.08]),
      ),
      link(
        "rope",
        "rope",
        times.flatMap((t) => [0, 0, high(t), ...far(t)]),
      ),
    ],
    obstacles: [
      {
        name: "floor",
        kind: "plane",
        radius: 0,
        length: null,
        pose: f32([0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0]),
      },
      {
        name: "stone",
        kind: "sphere",
        radius: 0.15,
        length: null,
        pose: f32([-0.5, 0, 0.15, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
      },
      {
        ...{ name: "drum", kind: "cylinder", radius: 0.12, length: 0.6 },
        pose: f32([0.3, 0.6, 0.12, 0, 1, 0, 0, 0, 1, 1, 0, 0]),
      },
    ],
    abscissa: { name: "t", unit: "s", values: f64(times) },
    charts: [
      {
        title: "box",
        group: "probes",
        log: false,
        columns: [{ name: "box.z", label: "z", unit: "m", values: f32(times.map(high)) }],
      },
    ],
  };
}

const body = (name, kind, first, box) => ({
  ...{ name, kind, first, count: 1, outline: [], inner: null, scale: null, nodes: [first], box },
});
const link = (name, kind, ends) => ({ name, kind, ends: f32(ends) });

/** `bodies` beams side by side with `count` stations each. */
export function many(bodies = 100, count = 1000, frames = 3) {
  const stations = bodies * count;
  const at = new Float32Array(3 * stations * frames);
  const reference = new Float32Array(3 * stations);
  const directors = new Int16Array(9 * stations * frames);
  const straight = turned(0);
  const values = new Uint16Array(stations * frames);
  for (let f = 0; f < frames; f++) {
    for (let i = 0; i < stations; i++) {
      const [s, row] = [(i % count) / (count - 1), Math.floor(i / count)];
      const k = f * stations + i;
      at.set([s, 0.1 * f * s * Math.sin(9 * s + row), row / bodies], 3 * k);
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
    ...empty(),
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
    centres: f32(at),
    directors: i16(directors),
    reference: { centres: f32(reference), directors: i16(directors.subarray(0, 9 * stations)) },
    abscissa: { name: "t", unit: "s", values: f64([]) },
  };
}
