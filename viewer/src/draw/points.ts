// Textures of all moving points: stations of bodies, markers, ends of links, reactions. They are uploaded once.

import * as THREE from "three";
import { distance } from "../scene/geometry";
import { type Scene, storedFrames, type Vector } from "../scene/scene";
import { TEXTURE_WIDTH } from "./shaders/point";

/**
 * Layout of a frame in the texture of positions: P stations, M markers, 2 L ends of links, force and moment of each of R
 * reactions, then the vectors of the loads on shells. Forces and moments are vectors and are not scaled.
 */
export class PointTextures {
  /** Number of points of a frame. */
  readonly count: number;
  /** Indices of the first marker, link end and reaction. */
  readonly markers: number;
  readonly links: number;
  readonly reactions: number;
  /** Index of the first vector of each load on a shell. */
  readonly loads: number[] = [];
  /** Reference positions of all points. Markers and links without one use that of the nearest station. */
  readonly reference: Float32Array;
  readonly centres: THREE.DataTexture;
  readonly directors: THREE.DataTexture;
  readonly referenceCentres: THREE.DataTexture;
  readonly referenceDirectors: THREE.DataTexture;

  constructor(private readonly scene: Scene) {
    this.markers = scene.stations;
    this.links = this.markers + scene.markers.length;
    this.reactions = this.links + 2 * scene.links.length;
    let count = this.reactions + 2 * scene.reactions.length;
    for (const load of scene.loads) {
      this.loads.push(count);
      count += load.stations.length;
    }
    this.count = count;
    const frames = storedFrames(scene);
    this.reference = this.referencePositions();
    this.centres = positionTexture(this.framePositions(), frames * this.count);
    this.referenceCentres = positionTexture(referenceTexels(this.reference), this.count);
    this.directors = directorTexture(scene.directors, frames * scene.stations);
    this.referenceDirectors = directorTexture(scene.reference.directors, scene.stations);
  }

  /** Creates the texture of the values of a field. */
  fieldTexture(index: number): THREE.DataTexture {
    const data = this.scene.fields[index].values;
    const texels = new Uint16Array(TEXTURE_WIDTH * rows(data.length));
    texels.set(data);
    return texture(texels, data.length, THREE.RedIntegerFormat, THREE.UnsignedShortType, "R16UI");
  }

  dispose(): void {
    for (const t of [this.centres, this.directors, this.referenceCentres, this.referenceDirectors])
      t.dispose();
  }

  private referencePositions(): Float32Array {
    const { scene } = this;
    const positions = new Float32Array(3 * this.count).fill(Number.NaN);
    positions.set(scene.reference.centres);
    scene.markers.forEach((m, i) => {
      positions.set(m.reference ?? this.guessReference(m.at), 3 * (this.markers + i));
    });
    scene.links.forEach((l, i) => {
      for (const end of [0, 1]) {
        const at = l.ends.subarray(3 * end, 3 * end + 3);
        positions.set(l.reference?.[end] ?? this.guessReference(at), 3 * (this.links + 2 * i + end));
      }
    });
    return positions;
  }

  /** Reference position of the station at a point of the first frame. NaN if there is none: the point is not scaled. */
  private guessReference(at: ArrayLike<number>): Vector {
    const { scene } = this;
    let nearest = 1e-3 * scene.size;
    let found: Vector = [Number.NaN, Number.NaN, Number.NaN];
    if (scene.frames.count === 0) return found;
    for (let i = 0; i < scene.stations; i++) {
      const d = distance(scene.centres.subarray(3 * i, 3 * i + 3), at);
      if (d < nearest) {
        nearest = d;
        found = [0, 1, 2].map((k) => scene.reference.centres[3 * i + k]) as Vector;
      }
    }
    return found;
  }

  private framePositions(): Float32Array<ArrayBuffer> {
    const { scene, count } = this;
    const frames = storedFrames(scene);
    const data = new Float32Array(4 * TEXTURE_WIDTH * rows(frames * count));
    let to = 0;
    const append = (from: ArrayLike<number>, first: number, points: number) => {
      for (let i = 3 * first; i < 3 * (first + points); i += 3, to += 4) {
        data[to] = from[i];
        data[to + 1] = from[i + 1];
        data[to + 2] = from[i + 2];
      }
    };
    for (let f = 0; f < frames; f++) {
      append(scene.centres, f * scene.stations, scene.stations);
      for (const marker of scene.markers) append(marker.at, f, 1);
      for (const link of scene.links) append(link.ends, 2 * f, 2);
      for (const reaction of scene.reactions) {
        append(reaction.force, f, 1);
        append(reaction.moment, f, 1);
      }
      for (const { vectors, stations } of scene.loads) append(vectors, f * stations.length, stations.length);
    }
    return data;
  }
}

/** Rows of a texture with a number of texels. */
function rows(texels: number): number {
  return Math.max(1, Math.ceil(texels / TEXTURE_WIDTH));
}

/** Reference positions with w = 1, or w = 0 where a point has no reference. */
function referenceTexels(positions: Float32Array): Float32Array<ArrayBuffer> {
  const data = new Float32Array(4 * TEXTURE_WIDTH * rows(positions.length / 3));
  for (let i = 0, to = 0; i < positions.length; i += 3, to += 4) {
    if (Number.isNaN(positions[i])) continue;
    data.set(positions.subarray(i, i + 3), to);
    data[to + 3] = 1;
  }
  return data;
}

function positionTexture(data: Float32Array<ArrayBuffer>, texels: number): THREE.DataTexture {
  return texture(data, texels, THREE.RGBAFormat, THREE.FloatType, "RGBA32F");
}

/** Directors d2 and d3 as six 16-bit numbers in the four words of a texel; d1 = d2 × d3. */
function directorTexture(directors: ArrayLike<number>, texels: number): THREE.DataTexture {
  const packed = new Int16Array(8 * TEXTURE_WIDTH * rows(texels));
  for (let i = 0, to = 0; i < directors.length; i += 9, to += 8) {
    for (let k = 0; k < 6; k++) packed[to + k] = directors[i + 3 + k];
  }
  const words = new Uint32Array(packed.buffer);
  return texture(words, texels, THREE.RGBAIntegerFormat, THREE.UnsignedIntType, "RGBA32UI");
}

function texture(
  data: Float32Array<ArrayBuffer> | Uint16Array<ArrayBuffer> | Uint32Array<ArrayBuffer>,
  texels: number,
  format: THREE.PixelFormat,
  type: THREE.TextureDataType,
  internal: THREE.PixelFormatGPU,
): THREE.DataTexture {
  const result = new THREE.DataTexture(data, TEXTURE_WIDTH, rows(texels), format, type);
  result.internalFormat = internal;
  result.unpackAlignment = 4;
  result.needsUpdate = true;
  return result;
}
