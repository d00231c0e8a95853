// Meshes of the obstacles, which are fixed or move as rigid bodies, and their shadows.

import * as THREE from "three";
import type { FrameBlend } from "../scene/blend";
import type { Obstacle, Scene } from "../scene/scene";
import type { Extent } from "../view/extent";
import { floorMesh } from "./ground";
import { cylinder, sphere } from "./solids";

export class ObstacleMeshes {
  readonly group = new THREE.Group();
  readonly shadows = new THREE.Group();
  private readonly projection = new THREE.Matrix4();
  private readonly pose = new THREE.Matrix4();
  private readonly axes = [new THREE.Vector3(), new THREE.Vector3(), new THREE.Vector3()];
  private drawn: FrameBlend | null = null;

  /** Shadows fall onto the ground at a level along the vertical axis. */
  constructor(
    private readonly scene: Scene,
    extent: Extent,
    level: number,
    shadow: THREE.Material,
  ) {
    const [x, y, z] = scene.up;
    const up = [x, y, z];
    const entry = (i: number, j: number) => (i === j ? 1 : 0) - up[i] * up[j];
    const row = (i: number) => [entry(i, 0), entry(i, 1), entry(i, 2), up[i] * level] as const;
    this.projection.set(...row(0), ...row(1), ...row(2), 0, 0, 0, 1);
    for (const obstacle of scene.obstacles) {
      const object = obstacleObject(obstacle, scene, extent);
      object.matrixAutoUpdate = false;
      this.group.add(object);
      const solid =
        obstacle.kind !== "plane" && !obstacle.inside ? (object.children[0] as THREE.Mesh).geometry : null;
      const flat = solid ? new THREE.Mesh(solid, shadow) : new THREE.Object3D();
      flat.matrixAutoUpdate = false;
      flat.frustumCulled = false;
      flat.renderOrder = -1;
      this.shadows.add(flat);
    }
    this.blend = { first: 0, second: 0, weight: 0, scale: 1, imaginary: 0 };
  }

  /** Moves the obstacles to their poses between two frames. Fixed obstacles are placed once. */
  set blend(blend: FrameBlend) {
    this.scene.obstacles.forEach((obstacle, i) => {
      if (this.drawn && obstacle.pose.length === 12) return;
      this.setPose(obstacle, blend);
      const [object, shadow] = [this.group.children[i], this.shadows.children[i]];
      object.matrix.copy(this.pose);
      object.matrixWorldNeedsUpdate = true;
      shadow.matrix.multiplyMatrices(this.projection, this.pose);
      shadow.matrixWorldNeedsUpdate = true;
    });
    this.drawn = blend;
  }

  private setPose({ pose }: Obstacle, blend: FrameBlend): void {
    const fixed = pose.length === 12;
    const [a, b] = fixed ? [0, 0] : [12 * blend.first, 12 * blend.second];
    const at = (k: number) => pose[a + k] + blend.weight * (pose[b + k] - pose[a + k]);
    this.axes.forEach((axis, i) => {
      axis.set(at(3 * i + 3), at(3 * i + 4), at(3 * i + 5)).normalize();
    });
    this.pose.makeBasis(this.axes[0], this.axes[1], this.axes[2]).setPosition(at(0), at(1), at(2));
  }
}

/** Object whose first axis is the normal of a plane or the axis of a cylinder. */
function obstacleObject(obstacle: Obstacle, scene: Scene, extent: Extent): THREE.Object3D {
  if (obstacle.kind === "plane") return new THREE.Group().add(floorMesh(obstacle, scene, extent));
  const moves = obstacle.pose.length > 12;
  if (obstacle.kind === "sphere") return sphere(obstacle.radius, moves, obstacle.inside ?? false);
  const [low, high] = scene.bounds;
  const longest = 2 * Math.max(scene.size, Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]));
  return cylinder(obstacle.radius, obstacle.length ?? longest, moves, obstacle.inside ?? false);
}
