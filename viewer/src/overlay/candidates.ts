// Labels of a frame: names of bodies, joints and probes, values of reactions, node numbers.

import { formatQuantity, suppressNoise } from "../base/numbers";
import type { Settings } from "../base/settings";
import { type FrameBlend, pointPosition, stationPosition } from "../scene/blend";
import { largestReactions, magnitude } from "../scene/reactions";
import type { Reaction, Scene, Vector } from "../scene/scene";

/** Upper limit on the number of node labels that are considered. */
const MAX_NODES = 3000;
/** Number of bodies above which their names are shown by the tooltip only. */
const MAX_BODIES = 40;

export type LabelKind = "body" | "marker" | "reaction" | "node";

export interface Label {
  /** Lines of text, joined to one line if there is space. */
  lines: string[];
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
    ? pointPosition(at, [0, 0, 0], 1, 0, { ...blend, scale: 1 })
    : pointPosition(at, own, 1, 0, blend);
}

/** Lines such as "F 119.4 N" and "M 3.103 N m". Rounding noise is omitted. */
function reactionLines({ scene, blend }: LabelSource, reaction: Reaction): string[] {
  const force = scene.units?.force ?? "";
  const length = scene.units?.length ?? "";
  const [largestForce, largestMoment] = largestReactions(scene.reactions);
  const f = suppressNoise(magnitude(reaction.force, blend), largestForce);
  const m = suppressNoise(magnitude(reaction.moment, blend), largestMoment);
  return [
    ...(f > 0 ? [`F ${formatQuantity(f, force)}`] : []),
    ...(m > 0 ? [`M ${formatQuantity(m, force && `${force} ${length}`)}`] : []),
  ];
}

/** Labels that the settings request, by decreasing priority. */
export function candidateLabels(source: LabelSource): Label[] {
  const { settings } = source;
  return [
    ...(settings.labels ? markerLabels(source) : []),
    ...(settings.reactions ? reactionLabels(source) : []),
    ...(settings.labels ? bodyLabels(source) : []),
    ...(settings.nodes ? nodeLabels(source) : []),
  ];
}

function markerLabels(source: LabelSource): Label[] {
  return source.scene.markers.map((marker, i) => ({
    lines: [marker.name],
    kind: "marker",
    position: markerPosition(source, i),
  }));
}

/** Labels of the reactions; of several reactions at one marker, the last one. */
function reactionLabels(source: LabelSource): Label[] {
  const byMarker = new Map(source.scene.reactions.map((r) => [r.marker, r]));
  return [...byMarker].flatMap(([marker, reaction]): Label[] => {
    const lines = reactionLines(source, reaction);
    return lines.length > 0 ? [{ lines, kind: "reaction", position: markerPosition(source, marker) }] : [];
  });
}

function bodyLabels({ scene, blend }: LabelSource): Label[] {
  if (scene.bodies.length > MAX_BODIES) return [];
  return scene.bodies
    .filter((body) => body.count > 0)
    .map((body) => ({
      lines: [body.name],
      kind: "body",
      position: stationPosition(scene, body.first + (body.count >> 1), blend),
    }));
}

function nodeLabels({ scene, blend }: LabelSource): Label[] {
  const labels: Label[] = [];
  let remaining = MAX_NODES;
  for (const body of scene.bodies) {
    body.nodes.slice(0, Math.max(0, remaining)).forEach((station, i) => {
      labels.push({ lines: [String(i)], kind: "node", position: stationPosition(scene, station, blend) });
    });
    remaining -= body.nodes.length;
  }
  return labels;
}
