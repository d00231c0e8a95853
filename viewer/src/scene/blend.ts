// Interpolation between frames on the CPU, and motion of complex shapes. The shaders use the same formulas (see draw/shaders/point.ts).

import { fieldValue } from "./fields";
import type { Field, Numbers, Scene, Vector } from "./scene";

/** Interpolation between two frames, and the scale factors of the displacements. */
export interface FrameBlend {
  first: number;
  second: number;
  /** Weight of the second frame, 0 to 1. */
  weight: number;
  /** Scale factor of the displacements from the reference configuration. */
  scale: number;
  /** Scale factor of the displacements of the second frame, which are added: the imaginary part of a complex shape. */
  imaginary: number;
}

/** Displacement r + scale (x - r) + imaginary (b - r) of a coordinate between the frames a and b with the reference r. */
export function blended(a: number, b: number, r: number, blend: FrameBlend): number {
  const x = a + blend.weight * (b - a);
  return r + blend.scale * (x - r) + blend.imaginary * (b - r);
}

/** Position of point `index` of an array [F][count][3] with reference [count][3]. */
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
  const component = (k: number) => blended(frames[a + k], frames[b + k], reference[r + k], blend);
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
