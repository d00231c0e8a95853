// Uniforms common to all moving objects: textures of the points, frames and view.

import * as THREE from "three";
import type { FrameBlend } from "../scene/blend";
import type { PointTextures } from "./points";

export class SharedUniforms {
  readonly uniforms: Record<string, THREE.IUniform>;

  constructor(points: PointTextures) {
    this.uniforms = {
      centres: { value: points.centres },
      referenceCentres: { value: points.referenceCentres },
      points: { value: points.count },
      frames: { value: new Int32Array([0, 0]) },
      weight: { value: 0 },
      scale: { value: 1 },
      imaginary: { value: 0 },
      backdrop: { value: 0 },
      pixel: { value: 0.001 },
      viewport: { value: new THREE.Vector2(1, 1) },
    };
  }

  set blend(blend: FrameBlend) {
    (this.uniforms.frames.value as Int32Array).set([blend.first, blend.second]);
    this.uniforms.weight.value = blend.weight;
    this.uniforms.scale.value = blend.scale;
    this.uniforms.imaginary.value = blend.imaginary;
  }

  /** Adapts the lighting to a dark or light background. */
  set dark(dark: boolean) {
    this.uniforms.backdrop.value = dark ? 1 : 0;
  }

  /** Sets the size of the canvas in CSS pixels and the vertical angle of view in degrees. */
  setView(width: number, height: number, fov: number): void {
    this.uniforms.pixel.value = (2 * Math.tan((fov * Math.PI) / 360)) / Math.max(1, height);
    (this.uniforms.viewport.value as THREE.Vector2).set(width, height);
  }
}
