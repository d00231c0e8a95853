// Markers of joints, probes and loads, arrows of reactions, links between bodies.

import * as THREE from "three";
import { largestReactions } from "../scene/reactions";
import type { Scene } from "../scene/scene";
import type { PointTextures } from "./points";
import { ARROW_VERTEX, LINK_VERTEX, MARKER_FRAGMENT, MARKER_VERTEX, SOLID_FRAGMENT } from "./shaders/symbols";
import type { SharedUniforms } from "./uniforms";

/** Colours of joints, probes and loads. */
const MARKER_COLOURS = ["#e08a00", "#2f80ed", "#d33f6a"];
/** Colours of forces, moments, springs, dampers and other links. */
const SOLID_COLOURS = ["#d9480f", "#8e44ad", "#3a9d5d", "#6c7ae0", "#8a939c"];
/** Number of sides of an arrow. */
const ARROW_SIDES = 10;

function colourVectors(list: string[]): THREE.Vector3[] {
  return list.map((hex) => {
    const c = Number.parseInt(hex.slice(1), 16);
    return new THREE.Vector3((c >> 16) & 255, (c >> 8) & 255, c & 255).divideScalar(255);
  });
}

/** Attributes by name: numbers and their count per vertex or instance. */
type AttributeTable = Record<string, [numbers: number[], size: number]>;

function instancedGeometry(
  vertices: AttributeTable,
  index: number[],
  instances: AttributeTable,
): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setIndex(index);
  for (const [name, [numbers, size]] of Object.entries(vertices)) {
    geometry.setAttribute(name, new THREE.Float32BufferAttribute(numbers, size));
  }
  for (const [name, [numbers, size]] of Object.entries(instances)) {
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(new Float32Array(numbers), size));
    geometry.instanceCount = numbers.length / size;
  }
  return geometry;
}

function mesh(
  geometry: THREE.BufferGeometry,
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
  const result = new THREE.Mesh(geometry, material);
  result.frustumCulled = false;
  return result;
}

/** Symbols at the markers, always in front. */
export function markerMesh(scene: Scene, points: PointTextures, shared: SharedUniforms): THREE.Mesh {
  const kinds = scene.markers.map((m) => Math.max(0, ["joint", "probe", "load"].indexOf(m.kind)));
  const geometry = instancedGeometry({ corner: [[-1, -1, 1, -1, 1, 1, -1, 1], 2] }, [0, 1, 2, 0, 2, 3], {
    marker: [scene.markers.map((_, i) => points.markers + i), 1],
    kind: [kinds, 1],
  });
  const symbols = mesh(geometry, MARKER_VERTEX, MARKER_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      width: { value: 13 },
      symbolColours: { value: colourVectors(MARKER_COLOURS) },
      background: { value: new THREE.Vector3(1, 1, 1) },
    },
    transparent: true,
    premultipliedAlpha: true,
    depthTest: false,
    depthWrite: false,
  });
  symbols.renderOrder = 3;
  return symbols;
}

/** Length in space per unit of force and of moment. */
function arrowLengths(scene: Scene, longest: number): THREE.Vector2 {
  const [force, moment] = largestReactions(scene.reactions);
  const length = (largest: number) => (largest > 0 ? longest / largest : 0);
  return new THREE.Vector2(length(force), length(moment));
}

/** Vertices of a shaft and two heads; `ARROW_VERTEX` explains the numbers of `shape`. */
function arrowVertices(): { shape: number[]; secondHead: number[]; index: number[] } {
  const rings = [
    [0, 0, 0.14, 0],
    [1, 0.9, 0.14, 0],
    [1, 1, 0.42, 0],
    [1, 0, 0, 0],
    [1, 1.75, 0.42, 1],
    [1, 0.75, 0, 1],
  ];
  const shape: number[] = [];
  const secondHead: number[] = [];
  const index: number[] = [];
  rings.forEach(([position, shift, radius, head], row) => {
    for (let i = 0; i <= ARROW_SIDES; i++) {
      shape.push(position, shift, radius, (2 * Math.PI * i) / ARROW_SIDES);
      secondHead.push(head);
      if (row % 2 === 0 && i < ARROW_SIDES) {
        const k = row * (ARROW_SIDES + 1) + i;
        index.push(k, k + 1, k + ARROW_SIDES + 1, k + 1, k + ARROW_SIDES + 2, k + ARROW_SIDES + 1);
      }
    }
  });
  return { shape, secondHead, index };
}

/** Arrows of reaction forces (one head) and moments (two heads); `longest` is the length of the longest one. */
export function reactionMesh(
  scene: Scene,
  points: PointTextures,
  shared: SharedUniforms,
  longest: number,
): THREE.Mesh {
  const { shape, secondHead, index } = arrowVertices();
  const anchor: number[] = [];
  const moment: number[] = [];
  scene.reactions.forEach((r, i) => {
    for (const part of [0, 1]) {
      anchor.push(points.markers + r.marker, points.reactions + 2 * i + part);
      moment.push(part);
    }
  });
  const geometry = instancedGeometry({ shape: [shape, 4], secondHead: [secondHead, 1] }, index, {
    anchor: [anchor, 2],
    moment: [moment, 1],
  });
  return mesh(geometry, ARROW_VERTEX, SOLID_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      head: { value: 17 },
      lengths: { value: arrowLengths(scene, longest) },
      solidColours: { value: colourVectors(SOLID_COLOURS) },
    },
  });
}

/** Links: springs as coils, all others as rods. */
export function linkMesh(scene: Scene, points: PointTextures, shared: SharedUniforms): THREE.Mesh {
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
  const colour = (kind: string) => ({ spring: 2, damper: 3 })[kind] ?? 4;
  const geometry = instancedGeometry({ shape: [shape, 2] }, index, {
    firstEnd: [scene.links.map((_, i) => points.links + 2 * i), 1],
    turns: [scene.links.map((l) => (l.kind === "spring" ? 8 : 0)), 1],
    colour: [scene.links.map((l) => colour(l.kind)), 1],
    radiusFactor: [scene.links.map((l) => (l.kind === "arm" || l.kind === "damper" ? 2.5 : 1)), 1],
  });
  return mesh(geometry, LINK_VERTEX, SOLID_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      coil: { value: 0.024 * scene.size },
      wire: { value: 0.0035 * scene.size },
      minPixels: { value: 1 },
      solidColours: { value: colourVectors(SOLID_COLOURS) },
    },
  });
}
