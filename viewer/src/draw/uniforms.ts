// Uniforms that all moving things share: the textures of the points and the instant.

import * as THREE from "three";
import type { Instant } from "../scene/blend";
import type { Points } from "./points";

export class Shared {
  readonly uniforms: Record<string, THREE.IUniform>;

  constructor(points: Points) {
    this.uniforms = {
      centres: { value: points.centres },
      referenceCentres: { value: points.referenceCentres },
      points: { value: points.count },
      frames: { value: new Int32Array([0, 0]) },
      weight: { value: 0 },
      scale: { value: 1 },
      pixel: { value: 0.001 },
      viewport: { value: new THREE.Vector2(1, 1) },
    };
  }

  set instant(now: Instant) {
    (this.uniforms.frames.value as Int32Array).set([now.first, now.second]);
    this.uniforms.weight.value = now.weight;
    this.uniforms.scale.value = now.scale;
  }

  /** Height and width of the canvas in CSS pixels, and half the tangent of the camera's angle of view. */
  look(width: number, height: number, fov: number): void {
    this.uniforms.pixel.value = (2 * Math.tan((fov * Math.PI) / 360)) / Math.max(1, height);
    (this.uniforms.viewport.value as THREE.Vector2).set(width, height);
  }
}
