// Edges of the surface of a rigid body.

import type { Body } from "../scene/scene";
import type { MeshTemplate } from "./templates";

type Surface = NonNullable<Body["surface"]>;

/** Lines along the boundaries of a surface, and where its normal jumps: there, the triangles of both sides have points of their own. */
export function creases(surface: Surface): MeshTemplate {
  const { points, normals } = surface;
  const local: number[] = [];
  const normal: number[] = [];
  for (const k of creaseEnds(surface)) {
    local.push(...points.subarray(3 * k, 3 * k + 3));
    normal.push(...Array.from(normals.subarray(3 * k, 3 * k + 3), (n) => n / 32767));
  }
  const count = local.length / 3;
  return {
    ...{ isLines: true, local, normal },
    end: new Array(count).fill(0),
    face: new Array(2 * count).fill(0),
    index: Array.from({ length: count }, (_, i) => i),
  };
}

/** Indices of the points at the ends of the lines, two per line. */
function creaseEnds({ points, corners }: Surface): number[] {
  const place = places(points);
  const known = new Map<string, [start: number, end: number, smooth: boolean]>();
  for (let i = 0; i < corners.length; i++) {
    const [a, b] = [corners[i], corners[i % 3 === 2 ? i - 2 : i + 1]];
    const [start, end] = place[a] < place[b] ? [a, b] : [b, a];
    const key = `${place[start]} ${place[end]}`;
    const other = known.get(key);
    if (!other) known.set(key, [start, end, false]);
    else if (other[0] === start || other[1] === end) other[2] = true;
  }
  return [...known.values()].flatMap(([start, end, smooth]) => (smooth ? [] : [start, end]));
}

/** Number of the place of each point. Points of the two sides of a crease have the same place. */
function places(points: Surface["points"]): number[] {
  const numbers = new Map<string, number>();
  return Array.from({ length: points.length / 3 }, (_, i) => {
    const key = points.subarray(3 * i, 3 * i + 3).join(" ");
    const number = numbers.get(key) ?? numbers.size;
    numbers.set(key, number);
    return number;
  });
}
