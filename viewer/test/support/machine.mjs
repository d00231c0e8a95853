// Scene with rigid bodies, links and obstacles.

import { f32, f64, i16 } from "./container.mjs";
import { emptyScene, rotatedDirectors } from "./scene.mjs";

/** Box and point mass on springs above a plane, beside a sphere and a cylinder. The run has failed. */
export function machine() {
  const frames = 21;
  const times = Array.from({ length: frames }, (_, i) => i / 20);
  const height = (t) => 0.5 + 0.2 * Math.cos(2 * Math.PI * t);
  const ballPosition = (t) => [0.7, 0.3 * Math.sin(2 * Math.PI * t), 0.35];
  const identity = rotatedDirectors(0);
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
    frames: { count: frames, values: f64(times), labels: null },
    bodies: [body("box", "rigid", 0, [0.15, 0.1, 0.08]), body("ball", "point", 1, [0.06, 0.06, 0.06])],
    centres: f32(times.flatMap((t) => [0, 0, height(t), ...ballPosition(t)])),
    directors: i16(times.flatMap((t) => [...rotatedDirectors(0.5 * t), ...identity])),
    reference: { centres: f32([0, 0, 0.5, 0.7, 0, 0.35]), directors: i16([...identity, ...identity]) },
    markers: [
      { name: "hook", kind: "joint", detail: "fixed", at: f32(times.flatMap(() => [0, 0, 1.2])) },
      { name: "push", kind: "load", detail: "force", at: f32(times.flatMap((t) => ballPosition(t))) },
    ],
    links: [
      link(
        "spring",
        "spring",
        times.flatMap((t) => [0, 0, 1.2, 0, 0, height(t) + 0.08]),
      ),
      link(
        "damper",
        "damper",
        times.flatMap((t) => [0.1, 0, 1.2, 0.1, 0, height(t) + 0.08]),
      ),
      link(
        "rope",
        "rope",
        times.flatMap((t) => [0, 0, height(t), ...ballPosition(t)]),
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
        columns: [{ name: "box.z", label: "z", unit: "m", values: f32(times.map(height)) }],
      },
    ],
  };
}

const body = (name, kind, first, box) => ({
  ...{ name, kind, first, count: 1, outline: [], inner: null, scale: null, nodes: [first], box },
});
const link = (name, kind, ends) => ({ name, kind, ends: f32(ends) });
