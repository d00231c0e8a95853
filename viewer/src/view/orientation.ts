// Initial direction of view: normal to the plane of a planar motion, oblique to a spatial one.

import * as THREE from "three";
import type { Spheres } from "./extent";

/** Thickness of a planar motion relative to its largest dimension. */
const PLANAR = 0.02;

/** Cosine above which a normal counts as a standard direction. */
const SNAP = 0.995;
/** Sine of the inclination of a normal up to which the horizon is kept level. */
const LEVEL = 0.5;

/** Covariance matrix of points, by rows. */
function covariance(points: Spheres): number[][] {
  const count = points.length / 4;
  const mean = [0, 1, 2].map((k) => {
    let sum = 0;
    for (let i = k; i < points.length; i += 4) sum += points[i];
    return sum / Math.max(1, count);
  });
  const matrix = [0, 1, 2].map(() => [0, 0, 0]);
  for (let i = 0; i < points.length; i += 4) {
    const d = [0, 1, 2].map((k) => points[i + k] - mean[k]);
    for (let a = 0; a < 3; a++) for (let b = 0; b < 3; b++) matrix[a][b] += d[a] * d[b];
  }
  return matrix;
}

/** Eigenvectors of a symmetric 3 by 3 matrix by Jacobi rotations, in order of descending eigenvalues. */
function eigenvectors(matrix: number[][]): THREE.Vector3[] {
  const a = matrix.map((row) => [...row]);
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < 16; sweep++) {
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ]) {
      if (a[p][q] === 0) continue;
      const angle = 0.5 * Math.atan2(2 * a[p][q], a[q][q] - a[p][p]);
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (const m of [a, v]) {
        for (const row of m) [row[p], row[q]] = [c * row[p] - s * row[q], s * row[p] + c * row[q]];
      }
      const [rowP, rowQ] = [[...a[p]], [...a[q]]];
      for (let k = 0; k < 3; k++) {
        a[p][k] = c * rowP[k] - s * rowQ[k];
        a[q][k] = s * rowP[k] + c * rowQ[k];
      }
    }
  }
  const order = [0, 1, 2].sort((i, j) => a[j][j] - a[i][i]);
  return order.map((i) => new THREE.Vector3(v[0][i], v[1][i], v[2][i]).normalize());
}

/** Range of the coordinates of points along a direction. */
function range(points: Spheres, n: THREE.Vector3): number {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 4) {
    const x = points[i] * n.x + points[i + 1] * n.y + points[i + 2] * n.z;
    low = Math.min(low, x);
    high = Math.max(high, x);
  }
  return Math.max(0, high - low);
}

/** Principal directions of points with their ranges, the longest first. */
function principalRanges(points: Spheres): { directions: THREE.Vector3[]; ranges: number[] } {
  const directions = eigenvectors(covariance(points));
  return { directions, ranges: directions.map((n) => range(points, n)) };
}

/** True if the points are on a straight line. */
export function isStraight(points: Spheres): boolean {
  const [length, width] = principalRanges(points).ranges;
  return width <= PLANAR * length;
}

/** Axes of the standard views: to the right, upwards, towards the observer. */
export interface ViewAxes {
  right: THREE.Vector3;
  up: THREE.Vector3;
  toward: THREE.Vector3;
}

/**
 * Normal of the plane of the points, on the side of the observer; null if they are spatial.
 * The normal of a straight line is one of the standard directions.
 */
export function planeNormal(points: Spheres, { right, up, toward }: ViewAxes): THREE.Vector3 | null {
  if (points.length === 0) return null;
  const { directions, ranges } = principalRanges(points);
  const [[first, , third], [length, width, thickness]] = [directions, ranges];
  if (!(length > 0)) return toward.clone();
  if (thickness > PLANAR * length) return null;
  if (width <= PLANAR * length) return (Math.abs(first.dot(toward)) < 0.9 ? toward : right).clone();
  const axes = [toward, right, up];
  const nearest = axes.reduce((best, axis) =>
    Math.abs(axis.dot(third)) > Math.abs(best.dot(third)) ? axis : best,
  );
  if (Math.abs(nearest.dot(third)) > SNAP) return nearest.clone();
  const height = third.dot(up);
  // A slightly inclined plane is seen with a level horizon, any other one from above.
  if (Math.abs(height) > LEVEL) return third.multiplyScalar(Math.sign(height));
  third.addScaledVector(up, -height).normalize();
  return third.multiplyScalar(Math.sign(third.dot(nearest === up ? toward : nearest)) || 1);
}
