// Scene with rigid bodies, links and obstacles.

import { f32, f64, i16 } from "./container.mjs";
import { emptyScene, rotatedDirectors } from "./scene.mjs";

const TIMES = Array.from({ length: 21 }, (_, i) => i / 20);
const boxHeight = (t) => 0.5 + 0.2 * Math.cos(2 * Math.PI * t);
const ballPosition = (t) => [0.7, 0.3 * Math.sin(2 * Math.PI * t), 0.35];

/** Box and point mass on springs above a plane, beside a sphere and a cylinder. The run has failed. */
export function machine() {
  const identity = rotatedDirectors(0);
  const heights = { name: "box.z", label: "z", unit: "m", values: f32(TIMES.map(boxHeight)) };
  return {
    ...emptyScene(),
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
    frames: { count: TIMES.length, values: f64(TIMES), labels: null },
    bodies: [body("box", "rigid", 0, [0.15, 0.1, 0.08]), body("ball", "point", 1, [0.06, 0.06, 0.06])],
    centres: vectors((t) => [0, 0, boxHeight(t), ...ballPosition(t)]),
    directors: i16(TIMES.flatMap((t) => [...rotatedDirectors(0.5 * t), ...identity])),
    reference: { centres: f32([0, 0, 0.5, 0.7, 0, 0.35]), directors: i16([...identity, ...identity]) },
    markers: [
      { name: "hook", kind: "joint", detail: "fixed", at: vectors(() => [0, 0, 1.2]) },
      { name: "push", kind: "load", detail: "force", at: vectors(ballPosition) },
    ],
    links: links(),
    obstacles: obstacles(),
    abscissa: { name: "t", unit: "s", values: f64(TIMES) },
    charts: [{ title: "box", group: "probes", log: false, columns: [heights] }],
  };
}

/** Values of a vector function at all times. */
function vectors(vector) {
  return f32(TIMES.flatMap((t) => vector(t)));
}

function body(name, kind, first, box) {
  return { name, kind, first, count: 1, outline: [], inner: null, scale: null, nodes: [first], box };
}

function links() {
  const link = (kind, ends) => ({ name: kind, kind, ends: vectors(ends) });
  return [
    link("spring", (t) => [0, 0, 1.2, 0, 0, boxHeight(t) + 0.08]),
    link("damper", (t) => [0.1, 0, 1.2, 0.1, 0, boxHeight(t) + 0.08]),
    link("rope", (t) => [0, 0, boxHeight(t), ...ballPosition(t)]),
  ];
}

function obstacles() {
  const obstacle = (name, kind, radius, length, pose) => ({ name, kind, radius, length, pose: f32(pose) });
  return [
    obstacle("floor", "plane", 0, null, [0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0]),
    obstacle("stone", "sphere", 0.15, null, [-0.5, 0, 0.15, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
    obstacle("drum", "cylinder", 0.12, 0.6, [0.3, 0.6, 0.12, 0, 1, 0, 0, 0, 1, 1, 0, 0]),
  ];
}
