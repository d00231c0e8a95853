// Meshes of the bodies, swept by the vertex shader, and the ghost of the reference configuration.

import * as THREE from "three";
import { automaticMap, colourTable, PALETTE } from "../base/colours";
import type { ColourScale } from "../scene/fields";
import type { Scene, Vector } from "../scene/scene";
import { bodyBatches, type InstanceBatch, STRIDE } from "./batches";
import type { PointTextures } from "./points";
import { BODY_FRAGMENT, BODY_VERTEX } from "./shaders/bodies";
import type { SharedUniforms } from "./uniforms";

/** Plane on which shadows fall. */
export interface Ground {
  up: Vector;
  level: number;
  /** Height at which a shadow has faded to a third. */
  fading: number;
}

/** Shadows cover each pixel once, for any number of bodies above it. */
export const SHADOW: THREE.MaterialParameters = {
  transparent: true,
  premultipliedAlpha: true,
  depthWrite: false,
  ...{ stencilWrite: true, stencilRef: 1, stencilFunc: THREE.NotEqualStencilFunc },
  stencilZPass: THREE.ReplaceStencilOp,
  ...{ polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1 },
};

/** Strength of the lines along the edges of shell elements, relative to those of other edges. */
const EDGES = 0.45;

export class BodyMeshes {
  readonly group = new THREE.Group();
  readonly ghost = new THREE.Group();
  readonly shadows = new THREE.Group();
  private readonly uniforms: Record<string, THREE.IUniform>;
  private readonly ghostUniforms: Record<string, THREE.IUniform>;
  private readonly materials: THREE.ShaderMaterial[];
  /** Strength of the lines along the edges of shell elements. */
  private readonly elementEdges = { value: EDGES };
  private field: THREE.DataTexture;
  private shownField = -1;
  private shownMap = "";

  constructor(
    private readonly scene: Scene,
    private readonly points: PointTextures,
    shared: SharedUniforms,
    ground: Ground,
  ) {
    this.field = emptyField();
    this.uniforms = {
      ...shared.uniforms,
      directors: { value: points.directors },
      referenceDirectors: { value: points.referenceDirectors },
      stations: { value: scene.stations },
      field: { value: this.field },
      thickness: { value: 1 },
      minPixels: { value: 1.25 },
      ghost: { value: false },
      shadow: { value: false },
      crease: { value: false },
      edges: { value: 1 },
      ground: { value: new THREE.Vector4(...ground.up, ground.level) },
      fading: { value: ground.fading },
      coloured: { value: false },
      colours: { value: colourTexture(automaticMap(false)) },
      window: { value: new THREE.Vector2(0, 1) },
      palette: { value: PALETTE.map((c) => new THREE.Vector3(...c).divideScalar(255)) },
      ghostColour: { value: new THREE.Vector4(0.5, 0.55, 0.6, 0.3) },
    };
    this.ghostUniforms = { ...this.uniforms, ghost: { value: true }, minPixels: { value: 0.75 } };
    const solid = bodyMaterial(this.uniforms, {});
    const transparent = bodyMaterial(this.ghostUniforms, {
      transparent: true,
      depthWrite: false,
      premultipliedAlpha: true,
    });
    const shadow = bodyMaterial({ ...this.uniforms, shadow: { value: true } }, SHADOW);
    const crease = bodyMaterial({ ...this.uniforms, crease: { value: true } }, {});
    const shell = bodyMaterial({ ...this.uniforms, edges: this.elementEdges }, {});
    this.materials = [solid, transparent, shadow, crease, shell];
    for (const batch of bodyBatches(scene)) {
      const geometry = instancedGeometry(batch);
      if (batch.template.isLines) {
        this.group.add(always(new THREE.LineSegments(geometry, crease)));
        continue;
      }
      this.group.add(mesh(geometry, batch.template.isShell ? shell : solid));
      this.ghost.add(mesh(geometry, transparent));
      const flat = mesh(geometry, shadow);
      flat.renderOrder = -1;
      this.shadows.add(flat);
    }
  }

  /** Colours the bodies by field `index` with a scale, or each body in its own colour if the index is negative. */
  colourBy(index: number, scale: ColourScale | null): void {
    this.uniforms.coloured.value = scale !== null;
    if (!scale) return;
    const { range } = this.scene.fields[index];
    const { map, low, high } = scale;
    if (this.shownField !== index) {
      this.field.dispose();
      this.field = this.points.fieldTexture(index);
      this.uniforms.field.value = this.field;
      this.ghostUniforms.field.value = this.field;
      this.shownField = index;
    }
    (this.uniforms.window.value as THREE.Vector2).set(
      (range[0] - low) / (high - low),
      (range[1] - low) / (high - low),
    );
    if (this.shownMap !== map) {
      (this.uniforms.colours.value as THREE.Texture).dispose();
      this.uniforms.colours.value = colourTexture(map);
      this.ghostUniforms.colours.value = this.uniforms.colours.value;
      this.shownMap = map;
    }
  }

  set mesh(visible: boolean) {
    this.elementEdges.value = visible ? EDGES : 0;
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

function bodyMaterial(
  uniforms: Record<string, THREE.IUniform>,
  parameters: THREE.MaterialParameters,
): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    uniforms,
    vertexShader: BODY_VERTEX,
    fragmentShader: BODY_FRAGMENT,
    glslVersion: THREE.GLSL3,
    side: THREE.DoubleSide,
    ...parameters,
  });
}

function mesh(geometry: THREE.BufferGeometry, material: THREE.Material): THREE.Mesh {
  return always(new THREE.Mesh(geometry, material));
}

/** Excludes an object from culling, since its points are known to the shader only. */
function always<T extends THREE.Object3D>(object: T): T {
  object.frustumCulled = false;
  return object;
}

function instancedGeometry({ template, instances, count }: InstanceBatch): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex(template.index);
  geometry.setAttribute("local", new THREE.Float32BufferAttribute(template.local, 3));
  geometry.setAttribute("localNormal", new THREE.Float32BufferAttribute(template.normal, 3));
  const face = template.face.length > 0 ? template.face : new Array(2 * template.end.length).fill(0);
  geometry.setAttribute("face", new THREE.Float32BufferAttribute(face, 2));
  geometry.setAttribute("end", new THREE.Float32BufferAttribute(template.end, 1));
  const data = new THREE.InstancedInterleavedBuffer(instances, STRIDE);
  const parts = { station: [1, 0], body: [1, 1], radius: [1, 2], startScale: [3, 3], endScale: [3, 6] };
  for (const [name, [size, offset]] of Object.entries(parts)) {
    geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(data, size, offset));
  }
  geometry.instanceCount = count;
  return geometry;
}

function colourTexture(map: string): THREE.DataTexture {
  const texture = new THREE.DataTexture(colourTable(map), 256, 1);
  texture.minFilter = THREE.LinearFilter;
  texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function emptyField(): THREE.DataTexture {
  const texture = new THREE.DataTexture(
    new Uint16Array(2),
    2,
    1,
    THREE.RedIntegerFormat,
    THREE.UnsignedShortType,
  );
  texture.internalFormat = "R16UI";
  texture.needsUpdate = true;
  return texture;
}
