// Magnitudes of the reactions of joints and of other vectors.

import type { FrameBlend } from "./blend";
import type { Numbers, Reaction, Vector } from "./scene";

/** Vector of an array [F][3] between two frames. */
export function vectorAt(vectors: Numbers, blend: FrameBlend): Vector {
  const component = (k: number) => {
    const [a, b] = [vectors[3 * blend.first + k], vectors[3 * blend.second + k]];
    return a + blend.weight * (b - a);
  };
  return [component(0), component(1), component(2)];
}

/** Magnitude of a vector [F][3] between two frames. */
export function magnitude(vectors: Numbers, blend: FrameBlend): number {
  return Math.hypot(...vectorAt(vectors, blend));
}

/** Largest magnitude of vectors. */
export function largestVector(vectors: Numbers): number {
  let largest = 0;
  for (let i = 0; i < vectors.length; i += 3) {
    const size = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (size > largest && Number.isFinite(size)) largest = size;
  }
  return largest;
}

/** Results of `largestReactions`, computed once per scene. */
const CACHE = new WeakMap<Reaction[], [number, number]>();

/** Largest magnitudes of force and moment over all reactions and frames. */
export function largestReactions(reactions: Reaction[]): [force: number, moment: number] {
  const cached = CACHE.get(reactions);
  if (cached) return cached;
  const largest: [number, number] = [
    Math.max(0, ...reactions.map((r) => largestVector(r.force))),
    Math.max(0, ...reactions.map((r) => largestVector(r.moment))),
  ];
  CACHE.set(reactions, largest);
  return largest;
}
