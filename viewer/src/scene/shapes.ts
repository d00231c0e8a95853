// Labels of vibration and buckling shapes.

import { formatNumber } from "../base/numbers";
import { isModal, type Scene } from "./scene";

/** Parts of a label: text, number, unit. Examples: "mode 3: 12.34 Hz", "shape 1: load factor 2.5". */
const LABEL = /^(.*: (?:load factor )?)([-+]?[\d.]+(?:e[-+]?\d+)?)(.*)$/i;

/** Labels of the frames. Labels of shapes get six digits if the charts have them, or the word "rigid". */
export function frameLabels(scene: Scene): string[] | null {
  const { labels, values } = scene.frames;
  if (!labels || !isModal(scene)) return labels;
  const name = scene.analysis === "modes" ? "frequency" : "factor";
  const column = scene.charts.flatMap((c) => c.columns).find((c) => c.name === name);
  return labels.map((label, i) => {
    const [, prefix, number, unit] = label.match(LABEL) ?? [];
    if (number === undefined) return label;
    const rounded = Number(number);
    if (rounded === 0 && scene.analysis === "modes") return `${prefix}rigid`;
    const exact = column?.values[scene.abscissa.values.indexOf(values[i])] ?? Number.NaN;
    return Math.abs(exact - rounded) <= 1e-3 * Math.abs(rounded)
      ? `${prefix}${formatNumber(exact, 6)}${unit}`
      : label;
  });
}

/** Index of the first shape that is not a rigid body mode. */
export function firstElasticShape(scene: Scene): number {
  if (!isModal(scene)) return 0;
  return Math.max(0, scene.frames.labels?.findIndex((label) => !label.endsWith(": rigid")) ?? 0);
}
