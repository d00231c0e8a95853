// Camera: orbit, pan, zoom, the standard views, and fitting of the model into the view.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Scene } from "../scene/scene";
import { horizontalAxes } from "./axes";

export const STANDARD_VIEWS = ["front", "top", "side", "oblique"] as const;
export type StandardView = (typeof STANDARD_VIEWS)[number];

type Axes = { right: THREE.Vector3; up: THREE.Vector3; toward: THREE.Vector3 };

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  readonly controls: OrbitControls;
  private box = new THREE.Box3();
  private centre = new THREE.Vector3();
  private radius = 1;
  /** Share of the height that the buttons at the top cover. */
  private covered = 0;
  private axes: Axes;

  constructor(element: HTMLElement, scene: Scene, changed: () => void) {
    this.axes = viewAxes(scene);
    this.camera.up.copy(this.axes.up);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", changed);
    this.extent = scene;
  }

  /** Sets the box to fit: the bounds of all frames and the reference configuration. */
  set extent(scene: Scene) {
    const box = new THREE.Box3(new THREE.Vector3(...scene.bounds[0]), new THREE.Vector3(...scene.bounds[1]));
    const point = new THREE.Vector3();
    for (let i = 0; i < scene.reference.centres.length; i += 3) {
      box.expandByPoint(point.fromArray(scene.reference.centres, i));
    }
    const radius = 0.5 * box.getSize(new THREE.Vector3()).length();
    const valid = Number.isFinite(radius) && radius > 0;
    if (!valid) box.setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3().setScalar(scene.size));
    this.box = box;
    this.centre = box.getCenter(new THREE.Vector3());
    this.radius = valid ? radius : 0.5 * scene.size;
  }

  /** Selects a standard direction and fits the model into the view. */
  setView(view: StandardView): void {
    const { right, up, toward } = this.axes;
    const direction = new THREE.Vector3();
    if (view === "front") direction.copy(toward);
    else if (view === "top") direction.copy(up).addScaledVector(toward, 1e-3);
    else if (view === "side") direction.copy(right);
    else direction.copy(toward).addScaledVector(right, 0.55).addScaledVector(up, 0.5);
    this.lookFrom(direction.normalize());
  }

  /** Rotates the camera about the vertical axis through the target, and scales its distance. */
  orbit(angle: number, factor: number): void {
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    offset.applyAxisAngle(this.axes.up, angle).multiplyScalar(factor);
    this.camera.position.copy(target).add(offset);
    this.controls.update();
  }

  /** Fits the model into the view without a change of direction. */
  fit(): void {
    this.lookFrom(this.camera.position.clone().sub(this.controls.target).normalize());
  }

  private lookFrom(direction: THREE.Vector3): void {
    this.controls.target.copy(this.centre);
    this.camera.position.copy(this.centre).addScaledVector(direction, this.fittingDistance(direction));
    this.controls.update();
    this.updateDepth();
  }

  /** Distance at which every corner of the box is visible from `direction`. */
  private fittingDistance(direction: THREE.Vector3): number {
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const halfHeight = half * (1 - this.covered);
    const right = new THREE.Vector3().crossVectors(this.axes.up, direction).normalize();
    const up = new THREE.Vector3().crossVectors(direction, right);
    const corner = new THREE.Vector3();
    let distance = this.radius;
    for (let i = 0; i < 8; i++) {
      const { min, max } = this.box;
      corner.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).sub(this.centre);
      const horizontal = Math.abs(corner.dot(right)) / (half * this.camera.aspect);
      const vertical = Math.abs(corner.dot(up)) / halfHeight;
      distance = Math.max(distance, 1.2 * Math.max(horizontal, vertical) + corner.dot(direction));
    }
    return distance;
  }

  /** Sets the size of the view, and the height that is covered at its top, in pixels. */
  resize(width: number, height: number, inset: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.covered = Math.min(0.3, inset / Math.max(1, height));
    this.camera.setViewOffset(width, height, 0, -inset / 2, width, height);
  }

  /** Sets the near and far planes around the model. */
  updateDepth(): void {
    const distance = this.camera.position.distanceTo(this.centre);
    this.camera.near = Math.max(distance - 4 * this.radius, distance / 500, this.radius * 1e-3);
    this.camera.far = distance + 6 * this.radius;
    this.camera.updateProjectionMatrix();
  }
}

function viewAxes(scene: Scene): Axes {
  const [right, toward] = horizontalAxes(scene.up).map((v) => new THREE.Vector3(...v));
  return { right, up: new THREE.Vector3(...scene.up), toward };
}
