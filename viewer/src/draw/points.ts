// Everything that moves, as textures that are uploaded once: stations of bodies, markers, ends of links, arrows.

import * as THREE from "three";
import { distance } from "../scene/blend";
import type { Scene, Vector } from "../scene/scene";

export const WIDTH = 2048;

/**
 * Layout of a frame in the texture of positions: P stations, M markers, 2 L ends of links, then force and moment
 * of each of R reactions, which are vectors and never scaled.
 */
export class Points {
  readonly count: number;
  readonly markers: number;
  readonly links: number;
  readonly reactions: number;
  /** Reference position of every point; of markers and links the given one or that of the nearest station. */
  readonly reference: Float32Array;
  readonly centres: THREE.DataTexture;
  readonly directors: THREE.DataTexture;
  readonly referenceCentres: THREE.DataTexture;
  readonly referenceDirectors: THREE.DataTexture;

  constructor(private readonly scene: Scene) {
    this.markers = scene.stations;
    this.links = this.markers + scene.markers.length;
    this.reactions = this.links + 2 * scene.links.length;
    this.count = this.reactions + 2 * scene.reactions.length;
    this.reference = this.references();
    this.centres = positions(this.frames(), scene.frames.count * this.count);
    this.referenceCentres = positions(quadruple(this.reference), this.count);
    this.directors = orientations(scene.directors, scene.frames.count * scene.stations);
    this.referenceDirectors = orientations(scene.reference.directors, scene.stations);
  }

  /** Texture of the values of a field. */
  field(index: number): THREE.DataTexture {
    const data = this.scene.fields[index].values;
    const padded = new Uint16Array(WIDTH * rows(data.length));
    padded.set(data);
    return texture(padded, data.length, THREE.RedIntegerFormat, THREE.UnsignedShortType, "R16UI");
  }

  dispose(): void {
    for (const t of [this.centres, this.directors, this.referenceCentres, this.referenceDirectors])
      t.dispose();
  }

  private references(): Float32Array {
    const { scene } = this;
    const all = new Float32Array(3 * this.count).fill(Number.NaN);
    all.set(scene.reference.centres);
    scene.markers.forEach((m, i) => {
      all.set(m.reference ?? this.guess(m.at), 3 * (this.markers + i));
    });
    scene.links.forEach((l, i) => {
      for (const end of [0, 1]) {
        const at = l.ends.subarray(3 * end, 3 * end + 3);
        all.set(l.reference?.[end] ?? this.guess(at), 3 * (this.links + 2 * i + end));
      }
    });
    return all;
  }

  /** Reference position of a point that stands at a station in the first frame; NaN: it is never scaled. */
  private guess(at: ArrayLike<number>): Vector {
    const { scene } = this;
    let nearest = 1e-3 * scene.size;
    let found: Vector = [Number.NaN, Number.NaN, Number.NaN];
    if (scene.frames.count === 0) return found;
    for (let i = 0; i < scene.stations; i++) {
      const away = distance(scene.centres.subarray(3 * i, 3 * i + 3), at);
      if (away < nearest) {
        nearest = away;
        found = [0, 1, 2].map((k) => scene.reference.centres[3 * i + k]) as Vector;
      }
    }
    return found;
  }

  private frames(): Float32Array<ArrayBuffer> {
    const { scene, count } = this;
    const data = new Float32Array(4 * WIDTH * rows(scene.frames.count * count));
    let to = 0;
    const put = (from: ArrayLike<number>, first: number, points: number) => {
      for (let i = 3 * first; i < 3 * (first + points); i += 3, to += 4) {
        data[to] = from[i];
        data[to + 1] = from[i + 1];
        data[to + 2] = from[i + 2];
      }
    };
    for (let f = 0; f < scene.frames.count; f++) {
      put(scene.centres, f * scene.stations, scene.stations);
      for (const marker of scene.markers) put(marker.at, f, 1);
      for (const link of scene.links) put(link.ends, 2 * f, 2);
      for (const reaction of scene.reactions) {
        put(reaction.force, f, 1);
        put(reaction.moment, f, 1);
      }
    }
    return data;
  }
}

function rows(texels: number): number {
  return Math.max(1, Math.ceil(texels / WIDTH));
}

function quadruple(triples: Float32Array): Float32Array<ArrayBuffer> {
  const data = new Float32Array(4 * WIDTH * rows(triples.length / 3));
  for (let i = 0, to = 0; i < triples.length; i += 3, to += 4) {
    if (Number.isNaN(triples[i])) continue;
    data.set(triples.subarray(i, i + 3), to);
    data[to + 3] = 1;
  }
  return data;
}

function positions(data: Float32Array<ArrayBuffer>, texels: number): THREE.DataTexture {
  return texture(data, texels, THREE.RGBAFormat, THREE.FloatType, "RGBA32F");
}

/** d2 and d3, six numbers of 16 bits, in the four words of a texel; d1 is d2 × d3. */
function orientations(directors: ArrayLike<number>, texels: number): THREE.DataTexture {
  const packed = new Int16Array(8 * WIDTH * rows(texels));
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
  const made = new THREE.DataTexture(data, WIDTH, rows(texels), format, type);
  made.internalFormat = internal;
  made.unpackAlignment = 4;
  made.needsUpdate = true;
  return made;
}
