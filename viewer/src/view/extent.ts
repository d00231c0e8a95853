// Points that the camera frames: bodies, obstacles, symbols and arrows in all frames.

import { blended, type FrameBlend } from "../scene/blend";
import { bodyRadius, surfaceBox } from "../scene/geometry";
import { largestReactions, largestVector } from "../scene/reactions";
import { type Body, isModal, type Obstacle, type Scene, type Vector } from "../scene/scene";

/** Number of cells of the filter along each axis. */
const CELLS = 48;
/** Length of the longest arrow, relative to the diagonal of the box around the motion. */
const ARROW = 0.14;
/** Length of the longest arrow of a load on a shell, relative to that of the longest arrow. */
export const LOAD_ARROW = 0.6;
/** Radius of an obstacle, relative to the diagonal of the motion, above which it is not framed. */
const MAX_OBSTACLE = 1;

/** Number of phases of a complex shape that are framed. */
const PHASES = 8;

/** Points as x, y, z, radius. */
export type Spheres = Float32Array;

export interface Extent {
  /** Bodies, markers, links and obstacles in all frames. */
  motion: Spheres;
  /** Centre lines of the bodies, markers and links. */
  lines: Spheres;
  /** Tips of the arrows of reactions and of loads on shells. */
  arrows: Spheres;
  /** Corners of the box around the motion without obstacles. */
  box: [Vector, Vector];
  /** Length of the longest arrow. */
  arrow: number;
}

/**
 * Filter of points that keeps those near the convex hull: the two outermost points of each row of cells along x, y and z.
 * The support function of the points changes by less than 2 % of the box.
 */
class HullFilter {
  /** Outermost points by axis and side; NaN marks an empty row. */
  private readonly rows = new Float32Array(6 * CELLS * CELLS * 4).fill(Number.NaN);
  private readonly scale: number[];

  constructor(private readonly box: [Vector, Vector]) {
    this.scale = box[0].map((low, k) => (box[1][k] > low ? CELLS / (box[1][k] - low) : 0));
  }

  private cell(x: number, k: number): number {
    return Math.min(CELLS - 1, Math.max(0, Math.floor((x - this.box[0][k]) * this.scale[k])));
  }

  add(x: number, y: number, z: number, radius: number): void {
    const { rows } = this;
    const [i, j, k] = [this.cell(x, 0), this.cell(y, 1), this.cell(z, 2)];
    for (let axis = 0; axis < 3; axis++) {
      const row = axis === 0 ? j * CELLS + k : axis === 1 ? k * CELLS + i : i * CELLS + j;
      const own = axis === 0 ? x : axis === 1 ? y : z;
      for (let side = 0; side < 2; side++) {
        const at = 4 * ((2 * axis + side) * CELLS * CELLS + row);
        const known = rows[at + axis];
        const outside =
          side === 0 ? own - radius < known - rows[at + 3] : own + radius > known + rows[at + 3];
        if (outside || Number.isNaN(known)) {
          rows[at] = x;
          rows[at + 1] = y;
          rows[at + 2] = z;
          rows[at + 3] = radius;
        }
      }
    }
  }

  spheres(): Spheres {
    const list: number[] = [];
    for (let at = 0; at < this.rows.length; at += 4) {
      if (!Number.isNaN(this.rows[at])) list.push(...this.rows.subarray(at, at + 4));
    }
    return Float32Array.from(list);
  }
}

/** Frames with the factors of their displacements that are drawn: both extremes of a shape, some phases of a complex one. */
function drawnFrames(scene: Scene, deformation: number): FrameBlend[] {
  const { count, imaginary } = scene.frames;
  const all = Array.from({ length: count }, (_, first) => first);
  const one = (first: number, scale: number) => ({ first, second: first, weight: 0, scale, imaginary: 0 });
  if (!isModal(scene)) return all.map((first) => one(first, deformation));
  return all.flatMap((first) => {
    const second = imaginary?.[first] ?? null;
    if (second === null) return [one(first, deformation), one(first, -deformation)];
    const phases = Array.from({ length: PHASES }, (_, i) => (2 * Math.PI * i) / PHASES);
    return phases.map((phase) => ({
      ...{ first, second, weight: 0 },
      ...{ scale: deformation * Math.sin(phase), imaginary: deformation * Math.cos(phase) },
    }));
  });
}

/** Function of a point and of a radius around it. */
type AddPoint = (x: number, y: number, z: number, radius: number) => void;

/** Calls `add` for all stations, markers and ends of links in all frames, with scaled displacements. */
function forEachPoint(scene: Scene, deformation: number, add: AddPoint): void {
  const { centres, reference, stations } = scene;
  const blends = drawnFrames(scene, deformation);
  for (const body of scene.bodies) {
    const scales = body.scale ? Math.max(...body.scale) : 1;
    const radius = body.surface ? 0 : bodyRadius(body) * Math.max(1, scales);
    for (const blend of blends) {
      for (let i = body.first; i < body.first + body.count; i++) {
        const [a, b, r] = [3 * (blend.first * stations + i), 3 * (blend.second * stations + i), 3 * i];
        const at = (k: number) => blended(centres[a + k], centres[b + k], reference.centres[r + k], blend);
        add(at(0), at(1), at(2), radius);
      }
    }
  }
  for (const marker of scene.markers) {
    for (let i = 0; i + 2 < marker.at.length; i += 3)
      add(marker.at[i], marker.at[i + 1], marker.at[i + 2], 0);
  }
  for (const { ends } of scene.links) {
    for (let i = 0; i + 2 < ends.length; i += 3) add(ends[i], ends[i + 1], ends[i + 2], 0);
  }
}

