// Meshes of the obstacles, which are fixed or move as rigid bodies.

import * as THREE from "three";
import type { FrameBlend } from "../scene/blend";
import type { Obstacle, Scene } from "../scene/scene";

export class ObstacleMeshes {
  readonly group = new THREE.Group();

  constructor(private readonly scene: Scene) {
    for (const obstacle of scene.obstacles) this.group.add(obstacleMesh(obstacle, scene));
    this.blend = { first: 0, second: 0, weight: 0, scale: 1 };
  }

  /** Moves the obstacles to their poses between two frames. */
  set blend(blend: FrameBlend) {
    this.scene.obstacles.forEach((obstacle, i) => {
      const object = this.group.children[i];
      pose(obstacle, blend).decompose(object.position, object.quaternion, object.scale);
    });
  }
}

function pose({ pose: poses }: Obstacle, blend: FrameBlend): THREE.Matrix4 {
  const fixed = poses.length === 12;
  const [a, b] = fixed ? [0, 0] : [12 * blend.first, 12 * blend.second];
  const p = Array.from({ length: 12 }, (_, k) => poses[a + k] + blend.weight * (poses[b + k] - poses[a + k]));
  const [origin, d1, d2, d3] = [0, 3, 6, 9].map((k) => new THREE.Vector3(p[k], p[k + 1], p[k + 2]));
  return new THREE.Matrix4().makeBasis(d1, d2, d3).setPosition(origin);
}

/** Mesh whose first axis is the normal of a plane or the axis of a cylinder. */
function obstacleMesh(obstacle: Obstacle, scene: Scene): THREE.Object3D {
  const [low, high] = scene.bounds;
  const extent = Math.max(scene.size, Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]));
  if (obstacle.kind === "plane") return plane(0.75 * extent);
  const geometry =
    obstacle.kind === "sphere"
      ? new THREE.SphereGeometry(obstacle.radius, 48, 24)
      : new THREE.CylinderGeometry(obstacle.radius, obstacle.radius, obstacle.length ?? 2 * extent, 64, 1);
  if (obstacle.kind !== "sphere") geometry.rotateZ(-Math.PI / 2);
  const transparency = obstacle.inside ? { transparent: true, opacity: 0.25, depthWrite: false } : {};
  const material = new THREE.MeshLambertMaterial({
    color: 0x9aa4ae,
    side: THREE.DoubleSide,
    ...transparency,
  });
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
  const edges = new THREE.LineSegments(
    new THREE.EdgesGeometry(geometry),
    new THREE.LineBasicMaterial({ color: 0x808890, transparent: true, opacity: 0.7 }),
  );
  const group = new THREE.Group();
  group.add(face, edges);
  return group;
}
