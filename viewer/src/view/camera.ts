// Camera: orbit, pan, zoom, the standard views, and fitting of the motion into the free area of the view.

import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Vector } from "../scene/scene";
import { horizontalAxes } from "./axes";
import type { Extent, Spheres } from "./extent";
import { isStraight, planeNormal, type ViewAxes } from "./orientation";

export const STANDARD_VIEWS = ["front", "top", "side", "oblique"] as const;
export type StandardView = (typeof STANDARD_VIEWS)[number];

/** Rectangle of the view in CSS pixels from its upper left corner. */
export interface Rectangle {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Space around the motion in pixels: half of a symbol, and a gap. */
const PADDING = 14;

export class Camera {
  readonly camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
  readonly controls: OrbitControls;
  private centre = new THREE.Vector3();
  private radius = 1;
  private width = 1;
  private height = 1;
  private readonly axes: ViewAxes;
  /** True until the user moves the camera. */
  private fitted = true;
  /** Rectangles that are free of buttons and legends; the one that shows the motion largest is used. */
  freeAreas: () => Rectangle[] = () => [this.wholeView];
  /** Free area of the last fit. */
  free: Rectangle = this.wholeView;

  constructor(
    element: HTMLElement,
    up: Vector,
    /** Points to frame. */
    private readonly extent: () => Extent,
    changed: () => void,
  ) {
    const [right, toward] = horizontalAxes(up).map((v) => new THREE.Vector3(...v));
    this.axes = { right, up: new THREE.Vector3(...up), toward };
    this.camera.up.copy(this.axes.up);
    this.controls = new OrbitControls(this.camera, element);
    this.controls.zoomToCursor = true;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", changed);
    this.controls.addEventListener("start", () => {
      this.fitted = false;
    });
  }

  private get wholeView(): Rectangle {
    return { left: 0, top: 0, right: this.width ?? 1, bottom: this.height ?? 1 };
  }

  /** Selects a standard direction and fits the motion into the free area. */
  setView(view: StandardView): void {
    const { right, up, toward } = this.axes;
    const direction = new THREE.Vector3();
    if (view === "front") direction.copy(toward);
    else if (view === "top") direction.copy(up);
    else if (view === "side") direction.copy(right);
    else direction.copy(toward).addScaledVector(right, 0.55).addScaledVector(up, 0.5);
    this.lookFrom(direction.normalize());
  }

  /** Selects the direction normal to a planar motion, or the oblique one. Solids on a straight line are seen by their shape. */
  setInitialView(): void {
    const { lines, motion } = this.extent();
    const normal = planeNormal(isStraight(lines) ? motion : lines, this.axes);
    if (normal) this.lookFrom(normal);
    else this.setView("oblique");
  }

  /** Rotates the camera about the vertical axis through the target, and scales its distance. */
  orbit(angle: number, factor: number): void {
    const { target } = this.controls;
    const offset = this.camera.position.clone().sub(target);
    offset.applyAxisAngle(this.axes.up, angle).multiplyScalar(factor);
    this.camera.position.copy(target).add(offset);
    this.fitted = false;
    this.controls.update();
  }

  /** Unit vector from the target towards the camera. */
  get direction(): Vector {
    return this.camera.position.clone().sub(this.controls.target).normalize().toArray();
  }

  /** Unit vectors to the right and upwards on the screen. */
  get screenAxes(): [Vector, Vector] {
    const [right, upward] = [0, 1].map((k) =>
      new THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, k),
    );
    return [right.toArray(), upward.toArray()];
  }

  /** Fits the motion into the free area without a change of direction. */
  fit(): void {
    this.lookFrom(new THREE.Vector3(...this.direction));
  }

  /** Fits new data into the free area, unless the user has moved the camera. */
  keepFitted(): void {
    if (this.fitted) this.fit();
  }

