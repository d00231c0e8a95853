// Interpolation between frames on the CPU. The shaders use the same formulas (see draw/shaders/point.ts).

import { fieldValue } from "./fields";
import type { Field, Numbers, Scene, Vector } from "./scene";

/** Interpolation between two frames, and the scale factor of the displacements. */
export interface FrameBlend {
  first: number;
  second: number;
  /** Weight of the second frame, 0 to 1. */
  weight: number;
  /** Scale factor of the displacements from the reference configuration. */
  scale: number;
}

/** Position r + scale (x - r) of point `index` of an array [F][count][3] with reference [count][3]. */
export function pointPosition(
  frames: Numbers,
  reference: ArrayLike<number>,
  count: number,
  index: number,
  blend: FrameBlend,
): Vector {
  const a = 3 * (blend.first * count + index);
  const b = 3 * (blend.second * count + index);
  const r = 3 * index;
  const component = (k: number) => {
    const x = frames[a + k] + blend.weight * (frames[b + k] - frames[a + k]);
    return reference[r + k] + blend.scale * (x - reference[r + k]);
  };
  return [component(0), component(1), component(2)];
}

/** Drawn position of a station. */
export function stationPosition(scene: Scene, index: number, blend: FrameBlend): Vector {
  return pointPosition(scene.centres, scene.reference.centres, scene.stations, index, blend);
}

/** Value of a field at a station, NaN where the field is undefined. */
export function fieldAt(scene: Scene, field: Field, index: number, blend: FrameBlend): number {
  const a = fieldValue(field, blend.first * scene.stations + index);
  const b = fieldValue(field, blend.second * scene.stations + index);
  return a + blend.weight * (b - a);
}
