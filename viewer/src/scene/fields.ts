// Values of fields: decoding, colour scale, values of the colour legend.

import { automaticMap } from "../base/colours";
import { largestMagnitude, suppressNoise } from "../base/numbers";
import type { Settings } from "../base/settings";
import { type DisplayUnit, displayUnit } from "../base/units";
import type { Field, Scene } from "./scene";

/** Value of a field at an index of its array, NaN where the field is undefined. */
export function fieldValue(field: Field, index: number): number {
  const [low, high] = field.range;
  const code = field.values[index];
  return code === 65535 ? Number.NaN : low + (code / 65534) * (high - low);
}

/** Colours of a field: map, values at both ends, unit for display. */
export interface ColourScale {
  map: string;
  low: number;
  high: number;
  unit: DisplayUnit;
}

/** Relative size of a value that has no effect on the sign of a field. */
const SIGN_NOISE = 1e-6;

/** Range of a field of a live run, which includes that of earlier data; else that of its values. */
function wholeRange(field: Field): [number, number] {
  const [low, high] = field.widest ?? field.range;
  return [low, high];
}

/** Colours of a field with the map and the limits that the user has selected; null stands for the automatic one. */
export function colourScale(field: Field, settings: Settings): ColourScale {
  const [least, most] = wholeRange(field);
  const bound = Math.max(Math.abs(least), Math.abs(most));
  const bothSigns = field.diverging && least < -SIGN_NOISE * bound && most > SIGN_NOISE * bound;
  const [own, end] = settings.limits[field.name] ?? [null, null];
  const low = own ?? (bothSigns ? -bound : least);
  const high = end ?? (bothSigns ? bound : most);
  const span = high > low ? high : low + (Math.abs(low) || 1);
  const unit = displayUnit(field.unit, Math.max(Math.abs(low), Math.abs(span)));
  return { map: settings.colourMap || automaticMap(bothSigns), low, high: span, unit };
}

/** Extends the ranges of the fields by those of earlier data of the same run. */
export function keepRanges(scene: Scene, earlier: Scene): void {
  for (const field of scene.fields) {
    const known = earlier.fields.find((f) => f.name === field.name && f.unit === field.unit);
    if (!known) continue;
    const [a, b] = [wholeRange(known), field.range];
    field.widest = [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
  }
}

/** Field that colours the bodies at first: the equivalent stress if there are beams or shells. */
export function defaultField(scene: Scene): string {
  const hasStress = scene.bodies.some(({ kind }) => kind === "beam" || kind === "shell");
  const stress = scene.fields.find((f) => f.name === "von Mises stress");
  return (hasStress && stress ? stress : scene.fields[0])?.name ?? "";
}

/** Five values in the unit for display from the top to the bottom of the colour map, rounded to 1e-4 of the range. */
export function legendValues(scene: Scene, field: Field, { low, high, unit }: ColourScale): number[] {
  const sameUnit = scene.fields.filter((f) => f === field || (f.unit === field.unit && f.unit !== ""));
  const reference = Math.max(...sameUnit.map((f) => largestMagnitude(f.range)));
  const step = 10 ** Math.floor(Math.log10(Math.max(high - low, 1e-300)) - 4);
  const value = (i: number) => (low === -high && i === 2 ? 0 : high + (i / 4) * (low - high));
  return [0, 1, 2, 3, 4]
    .map((i) => suppressNoise(value(i), reference))
    .map((x) => (Math.abs(x) < step ? 0 : x))
    .map((x) => x / unit.size);
}