/** Calls `add` for the corners of the boxes around the surfaces of all rigid bodies in all frames. */
function forEachCorner(scene: Scene, deformation: number, add: AddPoint): void {
  const blends = drawnFrames(scene, deformation);
  for (const body of scene.bodies) if (body.surface) forEachCornerOf(body, scene, blends, add);
}

/** Calls `add` for the corners of the box around the surface of a rigid body in all frames. */
function forEachCornerOf(body: Body, scene: Scene, blends: FrameBlend[], add: AddPoint): void {
  const { centres, directors, reference, stations } = scene;
  const [low, high] = surfaceBox(body);
  for (const blend of blends) {
    const [a, b] = [blend.first * stations + body.first, blend.second * stations + body.first];
    const centre = (k: number) =>
      blended(centres[3 * a + k], centres[3 * b + k], reference.centres[3 * body.first + k], blend);
    const director = (k: number) =>
      blended(directors[9 * a + k], directors[9 * b + k], reference.directors[9 * body.first + k], blend);
    for (let corner = 0; corner < 8; corner++) {
      const arm = [0, 1, 2].map((k) => ((corner >> k) & 1 ? high : low)[k] / 32767);
      const at = (k: number) => centre(k) + arm.reduce((sum, x, j) => sum + x * director(3 * j + k), 0);
      add(at(0), at(1), at(2), 0);
    }
  }
}

/** Calls `add` for points of spheres and cylinders of moderate size in all their poses. */
function forEachObstaclePoint(obstacles: Obstacle[], size: number, add: AddPoint): void {
  for (const { kind, radius, length, pose } of obstacles) {
    if (kind === "plane" || radius > MAX_OBSTACLE * size || (kind === "cylinder" && length === null))
      continue;
    for (let p = 0; p + 11 < pose.length; p += 12) {
      if (kind === "sphere") add(pose[p], pose[p + 1], pose[p + 2], radius);
      for (let i = 0; kind === "cylinder" && i < 32; i++) {
        const [half, angle] = [(i < 16 ? 0.5 : -0.5) * (length ?? 0), (Math.PI * i) / 8];
        const [c, s] = [radius * Math.cos(angle), radius * Math.sin(angle)];
        const at = (k: number) =>
          pose[p + k] + half * pose[p + 3 + k] + c * pose[p + 6 + k] + s * pose[p + 9 + k];
        add(at(0), at(1), at(2), 0);
      }
    }
  }
}

/** Box around the centre lines and the surfaces, of finite size. */
function motionBox(scene: Scene, deformation: number): [Vector, Vector] {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  const add = (...point: Vector) => {
    for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], point[k]);
      high[k] = Math.max(high[k], point[k]);
    }
  };
  forEachPoint(scene, deformation, add);
  forEachCorner(scene, deformation, add);
  if (low.every(Number.isFinite) && high.every(Number.isFinite)) return [low, high];
  const half = 0.5 * scene.size;
  return [
    [-half, -half, -half],
    [half, half, half],
  ];
}

/** Tips of the arrows of all reactions in all frames. */
function arrowTips(scene: Scene, arrow: number, add: (x: number, y: number, z: number) => void): void {
  const [force, moment] = largestReactions(scene.reactions);
  for (const reaction of scene.reactions) {
    const { at } = scene.markers[reaction.marker];
    for (const [vectors, largest] of [[reaction.force, force] as const, [reaction.moment, moment] as const]) {
      if (largest === 0) continue;
      const factor = arrow / largest;
      for (let i = 0; i + 2 < at.length; i += 3) {
        add(
          at[i] + factor * vectors[i],
          at[i + 1] + factor * vectors[i + 1],
          at[i + 2] + factor * vectors[i + 2],
        );
      }
    }
  }
}

/** Tips of the arrows of the loads on shells in all frames. */
function loadTips(scene: Scene, arrow: number, add: (x: number, y: number, z: number) => void): void {
  for (const { stations: own, vectors } of scene.loads) {
    const largest = largestVector(vectors);
    if (largest === 0) continue;
    const factor = (LOAD_ARROW * arrow) / largest;
    for (let f = 0; f < scene.frames.count; f++) {
      own.forEach((station, k) => {
        const [base, tip] = [3 * (f * scene.stations + station), 3 * (f * own.length + k)];
        const at = (i: number) => scene.centres[base + i] + factor * vectors[tip + i];
        add(at(0), at(1), at(2));
      });
    }
  }
}

/** Extent of a scene with displacements that are scaled by `deformation`; with the reference configuration if requested. */
export function extentOf(scene: Scene, deformation: number, withReference: boolean): Extent {
  const box = motionBox(scene, deformation);
  const size = Math.hypot(...box[0].map((low, k) => box[1][k] - low)) || scene.size;
  const [lines, motion, tips] = [new HullFilter(box), new HullFilter(box), new HullFilter(box)];
  forEachPoint(scene, deformation, (x, y, z, radius) => {
    lines.add(x, y, z, 0);
    motion.add(x, y, z, radius);
  });
  forEachCorner(scene, deformation, (x, y, z, radius) => motion.add(x, y, z, radius));
  const { centres } = scene.reference;
  for (let i = 0; withReference && i < centres.length; i += 3) {
    motion.add(centres[i], centres[i + 1], centres[i + 2], 0);
  }
  forEachObstaclePoint(scene.obstacles, size, (x, y, z, radius) => motion.add(x, y, z, radius));
  const arrow = ARROW * size;
  arrowTips(scene, arrow, (x, y, z) => tips.add(x, y, z, 0));
  loadTips(scene, arrow, (x, y, z) => tips.add(x, y, z, 0));
  return { motion: motion.spheres(), lines: lines.spheres(), arrows: tips.spheres(), box, arrow };
}
