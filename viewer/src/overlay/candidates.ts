// Labels of a frame: names of bodies, joints and probes, values of reactions, node numbers.

import type { Settings } from "../base/settings";
import { formatQuantity } from "../base/units";
import { type FrameBlend, pointPosition, stationPosition } from "../scene/blend";
import { middleStation } from "../scene/geometry";
import { largestReactions, magnitude } from "../scene/reactions";
import type { Reaction, Scene, Vector } from "../scene/scene";

/** Upper limit on the number of node labels that are considered. */
const MAX_NODES = 3000;
/** Number of bodies above which their names are shown by the tooltip only. */
const MAX_BODIES = 40;

export type LabelKind = "marker" | "body" | "node";

export interface Label {
  /** Identity of the label in all frames. */
  key: string;
  name: string;
  /** Values such as "F 119.4 N". */
  values: string[];
  kind: LabelKind;
  position: Vector;
}

/** Scene with the reference positions of its points, the display options and the current frames. */
export interface LabelSource {
  scene: Scene;
  reference: Float32Array;
  settings: Settings;
  blend: FrameBlend;
}

/** Position of a marker. Its displacement is scaled if it has a reference position. */
function markerPosition({ scene, reference, blend }: LabelSource, index: number): Vector {
  const { at } = scene.markers[index];
  const first = 3 * (scene.stations + index);
  const own = reference.subarray(first, first + 3);
  return Number.isNaN(own[0])
    ? pointPosition(at, [0, 0, 0], 1, 0, { ...blend, scale: 1, imaginary: 0 })
    : pointPosition(at, own, 1, 0, blend);
}

/** Relative size below which a reaction is not shown. */
const NOISE = 1e-6;

/** Values such as "F 119.4 N" and "M 3.103 N m" in the prefix of the largest reaction. Noise is omitted. */
function reactionValues({ scene, blend }: LabelSource, reaction: Reaction): string[] {
  const force = scene.units?.force ?? "";
  const moment = scene.units ? `${force} ${scene.units.length}` : "";
  const largest = largestReactions(scene.reactions);
  const parts = [
    ["F", magnitude(reaction.force, blend), force, largest[0]],
    ["M", magnitude(reaction.moment, blend), moment, largest[1]],
  ] as const;
  return parts
    .filter(([, value, , reference]) => value > NOISE * reference)
    .map(([symbol, value, unit, reference]) => `${symbol} ${formatQuantity(value, unit, reference)}`);
}

/** Labels that the settings request, by decreasing priority. */
export function candidateLabels(source: LabelSource): Label[] {
  const { settings } = source;
  return [
    ...(settings.labels ? markerLabels(source) : []),
    ...(settings.labels ? bodyLabels(source) : []),
    ...(settings.nodes ? nodeLabels(source) : []),
  ];
}

/** One label per marker with its name and the values of its reaction; those with values first. */
function markerLabels(source: LabelSource): Label[] {
  const { scene, settings } = source;
  const reactions = new Map(settings.reactions ? scene.reactions.map((r) => [r.marker, r]) : []);
  const labels = scene.markers.map((marker, i): Label => {
    const reaction = reactions.get(i);
    const values = reaction ? reactionValues(source, reaction) : [];
    // The name of a load without a name is its path in the model.
    const name = marker.name.endsWith("]") ? marker.detail : marker.name;
    return {
      key: `marker ${i}`,
      name,
      values,
      kind: "marker",
      position: markerPosition(source, i),
    };
  });
  return [...labels.filter((_, i) => reactions.has(i)), ...labels.filter((_, i) => !reactions.has(i))];
}

function bodyLabels({ scene, blend }: LabelSource): Label[] {
  if (scene.bodies.length > MAX_BODIES) return [];
  return scene.bodies
    .filter((body) => body.count > 0)
    .map((body) => ({
      ...{ key: `body ${body.first}`, name: body.name, values: [], kind: "body" },
      position: stationPosition(scene, body.first + middleStation(body), blend),
    }));
}

function nodeLabels({ scene, blend }: LabelSource): Label[] {
  const labels: Label[] = [];
  let remaining = MAX_NODES;
  for (const body of scene.bodies) {
    body.nodes.slice(0, Math.max(0, remaining)).forEach((station, i) => {
      const position = stationPosition(scene, station, blend);
      labels.push({ key: `node ${station}`, name: String(i), values: [], kind: "node", position });
    });
    remaining -= body.nodes.length;
  }
  return labels;
}
