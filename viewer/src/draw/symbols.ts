// Markers of joints, probes and loads, arrows of reactions and loads, supported edges, links between bodies.

import * as THREE from "three";
import { largestReactions, largestVector } from "../scene/reactions";
import type { Scene } from "../scene/scene";
import { LOAD_ARROW } from "../view/extent";
import type { PointTextures } from "./points";
import { ARROW_VERTEX, LINK_VERTEX, MARKER_FRAGMENT, MARKER_VERTEX, SOLID_FRAGMENT } from "./shaders/symbols";
import type { SharedUniforms } from "./uniforms";

/** Colours of joints, probes and loads. */
const MARKER_COLOURS = ["#e08a00", "#2f80ed", "#d33f6a"];
/** Colours of forces, moments, springs, dampers, other links, loads and supported edges. */
const SOLID_COLOURS = [
  "#d9480f",
  "#8e44ad",
  "#3a9d5d",
  "#6c7ae0",
  "#8a939c",
  MARKER_COLOURS[2],
  MARKER_COLOURS[0],
];
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

/** Length in space of an arrow per unit of a vector; `longest` is that of the largest one. */
function lengthPerUnit(longest: number, largest: number): number {
  return largest > 0 ? longest / largest : 0;
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

/** Instances of arrows: base and vector in the texture of points, kind, length per unit, colour. */
class Arrows {
  private readonly anchor: number[] = [];
  private readonly moment: number[] = [];
  private readonly perUnit: number[] = [];
  private readonly colour: number[] = [];

  add(base: number, vector: number, moment: boolean, perUnit: number, colour: number): void {
    this.anchor.push(base, vector);
    this.moment.push(moment ? 1 : 0);
    this.perUnit.push(perUnit);
    this.colour.push(colour);
  }

  /** Mesh of the arrows with heads of a length in pixels. */
  mesh(shared: SharedUniforms, head: number): THREE.Mesh {
    const { shape, secondHead, index } = arrowVertices();
    const { anchor, moment, perUnit, colour } = this;
    const geometry = instancedGeometry({ shape: [shape, 4], secondHead: [secondHead, 1] }, index, {
      ...{ anchor: [anchor, 2], moment: [moment, 1] },
      ...{ perUnit: [perUnit, 1], colour: [colour, 1] },
    });
    return mesh(geometry, ARROW_VERTEX, SOLID_FRAGMENT, {
      uniforms: {
        ...shared.uniforms,
        head: { value: head },
        solidColours: { value: colourVectors(SOLID_COLOURS) },
      },
    });
  }
}

/** Arrows of reaction forces (one head) and moments (two heads); `longest` is the length of the longest one. */
export function reactionMesh(
  scene: Scene,
  points: PointTextures,
  shared: SharedUniforms,
  longest: number,
): THREE.Mesh {
  const arrows = new Arrows();
  const largest = largestReactions(scene.reactions);
  scene.reactions.forEach((r, i) => {
    for (const part of [0, 1]) {
      const vector = points.reactions + 2 * i + part;
      arrows.add(points.markers + r.marker, vector, part === 1, lengthPerUnit(longest, largest[part]), part);
    }
  });
  return arrows.mesh(shared, 17);
}

/** Arrows of the loads on shells. The longest arrow of each load has the same length. */
export function loadMesh(
  scene: Scene,
  points: PointTextures,
  shared: SharedUniforms,
  longest: number,
): THREE.Mesh {
  const arrows = new Arrows();
  scene.loads.forEach(({ stations, vectors, moment }, i) => {
    const perUnit = lengthPerUnit(LOAD_ARROW * longest, largestVector(vectors));
    stations.forEach((station, k) => {
      arrows.add(station, points.loads[i] + k, moment, perUnit, 5);
    });
  });
  return arrows.mesh(shared, 9);
}

/** Radius of the rod along a supported edge, relative to half of the thickness of the shell. */
const SUPPORT_ROD = 1.4;

/** Edges of shells along which joints support them, as rods. */
export function supportMesh(scene: Scene, shared: SharedUniforms): THREE.Mesh {
  const ends: number[] = [];
  const radii: number[] = [];
  for (const { stations } of scene.supports) {
    const body = scene.bodies.find(({ first, count }) => stations[0] >= first && stations[0] < first + count);
    const radius = (SUPPORT_ROD * (body?.grid?.half ?? 0)) / wireRadius(scene);
    for (let k = 0; k + 1 < stations.length; k++) {
      ends.push(stations[k], stations[k + 1]);
      radii.push(Math.max(1, radius));
    }
  }
  const all = (value: number): [number[], number] => [radii.map(() => value), 1];
  const { shape, index } = rodVertices(1);
  const geometry = instancedGeometry({ shape: [shape, 2] }, index, {
    ...{ ends: [ends, 2], turns: all(0) },
    ...{ colour: all(6), radiusFactor: [radii, 1] },
  });
  return rodMesh(geometry, scene, shared, 2);
}

/** Radius of rods and wires in space. */
function wireRadius(scene: Scene): number {
  return 0.0035 * scene.size;
}

/** Vertices of a rod of a number of parts along its length; `LINK_VERTEX` explains the numbers of `shape`. */
function rodVertices(steps: number): { shape: number[]; index: number[] } {
  const shape: number[] = [];
  const index: number[] = [];
  const sides = 6;
  for (let j = 0; j <= steps; j++) {
    for (let i = 0; i <= sides; i++) {
      shape.push(j / steps, (2 * Math.PI * i) / sides);
      if (i < sides && j < steps) {
        const k = j * (sides + 1) + i;
        index.push(k, k + 1, k + sides + 1, k + 1, k + sides + 2, k + sides + 1);
      }
    }
  }
  return { shape, index };
}

/** Mesh of rods with a minimum radius in pixels. */
function rodMesh(
  geometry: THREE.InstancedBufferGeometry,
  scene: Scene,
  shared: SharedUniforms,
  minPixels: number,
): THREE.Mesh {
  return mesh(geometry, LINK_VERTEX, SOLID_FRAGMENT, {
    uniforms: {
      ...shared.uniforms,
      coil: { value: 0.024 * scene.size },
      wire: { value: wireRadius(scene) },
      minPixels: { value: minPixels },
      solidColours: { value: colourVectors(SOLID_COLOURS) },
    },
  });
}

/** Links: springs as coils, all others as rods. */
export function linkMesh(scene: Scene, points: PointTextures, shared: SharedUniforms): THREE.Mesh {
  const colour = (kind: string) => ({ spring: 2, damper: 3 })[kind] ?? 4;
  const { shape, index } = rodVertices(200);
  const geometry = instancedGeometry({ shape: [shape, 2] }, index, {
    ends: [scene.links.flatMap((_, i) => [points.links + 2 * i, points.links + 2 * i + 1]), 2],
    turns: [scene.links.map((l) => (l.kind === "spring" ? 8 : 0)), 1],
    colour: [scene.links.map((l) => colour(l.kind)), 1],
    radiusFactor: [scene.links.map((l) => (l.kind === "arm" || l.kind === "damper" ? 2.5 : 1)), 1],
  });
  return rodMesh(geometry, scene, shared, 1);
}
