// What is drawn at an instant, on the CPU: the same formula as in the shader (see shader.ts).

import { type Body, type Field, fieldValue, type Numbers, type Scene, type Vector } from "./scene";

/** A place between two frames, and how much the displacements from the reference shape are enlarged. */
export interface Instant {
  first: number;
  second: number;
  weight: number;
  scale: number;
}

/** Position r + scale (x - r) of point `index` of an array [F][count][3] with reference [count][3]. */
export function place(at: Numbers, reference: Numbers, count: number, index: number, now: Instant): Vector {
  const a = 3 * (now.first * count + index);
  const b = 3 * (now.second * count + index);
  const r = 3 * index;
  const one = (k: number) => {
    const x = at[a + k] + now.weight * (at[b + k] - at[a + k]);
    return reference[r + k] + now.scale * (x - reference[r + k]);
  };
  return [one(0), one(1), one(2)];
}

/** Drawn position of a station. */
export function station(scene: Scene, index: number, now: Instant): Vector {
  return place(scene.centres, scene.reference.centres, scene.stations, index, now);
}

/** Value of a field at a station, NaN where it has none. */
export function valueAt(scene: Scene, field: Field, index: number, now: Instant): number {
  const a = fieldValue(field, now.first * scene.stations + index);
  const b = fieldValue(field, now.second * scene.stations + index);
  return a + now.weight * (b - a);
}

export function distance(a: ArrayLike<number>, b: ArrayLike<number>): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/** Arc length of the reference shape from the body's first station to station `index` of the body. */
export function arc(scene: Scene, body: Body, index: number): number {
  const at = scene.reference.centres;
  let sum = 0;
  for (let i = body.first; i < body.first + index; i++) {
    sum += distance(at.subarray(3 * i, 3 * i + 3), at.subarray(3 * i + 3, 3 * i + 6));
  }
  return sum;
}

/** Half the largest measure of a body's section, or of the box of a rigid body. */
export function radius(body: Body): number {
  if (body.box) return body.kind === "point" ? body.box[0] : Math.hypot(...body.box);
  let most = 0;
  for (const [y, z] of body.outline) most = Math.max(most, Math.hypot(y, z));
  return most;
}
