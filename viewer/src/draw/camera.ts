// Camera: orbit, pan, zoom, the four standard views, and fitting everything into the picture.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Scene } from "../scene/scene";
import { sideways } from "./obstacles";

export const VIEWS = ["front", "top", "side", "oblique"] as const;
export type View = (typeof VIEWS)[number];

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  readonly controls: OrbitControls;
  private box = new THREE.Box3();
  private middle = new THREE.Vector3();
  private radius = 1;
  /** Share of the picture's height that the buttons at its top take. */
  private covered = 0;
  private axes: { right: THREE.Vector3; up: THREE.Vector3; toward: THREE.Vector3 };

  constructor(element: HTMLElement, scene: Scene, changed: () => void) {
    this.axes = frame(scene);
    this.camera.up.copy(this.axes.up);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", changed);
    this.extent = scene;
  }

  set extent(scene: Scene) {
    const box = new THREE.Box3(new THREE.Vector3(...scene.bounds[0]), new THREE.Vector3(...scene.bounds[1]));
    const corner = new THREE.Vector3();
    for (let i = 0; i < scene.reference.centres.length; i += 3) {
      box.expandByPoint(corner.fromArray(scene.reference.centres, i));
    }
    const radius = 0.5 * box.getSize(new THREE.Vector3()).length();
    const sound = Number.isFinite(radius) && radius > 0;
    if (!sound) box.setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3().setScalar(scene.size));
    this.box = box;
    this.middle = box.getCenter(new THREE.Vector3());
    this.radius = sound ? radius : 0.5 * scene.size;
  }

  /** Looks along a standard direction, from as far as it takes to see everything. */
  view(view: View): void {
    const { right, up, toward } = this.axes;
    const way = new THREE.Vector3();
    if (view === "front") way.copy(toward);
    else if (view === "top") way.copy(up).addScaledVector(toward, 1e-3);
    else if (view === "side") way.copy(right);
    else way.copy(toward).addScaledVector(right, 0.55).addScaledVector(up, 0.5);
    this.from(way.normalize());
  }

  /** Turns about the middle by an angle, moves away from it by a factor. */
  move(angle: number, factor: number): void {
    const { target } = this.controls;
    const away = this.camera.position.clone().sub(target);
    away.applyAxisAngle(this.axes.up, angle).multiplyScalar(factor);
    this.camera.position.copy(target).add(away);
    this.controls.update();
  }

  fit(): void {
    this.from(this.camera.position.clone().sub(this.controls.target).normalize());
  }

  private from(way: THREE.Vector3): void {
    this.controls.target.copy(this.middle);
    this.camera.position.copy(this.middle).addScaledVector(way, this.distance(way));
    this.controls.update();
    this.depth();
  }

  /** From how far, looking along -way, every corner of the box is in the picture. */
  private distance(way: THREE.Vector3): number {
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const high = half * (1 - this.covered);
    const right = new THREE.Vector3().crossVectors(this.axes.up, way).normalize();
    const up = new THREE.Vector3().crossVectors(way, right);
    const corner = new THREE.Vector3();
    let far = this.radius;
    for (let i = 0; i < 8; i++) {
      const { min, max } = this.box;
      corner.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).sub(this.middle);
      const across = Math.abs(corner.dot(right)) / (half * this.camera.aspect);
      far = Math.max(far, 1.2 * Math.max(across, Math.abs(corner.dot(up)) / high) + corner.dot(way));
    }
    return far;
  }

  /** Size of the picture in pixels, and how many of its height are covered at the top. */
  resize(width: number, height: number, inset: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.covered = Math.min(0.3, inset / Math.max(1, height));
    this.camera.setViewOffset(width, height, 0, -inset / 2, width, height);
  }

  /** Near and far planes around what there is. */
  depth(): void {
    const away = this.camera.position.distanceTo(this.middle);
    this.camera.near = Math.max(away - 4 * this.radius, away / 500, this.radius * 1e-3);
    this.camera.far = away + 6 * this.radius;
    this.camera.updateProjectionMatrix();
  }
}

function frame(scene: Scene): { right: THREE.Vector3; up: THREE.Vector3; toward: THREE.Vector3 } {
  const [right, toward] = sideways(scene.up).map((v) => new THREE.Vector3(...v));
  return { right, up: new THREE.Vector3(...scene.up), toward };
}
