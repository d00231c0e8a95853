// Grid on the ground.

import * as THREE from "three";
import { roundUp } from "../base/numbers";
import type { Scene, Vector } from "../scene/scene";
import { dot, horizontalAxes } from "../view/axes";

/** Distance between two lines of the grid. */
export function gridSpacing(scene: Scene): number {
  return roundUp(scene.size / 12);
}

/** Grid lines perpendicular to `scene.up`, below everything that is drawn. */
export function groundGrid(scene: Scene): THREE.LineSegments<THREE.BufferGeometry, THREE.LineBasicMaterial> {
  const { bounds, up, size } = scene;
  const spacing = gridSpacing(scene);
  const [u, v] = horizontalAxes(up);
  const centre = bounds[0].map((low, k) => 0.5 * (low + bounds[1][k])) as Vector;
  const level = dot(up, centre) - 0.5 * Math.abs(dot(up, bounds[1]) - dot(up, bounds[0])) - 0.03 * size;
  const extent = (axis: Vector) => {
    const half = 0.5 * Math.abs(dot(axis, bounds[1]) - dot(axis, bounds[0])) + 0.25 * size;
    return [
      Math.floor((dot(axis, centre) - half) / spacing),
      Math.ceil((dot(axis, centre) + half) / spacing),
    ];
  };
  const [[u0, u1], [v0, v1]] = [extent(u), extent(v)];
  const positions: number[] = [];
  const addPoint = (a: number, b: number) => {
    for (let k = 0; k < 3; k++) positions.push(spacing * (a * u[k] + b * v[k]) + level * up[k]);
  };
  for (let a = u0; a <= u1; a++) {
    addPoint(a, v0);
    addPoint(a, v1);
  }
  for (let b = v0; b <= v1; b++) {
    addPoint(u0, b);
    addPoint(u1, b);
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
