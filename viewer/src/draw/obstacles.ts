// What stands still or moves as a whole: obstacles and the grid on the ground.

import * as THREE from "three";
import type { Instant } from "../scene/blend";
import type { Obstacle, Scene, Vector } from "../scene/scene";

/** A round number (1, 2 or 5 times a power of ten) not below `x`. */
export function roundUp(x: number): number {
  if (!(x > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([1, 2, 5, 10].find((m) => m * power >= x * (1 - 1e-9)) ?? 10);
}

const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Side of the grid's squares. */
export function mesh(scene: Scene): number {
  return roundUp(scene.size / 12);
}

/** Squares of lines below everything that is drawn, across `scene.up`. */
export function grid(scene: Scene): THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial> {
  const { bounds, up, size } = scene;
  const step = mesh(scene);
  const [u, v] = sideways(up);
  const middle = bounds[0].map((low, k) => 0.5 * (low + bounds[1][k])) as Vector;
  const level = dot(up, middle) - 0.5 * Math.abs(dot(up, bounds[1]) - dot(up, bounds[0])) - 0.03 * size;
  const extent = (w: Vector) => {
    const half = 0.5 * Math.abs(dot(w, bounds[1]) - dot(w, bounds[0])) + 0.25 * size;
    return [Math.floor((dot(w, middle) - half) / step), Math.ceil((dot(w, middle) + half) / step)];
  };
  const [[u0, u1], [v0, v1]] = [extent(u), extent(v)];
  const positions: number[] = [];
  const put = (a: number, b: number) => {
    for (let k = 0; k < 3; k++) positions.push(step * (a * u[k] + b * v[k]) + level * up[k]);
  };
  for (let a = u0; a <= u1; a++) {
    put(a, v0);
    put(a, v1);
  }
  for (let b = v0; b <= v1; b++) {
    put(u0, b);
    put(u1, b);
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(positions, 3));
  const material = new THREE.LineBasicMaterial({
    color: 0x808890,
    transparent: true,
    opacity: 0.3,
    depthWrite: false,
  });
  return new THREE.LineSegments(geometry, material);
}

/** The two axes across `up`: to the right and towards the viewer of the front view. */
export function sideways(up: Vector): [Vector, Vector] {
  const most = up.map(Math.abs).indexOf(Math.max(...up.map(Math.abs)));
  const right: Vector = most === 0 ? [0, 1, 0] : [1, 0, 0];
  const toward: Vector = [
    right[1] * up[2] - right[2] * up[1],
    right[2] * up[0] - right[0] * up[2],
    right[0] * up[1] - right[1] * up[0],
  ];
  return [right, toward];
}

export class Obstacles {
  readonly group = new THREE.Group();

  constructor(private readonly scene: Scene) {
    for (const obstacle of scene.obstacles) this.group.add(solid(obstacle, scene));
    this.instant = { first: 0, second: 0, weight: 0, scale: 1 };
  }

  set instant(now: Instant) {
    this.scene.obstacles.forEach((obstacle, i) => {
      const object = this.group.children[i];
      pose(obstacle, now).decompose(object.position, object.quaternion, object.scale);
    });
  }
}

function pose({ pose: p }: Obstacle, now: Instant): THREE.Matrix4 {
  const still = p.length === 12;
  const [a, b] = still ? [0, 0] : [12 * now.first, 12 * now.second];
  const x = Array.from({ length: 12 }, (_, k) => p[a + k] + now.weight * (p[b + k] - p[a + k]));
  return new THREE.Matrix4().set(
    x[3],
    x[6],
    x[9],
    x[0],
    x[4],
    x[7],
    x[10],
    x[1],
    x[5],
    x[8],
    x[11],
    x[2],
    0,
    0,
    0,
    1,
  );
}

/** A body whose first axis is the normal of a plane or the axis of a cylinder. */
function solid(obstacle: Obstacle, scene: Scene): THREE.Object3D {
  const [low, high] = scene.bounds;
  const reach = Math.max(scene.size, Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]));
  if (obstacle.kind === "plane") return plane(0.75 * reach);
  const geometry =
    obstacle.kind === "sphere"
      ? new THREE.SphereGeometry(obstacle.radius, 48, 24)
      : new THREE.CylinderGeometry(obstacle.radius, obstacle.radius, obstacle.length ?? 2 * reach, 64, 1);
  if (obstacle.kind !== "sphere") geometry.rotateZ(-Math.PI / 2);
  const glass = obstacle.inside ? { transparent: true, opacity: 0.25, depthWrite: false } : {};
  const material = new THREE.MeshLambertMaterial({ color: 0x9aa4ae, side: THREE.DoubleSide, ...glass });
  return new THREE.Mesh(geometry, material);
}

function plane(half: number): THREE.Object3D {
  const geometry = new THREE.PlaneGeometry(2 * half, 2 * half).rotateY(Math.PI / 2);
  const face = new THREE.Mesh(
    geometry,
    new THREE.MeshBasicMaterial({
      ...{ color: 0x8894a0, transparent: true, opacity: 0.22, depthWrite: false, side: THREE.DoubleSide },
    }),
  );
  const rim = new THREE.LineSegments(
    new THREE.EdgesGeometry(geometry),
    new THREE.LineBasicMaterial({ color: 0x808890, transparent: true, opacity: 0.7 }),
  );
  const both = new THREE.Group();
  both.add(face, rim);
  return both;
}
