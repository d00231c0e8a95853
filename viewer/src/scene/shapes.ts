// Labels of vibration and buckling modes.

import { formatNumber } from "../base/numbers";
import { isModal, type Scene } from "./scene";

/** Parts of a label such as "mode 3: 12.34 Hz" or "buckling mode 1: load factor 2.5": text, number, unit. */
const LABEL = /^(.*: (?:load factor )?)([-+]?[\d.]+(?:e[-+]?\d+)?)(.*)$/i;

/** Labels of the frames. Numbers in labels of modes have six digits if the charts contain them. Rigid-body modes have the word "rigid". */
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

/** Index of the first mode that is not a rigid-body mode. */
export function firstElasticShape(scene: Scene): number {
  if (!isModal(scene)) return 0;
  return Math.max(0, scene.frames.labels?.findIndex((label) => !label.endsWith(": rigid")) ?? 0);
}
