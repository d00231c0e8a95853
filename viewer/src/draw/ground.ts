// Ground: grid, floors of contacts, and the level on which shadows fall.

import * as THREE from "three";
import { roundUp } from "../base/numbers";
import type { Obstacle, Scene, Vector } from "../scene/scene";
import { dot, horizontalAxes } from "../view/axes";
import type { Extent, Spheres } from "../view/extent";
import { GROUND_FRAGMENT, GROUND_VERTEX } from "./shaders/ground";

/** Colour and opacity of a floor. */
const FLOOR = new THREE.Vector4(0.56, 0.6, 0.65, 0.62);
/** Margin of a floor around the motion, and of the grid, relative to the diagonal of the motion. */
const MARGIN = 0.12;
const GRID_MARGIN = 0.3;
/** Distance of the grid below the motion, relative to the diagonal. */
const CLEARANCE = 0.03;
/** Cosine above which the normal of a plane is vertical. */
const VERTICAL = 0.999;

/** Distance between two lines of the grid. */
export function gridSpacing(scene: Scene): number {
  return roundUp(scene.size / 12);
}

/** Diagonal of the box around the motion. */
function diagonal({ box }: Extent): number {
  return Math.hypot(...box[0].map((low, k) => box[1][k] - low)) || 1;
}

function origin({ pose }: Obstacle): Vector {
  return [pose[0], pose[1], pose[2]];
}

/** Fixed horizontal plane below the motion that is the ground; null if there is none. */
export function floorOf(scene: Scene): Obstacle | null {
  const horizontal = ({ kind, pose }: Obstacle) =>
    kind === "plane" && pose.length === 12 && dot([pose[3], pose[4], pose[5]], scene.up) > VERTICAL;
  return scene.obstacles.find(horizontal) ?? null;
}

/** Coordinate of the ground along the vertical axis. */
export function groundLevel(scene: Scene, extent: Extent): number {
  const floor = floorOf(scene);
  if (floor) return dot(origin(floor), scene.up);
  return range(extent.motion, scene.up)[0] - CLEARANCE * diagonal(extent);
}

/** Range of spheres along an axis. */
function range(spheres: Spheres, axis: Vector): [number, number] {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < spheres.length; i += 4) {
    const x = spheres[i] * axis[0] + spheres[i + 1] * axis[1] + spheres[i + 2] * axis[2];
    low = Math.min(low, x - spheres[i + 3]);
    high = Math.max(high, x + spheres[i + 3]);
  }
  return low <= high ? [low, high] : [0, 0];
}

/** Rectangle with lines, spanned by two unit vectors from `from`; `limits` are coordinates along them. */
function linedPlane(
  from: Vector,
  [u, v]: [Vector, Vector],
  limits: [number, number, number, number],
  parameters: { spacing: number; face: THREE.Vector4; fade: number },
): THREE.Mesh {
  const [u0, v0, u1, v1] = limits;
  const corners = [
    [u0, v0],
    [u1, v0],
    [u1, v1],
    [u0, v1],
  ];
  const at = ([a, b]: number[]) => from.map((x, k) => x + a * u[k] + b * v[k]);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners.flatMap(at), 3));
  geometry.setAttribute("local", new THREE.Float32BufferAttribute(corners.flat(), 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  const material = new THREE.ShaderMaterial({
    vertexShader: GROUND_VERTEX,
    fragmentShader: GROUND_FRAGMENT,
    glslVersion: THREE.GLSL3,
    uniforms: {
      face: { value: parameters.face },
      spacing: { value: parameters.spacing },
      fade: { value: parameters.fade },
      bounds: { value: new THREE.Vector4(...limits) },
    },
    ...{ transparent: true, premultipliedAlpha: true, depthWrite: false, side: THREE.DoubleSide },
  });
  const plane = new THREE.Mesh(geometry, material);
  plane.frustumCulled = false;
  plane.renderOrder = -2;
  return plane;
}

/** Grid below the motion; nothing if a floor takes its place. */
export function groundGrid(scene: Scene, extent: Extent): THREE.Object3D {
  if (floorOf(scene)) return new THREE.Object3D();
  const { up } = scene;
  const [right, toward] = horizontalAxes(up);
  const margin = GRID_MARGIN * diagonal(extent);
  const [[u0, u1], [v0, v1]] = [range(extent.motion, right), range(extent.motion, toward)];
  const level = groundLevel(scene, extent);
  const from = up.map((x) => level * x) as Vector;
  return linedPlane(from, [toward, right], [v0 - margin, u0 - margin, v1 + margin, u1 + margin], {
    ...{ spacing: gridSpacing(scene), fade: margin },
    face: new THREE.Vector4(0, 0, 0, 0),
  });
}

/** Floor of a plane with its normal along x. A fixed one covers the whole motion. */
export function floorMesh(obstacle: Obstacle, scene: Scene, extent: Extent): THREE.Mesh {
  const { pose } = obstacle;
  const size = diagonal(extent);
  const margin = MARGIN * size;
  const axes = [6, 9].map((k) => [pose[k], pose[k + 1], pose[k + 2]] as Vector);
  const limits = axes.map((axis): [number, number] => {
    if (pose.length > 12) return [-0.75 * size, 0.75 * size];
    const [low, high] = range(extent.motion, axis);
    const own = dot(origin(obstacle), axis);
    return [low - own - margin, high - own + margin];
  });
  const [[u0, u1], [v0, v1]] = limits;
  return linedPlane(
    [0, 0, 0],
    [
      [0, 1, 0],
      [0, 0, 1],
    ],
    [u0, v0, u1, v1],
    { spacing: gridSpacing(scene), face: FLOOR, fade: 0 },
  );
}
