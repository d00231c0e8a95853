// Scene of a vibrating cantilever with known displacements.

import { f32, f64, i16 } from "./container.mjs";
import { rectangle } from "./outlines.mjs";
import { emptyScene, encodeField, rotatedDirectors } from "./scene.mjs";

/** Deflection at s of a cantilever of length one under an end load (Euler-Bernoulli): w = d (3 s² - s³)/2. */
export const deflection = (s, d) => (d * (3 * s * s - s ** 3)) / 2;
const slope = (s, d) => (d * (6 * s - 3 * s * s)) / 2;

/** Deflection of the tip at time t. */
export const tipDeflection = (t) => -0.25 * Math.sin(Math.PI * t);

/** Vibrating cantilever with 41 stations and `frames` frames from t = 0 to `until`. */
export function cantilever({ frames = 41, live = false, until = 2, nan = false } = {}) {
  const count = 41;
  const times = Array.from({ length: frames }, (_, i) => (frames > 1 ? (until * i) / (frames - 1) : 0));
  const along = Array.from({ length: count }, (_, i) => i / (count - 1));
  const stations = times.flatMap((t) => along.map((s) => [s, tipDeflection(t)]));
  const moment = stations.map(([s, d], i) => (nan && i % count < 8 ? Number.NaN : 300 * d * (1 - s)));
  const speed = times.flatMap((t) => along.map((s) => Math.abs(deflection(s, 0.8 * Math.cos(Math.PI * t)))));
  const rows = Array.from({ length: 401 }, (_, i) => (until * i) / 400);
  return {
    ...emptyScene(),
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
    centres: f32(stations.flatMap(([s, d]) => [s, deflection(s, d), 0])),
    directors: i16(stations.flatMap(([s, d]) => rotatedDirectors(Math.atan(slope(s, d))))),
    reference: {
      centres: f32(along.flatMap((s) => [s, 0, 0])),
      directors: i16(along.flatMap(() => rotatedDirectors(0))),
    },
    fields: [
      {
        ...{ name: "bending moment", symbol: "M", unit: "N m", diverging: true, range: [-75, 75] },
        values: encodeField(moment, [-75, 75]),
      },
      {
        name: "speed",
        symbol: "v",
        unit: "m/s",
        diverging: false,
        range: [0, 0.8],
        values: encodeField(speed, [0, 0.8]),
      },
    ],
    markers: [
      { name: "root", kind: "joint", detail: "clamp", at: f32(times.flatMap(() => [0, 0, 0])) },
      {
        name: "tip",
        kind: "probe",
        detail: "end of rod",
        at: f32(times.flatMap((t) => [1, tipDeflection(t), 0])),
      },
    ],
    reactions: [
      {
        ...{ name: "root", marker: 0, force: f32(times.flatMap((t) => [0, -40 * tipDeflection(t), 0])) },
        moment: f32(times.flatMap((t) => [0, 0, -300 * tipDeflection(t)])),
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
        column("tip.y", "y", "m", t.map(tipDeflection)),
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
          t.map((x) => -40 * tipDeflection(x)),
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
