// The bodies, swept on the graphics card; and the ghost of their reference shape.

import * as THREE from "three";
import { palette, span, table } from "../base/colours";
import type { Scene } from "../scene/scene";
import { type Batch, batches, STRIDE } from "./batches";
import type { Points } from "./points";
import { SWEEP_FRAGMENT, SWEEP_VERTEX } from "./shaders/symbols";
import type { Shared } from "./uniforms";

export class Bodies {
  readonly group = new THREE.Group();
  readonly ghost = new THREE.Group();
  private readonly uniforms: Record<string, THREE.IUniform>;
  private readonly ghosts: Record<string, THREE.IUniform>;
  private readonly materials: THREE.ShaderMaterial[];
  private field: THREE.DataTexture;

  constructor(
    private readonly scene: Scene,
    private readonly points: Points,
    shared: Shared,
  ) {
    this.field = noField();
    this.uniforms = {
      ...shared.uniforms,
      directors: { value: points.directors },
      referenceDirectors: { value: points.referenceDirectors },
      stations: { value: scene.stations },
      field: { value: this.field },
      thickness: { value: 1 },
      least: { value: 1.25 },
      ghost: { value: false },
      coloured: { value: false },
      colours: { value: colours(false) },
      window: { value: new THREE.Vector2(0, 1) },
      bodies: { value: palette.map((c) => new THREE.Vector3(...c).divideScalar(255)) },
      plain: { value: new THREE.Vector4(0.5, 0.55, 0.6, 0.3) },
    };
    this.ghosts = { ...this.uniforms, ghost: { value: true }, least: { value: 0.75 } };
    const solid = material(this.uniforms, {});
    const thin = material(this.ghosts, { transparent: true, depthWrite: false, premultipliedAlpha: true });
    this.materials = [solid, thin];
    for (const batch of batches(scene)) {
      const geometry = instanced(batch);
      this.group.add(mesh(geometry, solid));
      this.ghost.add(mesh(geometry, thin));
    }
  }

  /** Colours by field `index`, or each body in its own colour. */
  colourBy(index: number | null): void {
    this.uniforms.coloured.value = index !== null;
    if (index === null) return;
    const { range, diverging } = this.scene.fields[index];
    const [low, high] = span(range, diverging);
    this.field.dispose();
    this.field = this.points.field(index);
    this.uniforms.field.value = this.field;
    this.ghosts.field.value = this.field;
    (this.uniforms.window.value as THREE.Vector2).set(
      (range[0] - low) / (high - low),
      (range[1] - low) / (high - low),
    );
    (this.uniforms.colours.value as THREE.Texture).dispose();
    this.uniforms.colours.value = colours(diverging);
    this.ghosts.colours.value = this.uniforms.colours.value;
  }

  set thickness(factor: number) {
    this.uniforms.thickness.value = factor;
  }

  dispose(): void {
    for (const child of this.group.children) (child as THREE.Mesh).geometry.dispose();
    for (const m of this.materials) m.dispose();
    this.field.dispose();
    (this.uniforms.colours.value as THREE.Texture).dispose();
  }
}

function material(
  uniforms: Record<string, THREE.IUniform>,
  more: THREE.MaterialParameters,
): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    uniforms,
    vertexShader: SWEEP_VERTEX,
    fragmentShader: SWEEP_FRAGMENT,
    glslVersion: THREE.GLSL3,
    side: THREE.DoubleSide,
    ...more,
  });
}

function mesh(geometry: THREE.BufferGeometry, material: THREE.Material): THREE.Mesh {
  const made = new THREE.Mesh(geometry, material);
  made.frustumCulled = false;
  return made;
}

function instanced({ shape, instances, count }: Batch): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex(shape.index);
  geometry.setAttribute("local", new THREE.Float32BufferAttribute(shape.local, 3));
  geometry.setAttribute("slope", new THREE.Float32BufferAttribute(shape.slope, 3));
  geometry.setAttribute("end", new THREE.Float32BufferAttribute(shape.end, 1));
  const data = new THREE.InstancedInterleavedBuffer(instances, STRIDE);
  const parts = { at: [1, 0], body: [1, 1], radius: [1, 2], near: [3, 3], far: [3, 6] };
  for (const [name, [size, from]] of Object.entries(parts)) {
    geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(data, size, from));
  }
  geometry.instanceCount = count;
  return geometry;
}

function colours(diverging: boolean): THREE.DataTexture {
  const made = new THREE.DataTexture(table(diverging), 256, 1);
  made.minFilter = THREE.LinearFilter;
  made.magFilter = THREE.LinearFilter;
  made.needsUpdate = true;
  return made;
}

function noField(): THREE.DataTexture {
  const made = new THREE.DataTexture(
    new Uint16Array(2),
    2,
    1,
    THREE.RedIntegerFormat,
    THREE.UnsignedShortType,
  );
  made.internalFormat = "R16UI";
  made.needsUpdate = true;
  return made;
}