  private lookFrom(direction: THREE.Vector3): void {
    const { up, toward } = this.axes;
    // The controls require a small angle between the direction and the vertical axis.
    if (Math.abs(direction.dot(up)) > 0.999999) direction.addScaledVector(toward, 1e-3).normalize();
    const right = new THREE.Vector3().crossVectors(up, direction).normalize();
    const upward = new THREE.Vector3().crossVectors(direction, right);
    const points = this.cameraCoordinates(right, upward, direction);
    const fits = this.freeAreas().map((area) => ({ area, position: this.fitInto(area, points) }));
    const best = fits.reduce((a, b) => (b.position[2] < a.position[2] ? b : a));
    this.free = best.area;
    this.updateOffset();
    const [x, y, z] = best.position;
    const depth = this.centre.dot(direction);
    const at = (d: number) =>
      new THREE.Vector3().addScaledVector(right, x).addScaledVector(upward, y).addScaledVector(direction, d);
    this.controls.target.copy(at(depth));
    this.camera.position.copy(at(Math.max(z, depth + 1e-3 * this.radius)));
    this.controls.update();
    this.fitted = true;
    this.updateDepth();
  }

  /** Coordinates of all points along the axes of the camera. Sets the centre of the motion. */
  private cameraCoordinates(...axes: THREE.Vector3[]): Spheres {
    const { motion, arrows, box } = this.extent();
    const [low, high] = box.map((v) => new THREE.Vector3(...v));
    this.centre = low.clone().add(high).multiplyScalar(0.5);
    this.radius = 0.5 * high.distanceTo(low) || 1;
    const result = new Float32Array(motion.length + arrows.length);
    let to = 0;
    for (const points of [motion, arrows]) {
      for (let i = 0; i < points.length; i += 4, to += 4) {
        for (let k = 0; k < 3; k++) {
          const { x, y, z } = axes[k];
          result[to + k] = x * points[i] + y * points[i + 1] + z * points[i + 2];
        }
        result[to + 3] = points[i + 3];
      }
    }
    return result;
  }

  /**
   * Position of the camera, in camera axes, from which all points appear in a rectangle. A point is inside the frustum if
   * |x - cx| <= t (cz - z) in camera axes; the extremes of x + t z and x - t z give cx and the least cz.
   */
  private fitInto({ left, top, right, bottom }: Rectangle, points: Spheres): Vector {
    const half = Math.tan((this.camera.fov * Math.PI) / 360);
    const slopes = [right - left, bottom - top].map(
      (size) => (half * Math.max(40, size - 2 * PADDING)) / Math.max(1, this.height),
    );
    const position: Vector = [0, 0, -Infinity];
    slopes.forEach((slope, k) => {
      const stretch = Math.hypot(1, slope);
      let [most, least] = [-Infinity, Infinity];
      for (let i = 0; i < points.length; i += 4) {
        const [x, z, r] = [points[i + k], slope * points[i + 2], stretch * points[i + 3]];
        most = Math.max(most, x + z + r);
        least = Math.min(least, x - z - r);
      }
      position[k] = 0.5 * (most + least);
      position[2] = Math.max(position[2], (most - least) / (2 * slope));
    });
    return position;
  }

  /** Sets the size of the view. A view that the user has not moved is fitted again. */
  resize(width: number, height: number): void {
    [this.width, this.height] = [width, height];
    this.camera.aspect = width / Math.max(1, height);
    // The first direction of view is set after the first size.
    if (this.camera.position.lengthSq() > 0) this.keepFitted();
    if (!this.fitted) this.updateOffset();
  }

  /** Shifts the centre of the picture into that of the free area. */
  private updateOffset(): void {
    const { left, top, right, bottom } = this.free;
    const [dx, dy] = [0.5 * (this.width - left - right), 0.5 * (this.height - top - bottom)];
    this.camera.setViewOffset(this.width, this.height, dx, dy, this.width, this.height);
  }

  /** Sets the near and far planes around the model. */
  updateDepth(): void {
    const distance = this.camera.position.distanceTo(this.centre);
    this.camera.near = Math.max(distance - 4 * this.radius, distance / 500, this.radius * 1e-3);
    this.camera.far = distance + 6 * this.radius;
    this.camera.updateProjectionMatrix();
  }
}
