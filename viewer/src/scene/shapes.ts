// What shapes of vibration and buckling are called.

import { text } from "../base/dom";
import { isModal, type Scene } from "./scene";

/** "mode 3: 12.34 Hz", "form 1: load factor 2.5": the words before the number, the number, its unit. */
const VALUE = /^(.*: (?:load factor )?)([-+]?[\d.]+(?:e[-+]?\d+)?)(.*)$/i;

/** Names of the frames; those of shapes with six digits where the charts have them, or as rigid. */
export function names(scene: Scene): string[] | null {
  const { labels, values } = scene.frames;
  if (!labels || !isModal(scene)) return labels;
  const wanted = scene.analysis === "modes" ? "frequency" : "factor";
  const column = scene.charts.flatMap((c) => c.columns).find((c) => c.name === wanted);
  return labels.map((label, i) => {
    const [, before, number, unit] = label.match(VALUE) ?? [];
    if (number === undefined) return label;
    const short = Number(number);
    if (short === 0 && scene.analysis === "modes") return `${before}rigid`;
    const exact = column?.values[scene.abscissa.values.indexOf(values[i])] ?? Number.NaN;
    return Math.abs(exact - short) <= 1e-3 * Math.abs(short) ? `${before}${text(exact, 6)}${unit}` : label;
  });
}

/** The first shape that is not a motion as a rigid body. */
export function firstShape(scene: Scene): number {
  if (!isModal(scene)) return 0;
  return Math.max(0, scene.frames.labels?.findIndex((label) => !label.endsWith(": rigid")) ?? 0);
}
