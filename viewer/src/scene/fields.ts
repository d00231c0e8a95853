// Values of fields: decoding, and the values of the colour legend.

import { colourRange } from "../base/colours";
import { largestMagnitude, suppressNoise } from "../base/numbers";
import type { Field, Scene } from "./scene";

/** Value of a field at an index of its array, NaN where the field is undefined. */
export function fieldValue(field: Field, index: number): number {
  const [low, high] = field.range;
  const code = field.values[index];
  return code === 65535 ? Number.NaN : low + (code / 65534) * (high - low);
}

/** Five values from the top to the bottom of the colour map, without rounding noise. */
export function legendValues(scene: Scene, field: Field): number[] {
  const sameUnit = scene.fields.filter((f) => f === field || (f.unit === field.unit && f.unit !== ""));
  const reference = Math.max(...sameUnit.map((f) => largestMagnitude(f.range)));
  const [low, high] = colourRange(field.range, field.diverging);
  const value = (i: number) => (field.diverging && i === 2 ? 0 : high + (i / 4) * (low - high));
  return [0, 1, 2, 3, 4].map((i) => suppressNoise(value(i), reference));
}
