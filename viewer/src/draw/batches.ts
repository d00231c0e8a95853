// What the shader of bodies sweeps: rings between two stations, caps at the ends, boxes and spheres; each drawn for
// many instances at once.

import { radius } from "../scene/blend";
import type { Body, Scene } from "../scene/scene";

/** A shape in section coordinates (along d1, d2, d3), to be drawn at each of its instances. */
export interface Shape {
  local: number[];
  slope: number[];
  /** 0: at the instance's station, 1: at the next one. */
  end: number[];
  index: number[];
}

/** Nine numbers each: station, body, radius, factors near (3) and far (3). */
export const STRIDE = 9;

export interface Batch {
  shape: Shape;
  instances: Float32Array;
  count: number;
}

/** More vertices than this and round sections are drawn with fewer corners. */
const MOST_VERTICES = 3e6;

class Instances {
  private data = new Float32Array(STRIDE * 16);
  count = 0;

  add(station: number, body: number, wide: number, near: ArrayLike<number>, far: ArrayLike<number>): void {
    if (STRIDE * (this.count + 1) > this.data.length) {
      const larger = new Float32Array(2 * this.data.length);
      larger.set(this.data);
      this.data = larger;
    }
    this.data.set([station, body, wide], STRIDE * this.count);
    this.data.set(near, STRIDE * this.count + 3);
    this.data.set(far, STRIDE * this.count + 6);
    this.count += 1;
  }

  batch(shape: Shape): Batch {
    return { shape, instances: this.data.subarray(0, STRIDE * this.count), count: this.count };
  }
}

/** All that is drawn of the bodies. */
export function batches(scene: Scene): Batch[] {
  const coarse = coarseness(scene.bodies);
  const found = new Map<string, { shape: Shape; instances: Instances }>();
  const group = (key: string, make: () => Shape) => {
    let entry = found.get(key);
    if (!entry) {
      entry = { shape: make(), instances: new Instances() };
      found.set(key, entry);
    }
    return entry.instances;
  };
  scene.bodies.forEach((body, number) => {
    if (body.count === 0) return;
    const wide = radius(body);
    if (body.box || body.outline.length === 0) {
      // Without measures: a small ball.
      const speck = 0.01 * scene.size;
      const round = body.kind === "point" || !body.box;
      const half = body.box && !round ? body.box : new Array(3).fill(body.box?.[0] || speck);
      const shapes = group(round ? "sphere" : "box", round ? sphere : box);
      shapes.add(body.first, number, wide || speck, half, half);
      return;
    }
    const outline = thinned(body.outline, coarse);
    const inner = body.inner && thinned(body.inner, coarse);
    const key = JSON.stringify([outline, inner]);
    const tube = group(`tube ${key}`, () => join(ring(outline), inner ? ring(inner, true) : empty()));
    for (let i = 0; i + 1 < body.count; i++) {
      tube.add(body.first + i, number, wide, factors(body, i), factors(body, i + 1));
    }
    const last = body.count - 1;
    for (const [i, side] of [[0, -1] as const, [last, 1] as const]) {
      const caps = group(`cap ${side} ${key}`, () => cap(outline, inner, side));
      caps.add(body.first + i, number, wide, factors(body, i), factors(body, i));
    }
  });
  return [...found.values()].filter((g) => g.instances.count > 0).map((g) => g.instances.batch(g.shape));
}

function factors(body: Body, i: number): [number, number, number] {
  return body.scale ? [1, body.scale[2 * i], body.scale[2 * i + 1]] : [1, 1, 1];
}

function coarseness(bodies: Body[]): number {
  let vertices = 0;
  for (const b of bodies) vertices += 2 * b.count * (b.outline.length + (b.inner?.length ?? 0));
  return Math.ceil(vertices / MOST_VERTICES);
}

/** Every `step`-th point of a smooth outline, six at least; an outline with corners stays as it is. */
function thinned(outline: number[][], step: number): number[][] {
  const n = outline.length;
  const least = Math.max(1, Math.min(step, Math.floor(n / 6)));
  const corners = outline.some(
    (p, i) => Math.hypot(p[0] - outline[(i + 1) % n][0], p[1] - outline[(i + 1) % n][1]) === 0,
  );
  return corners ? outline : outline.filter((_, i) => i % least === 0);
}

function empty(): Shape {
  return { local: [], slope: [], end: [], index: [] };
}

function join(a: Shape, b: Shape): Shape {
  const shift = a.end.length;
  return {
    local: [...a.local, ...b.local],
    slope: [...a.slope, ...b.slope],
    end: [...a.end, ...b.end],
    index: [...a.index, ...b.index.map((i) => i + shift)],
  };
}

/** The wall between two stations; `inside` of a tube it is seen from within. */
function ring(outline: number[][], inside = false): Shape {
  const shape = empty();
  const n = outline.length;
  const way = inside ? -1 : 1;
  for (const end of [0, 1]) {
    for (const [y, z, ny, nz] of outline) {
      shape.local.push(0, y, z);
      shape.slope.push(0, way * ny, way * nz);
      shape.end.push(end);
    }
  }
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n;
    shape.index.push(i, j, n + i, j, n + j, n + i);
  }
  return shape;
}

/** The face at an end, looking along `side` times d1. */
function cap(outline: number[][], inner: number[][] | null, side: number): Shape {
  const shape = empty();
  const put = (y: number, z: number) => {
    shape.local.push(0, y, z);
    shape.slope.push(side, 0, 0);
    shape.end.push(0);
  };
  const n = outline.length;
  for (const [y, z] of outline) put(y, z);
  if (inner && inner.length > 0) {
    for (const [y, z] of inner) put(y, z);
    const m = inner.length;
    const most = Math.max(n, m);
    for (let k = 0; k < most; k++) {
      const [i, j] = [Math.floor((k * n) / most), Math.floor(((k + 1) * n) / most) % n];
      const [p, q] = [Math.floor((k * m) / most), Math.floor(((k + 1) * m) / most) % m];
      shape.index.push(i, j, n + p, j, n + q, n + p);
    }
  } else {
    put(0, 0);
    for (let i = 0; i < n; i++) shape.index.push(i, (i + 1) % n, n);
  }
  return shape;
}

function box(): Shape {
  const shape = empty();
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const first = shape.end.length;
      for (const [a, b] of [
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ]) {
        const corner = [0, 0, 0];
        const normal = [0, 0, 0];
        corner[axis] = side;
        corner[(axis + 1) % 3] = a;
        corner[(axis + 2) % 3] = b;
        normal[axis] = side;
        shape.local.push(...corner);
        shape.slope.push(...normal);
        shape.end.push(0);
      }
      shape.index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return shape;
}

function sphere(): Shape {
  const shape = empty();
  const [around, up] = [24, 12];
  for (let j = 0; j <= up; j++) {
    for (let i = 0; i <= around; i++) {
      const [theta, phi] = [(Math.PI * j) / up, (2 * Math.PI * i) / around];
      const n = [Math.cos(theta), Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi)];
      shape.local.push(...n);
      shape.slope.push(...n);
      shape.end.push(0);
      if (i < around && j < up) {
        const k = j * (around + 1) + i;
        shape.index.push(k, k + 1, k + around + 1, k + 1, k + around + 2, k + around + 1);
      }
    }
  }
  return shape;
}
