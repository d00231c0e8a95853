// Markers of joints, probes and loads; arrows of reactions; links between bodies.

import * as THREE from "three";
import type { Numbers, Scene } from "../scene/scene";
import type { Points } from "./points";
import { ARROW_VERTEX, LINK_VERTEX, MARKER_FRAGMENT, MARKER_VERTEX, SOLID_FRAGMENT } from "./shaders/symbols";
import type { Shared } from "./uniforms";

const SIGNS = ["#e08a00", "#2f80ed", "#d33f6a"];
/** Force, moment, spring, damper, other links. */
const SOLIDS = ["#d9480f", "#8e44ad", "#3a9d5d", "#6c7ae0", "#8a939c"];
const RIM = 10;

function colourList(list: string[]): THREE.Vector3[] {
  return list.map((hex) => {
    const c = Number.parseInt(hex.slice(1), 16);
    return new THREE.Vector3((c >> 16) & 255, (c >> 8) & 255, c & 255).divideScalar(255);
  });
}

type Columns = Record<string, [numbers: number[], size: number]>;

function geometry(vertices: Columns, index: number[], instances: Columns): THREE.InstancedBufferGeometry {
  const made = new THREE.InstancedBufferGeometry();
  made.setIndex(index);
  for (const [name, [numbers, size]] of Object.entries(vertices)) {
    made.setAttribute(name, new THREE.Float32BufferAttribute(numbers, size));
  }
  for (const [name, [numbers, size]] of Object.entries(instances)) {
    made.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(numbers), size));
    made.instanceCount = numbers.length / size;
  }
  return made;
}

function mesh(
  shape: THREE.BufferGeometry,
  vertexShader: string,
  fragmentShader: string,
  parameters: THREE.ShaderMaterialParameters,
): THREE.Mesh {
  const material = new THREE.ShaderMaterial({
    vertexShader,
    fragmentShader,
    glslVersion: THREE.GLSL3,
    side: THREE.DoubleSide,
    ...parameters,
  });
  const made = new THREE.Mesh(shape, material);
  made.frustumCulled = false;
  return made;
}

/** Signs at the markers, always in front. */
export function markers(scene: Scene, points: Points, shared: Shared): THREE.Mesh {
  const kinds = scene.markers.map((m) => Math.max(0, ["joint", "probe", "load"].indexOf(m.kind)));
  const shape = geometry({ corner: [[-1, -1, 1, -1, 1, 1, -1, 1], 2] }, [0, 1, 2, 0, 2, 3], {
    at: [scene.markers.map((_, i) => points.markers + i), 1],
    kind: [kinds, 1],
  });
  const made = mesh(shape, MARKER_VERTEX, MARKER_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      width: { value: 13 },
      signs: { value: colourList(SIGNS) },
      paper: { value: new THREE.Vector3(1, 1, 1) },
    },
    transparent: true,
    premultipliedAlpha: true,
    depthTest: false,
    depthWrite: false,
  });
  made.renderOrder = 3;
  return made;
}

/** Greatest length of the vectors of all frames. */
export function greatest(vectors: Numbers): number {
  let most = 0;
  for (let i = 0; i < vectors.length; i += 3) {
    const size = Math.hypot(vectors[i], vectors[i + 1], vectors[i + 2]);
    if (size > most && Number.isFinite(size)) most = size;
  }
  return most;
}

/** Length in space of one unit of force and of moment: the greatest is a quarter of the model's size. */
function arrowLengths(scene: Scene): THREE.Vector2 {
  const most = (of: (r: Scene["reactions"][number]) => Numbers) =>
    Math.max(0, ...scene.reactions.map((r) => greatest(of(r))));
  const unit = (m: number) => (m > 0 ? (0.25 * scene.size) / m : 0);
  return new THREE.Vector2(unit(most((r) => r.force)), unit(most((r) => r.moment)));
}

/** A shaft and two heads along x; see ARROW_VERTEX for what the numbers say. */
function arrow(): { shape: number[]; second: number[]; index: number[] } {
  const rings = [
    [0, 0, 0.14, 0],
    [1, 0.9, 0.14, 0],
    [1, 1, 0.42, 0],
    [1, 0, 0, 0],
    [1, 1.75, 0.42, 1],
    [1, 0.75, 0, 1],
  ];
  const shape: number[] = [];
  const second: number[] = [];
  const index: number[] = [];
  rings.forEach(([along, back, wide, other], row) => {
    for (let i = 0; i <= RIM; i++) {
      shape.push(along, back, wide, (2 * Math.PI * i) / RIM);
      second.push(other);
      if (row % 2 === 0 && i < RIM) {
        const k = row * (RIM + 1) + i;
        index.push(k, k + 1, k + RIM + 1, k + 1, k + RIM + 2, k + RIM + 1);
      }
    }
  });
  return { shape, second, index };
}

/** Arrows of reaction forces (one head) and moments (two heads). */
export function reactions(scene: Scene, points: Points, shared: Shared): THREE.Mesh {
  const { shape, second, index } = arrow();
  const anchor: number[] = [];
  const moment: number[] = [];
  scene.reactions.forEach((r, i) => {
    for (const part of [0, 1]) {
      anchor.push(points.markers + r.marker, points.reactions + 2 * i + part);
      moment.push(part);
    }
  });
  const made = geometry({ shape: [shape, 4], second: [second, 1] }, index, {
    anchor: [anchor, 2],
    moment: [moment, 1],
  });
  return mesh(made, ARROW_VERTEX, SOLID_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      head: { value: 17 },
      lengths: { value: arrowLengths(scene) },
      solids: { value: colourList(SOLIDS) },
    },
  });
}

/** Springs as coils, everything else as rods. */
export function links(scene: Scene, points: Points, shared: Shared): THREE.Mesh {
  const shape: number[] = [];
  const index: number[] = [];
  const sides = 6;
  const steps = 200;
  for (let j = 0; j <= steps; j++) {
    for (let i = 0; i <= sides; i++) {
      shape.push(j / steps, (2 * Math.PI * i) / sides);
      if (i < sides && j < steps) {
        const k = j * (sides + 1) + i;
        index.push(k, k + 1, k + sides + 1, k + 1, k + sides + 2, k + sides + 1);
      }
    }
  }
  const kind = (name: string) => ({ spring: 2, damper: 3 })[name] ?? 4;
  const made = geometry({ shape: [shape, 2] }, index, {
    at: [scene.links.map((_, i) => points.links + 2 * i), 1],
    turns: [scene.links.map((l) => (l.kind === "spring" ? 8 : 0)), 1],
    body: [scene.links.map((l) => kind(l.kind)), 1],
    wide: [scene.links.map((l) => (l.kind === "arm" || l.kind === "damper" ? 2.5 : 1)), 1],
  });
  return mesh(made, LINK_VERTEX, SOLID_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      coil: { value: 0.024 * scene.size },
      wire: { value: 0.0035 * scene.size },
      least: { value: 1 },
      solids: { value: colourList(SOLIDS) },
    },
  });
}
