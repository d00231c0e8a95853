// Mesh templates in section coordinates: tube walls, end caps, boxes, spheres and shells.

import type { Body, Grid } from "../scene/scene";

/** Mesh in section coordinates (along d1, d2, d3) that is drawn once per instance. */
export interface MeshTemplate {
  /** True if the indices are pairs of points of lines, otherwise the corners of triangles. */
  isLines: boolean;
  /** True for a shell, whose lines are the edges of elements. */
  isShell?: boolean;
  local: number[];
  normal: number[];
  /** Station of each vertex: 0 for the station of the instance, 1 for the next one, and so on. */
  end: number[];
  /** Coordinates on a face, two per vertex; edges are at odd numbers. Empty if the mesh has no edges. */
  face: number[];
  index: number[];
}

function empty(): MeshTemplate {
  return { isLines: false, local: [], normal: [], end: [], face: [], index: [] };
}

/** True if an outline has corners, which are pairs of points at one place. */
export function isPolygon(outline: number[][]): boolean {
  const n = outline.length;
  return outline.some(
    (p, i) => Math.hypot(p[0] - outline[(i + 1) % n][0], p[1] - outline[(i + 1) % n][1]) === 0,
  );
}

/** Wall between two stations; `sign` is -1 for a bore, whose normals point inwards. */
export function wall(outline: number[][], sign: number): MeshTemplate {
  const template = empty();
  const n = outline.length;
  for (const end of [0, 1]) {
    for (const [y, z, ny, nz] of outline) {
      template.local.push(0, y, z);
      template.normal.push(0, sign * ny, sign * nz);
      template.end.push(end);
    }
    // A polygon has two points per corner: the start and the end of each side.
    const hasCorners = isPolygon(outline);
    for (let i = 0; i < n; i++) template.face.push(hasCorners ? (i % 2 === 0 ? -1 : 1) : 0, 0);
  }
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n;
    template.index.push(i, j, n + i, j, n + j, n + i);
  }
  return template;
}

/** End face with the normal `side` times d1. */
export function cap(outline: number[][], inner: number[][] | null, side: number): MeshTemplate {
  const template = empty();
  const addVertex = (y: number, z: number, rim: number) => {
    template.local.push(0, y, z);
    template.normal.push(side, 0, 0);
    template.end.push(0);
    template.face.push(rim, 0);
  };
  const n = outline.length;
  for (const [y, z] of outline) addVertex(y, z, 1);
  if (inner && inner.length > 0) {
    for (const [y, z] of inner) addVertex(y, z, -1);
    const m = inner.length;
    const count = Math.max(n, m);
    for (let k = 0; k < count; k++) {
      const [i, j] = [Math.floor((k * n) / count), Math.floor(((k + 1) * n) / count) % n];
      const [p, q] = [Math.floor((k * m) / count), Math.floor(((k + 1) * m) / count) % m];
      template.index.push(i, j, n + p, j, n + q, n + p);
    }
  } else {
    addVertex(0, 0, 0);
    for (let i = 0; i < n; i++) template.index.push(i, (i + 1) % n, n);
  }
  return template;
}

/** Triangles of a rigid body. */
export function triangles(surface: NonNullable<Body["surface"]>): MeshTemplate {
  const count = surface.points.length / 3;
  return {
    isLines: false,
    local: Array.from(surface.points),
    normal: Array.from(surface.normals, (n) => n / 32767),
    end: new Array(count).fill(0),
    face: new Array(2 * count).fill(0),
    index: Array.from(surface.corners),
  };
}

/** Box with half edges of length one. */
export function box(): MeshTemplate {
  const template = empty();
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const first = template.end.length;
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
        template.local.push(...corner);
        template.normal.push(...normal);
        template.face.push(a, b);
        template.end.push(0);
      }
      template.index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    }
  }
  return template;
}

/** Sphere of radius one. */
export function sphere(): MeshTemplate {
  const template = empty();
  const [meridians, parallels] = [24, 12];
  for (let j = 0; j <= parallels; j++) {
    for (let i = 0; i <= meridians; i++) {
      const [theta, phi] = [(Math.PI * j) / parallels, (2 * Math.PI * i) / meridians];
      const n = [Math.cos(theta), Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi)];
      template.local.push(...n);
      template.normal.push(...n);
      template.end.push(0);
      if (i < meridians && j < parallels) {
        const k = j * (meridians + 1) + i;
        template.index.push(k, k + 1, k + meridians + 1, k + 1, k + meridians + 2, k + meridians + 1);
      }
    }
  }
  return template;
}

/** Faces at half of the thickness along the normal d1, with lines along the edges of elements, and the border between them. */
export function shell({ counts: [n, m], parts, half }: Grid): MeshTemplate {
  const template = { ...empty(), isShell: true };
  for (const side of [1, -1]) {
    const first = template.end.length;
    for (let k = 0; k < n * m; k++) {
      template.local.push(side * half, 0, 0);
      template.normal.push(side, 0, 0);
      template.end.push(k);
      // The edges of elements are at odd numbers.
      template.face.push((2 * (k % n)) / parts - 1, (2 * Math.floor(k / n)) / parts - 1);
    }
    for (let j = 0; j + 1 < m; j++) {
      for (let i = 0; i + 1 < n; i++) {
        const k = first + j * n + i;
        if (side > 0) template.index.push(k, k + 1, k + n + 1, k, k + n + 1, k + n);
        else template.index.push(k, k + n + 1, k + 1, k, k + n, k + n + 1);
      }
    }
  }
  addBorder(template, n, m, half);
  return template;
}

/** Adds the four walls of the border. Their normals are the tangents of the surface d2 and d3. */
function addBorder(template: MeshTemplate, n: number, m: number, half: number): void {
  const along = (count: number, first: number, step: number) =>
    Array.from({ length: count }, (_, i) => first + i * step);
  const walls: [stations: number[], normal: number[]][] = [
    [along(n, 0, 1), [0, 0, -1]],
    [along(n, (m - 1) * n, 1), [0, 0, 1]],
    [along(m, 0, n), [0, -1, 0]],
    [along(m, n - 1, n), [0, 1, 0]],
  ];
  for (const [stations, normal] of walls) {
    const first = template.end.length;
    for (const station of stations) {
      for (const side of [1, -1]) {
        template.local.push(side * half, 0, 0);
        template.normal.push(...normal);
        template.end.push(station);
        template.face.push(0, 0);
      }
    }
    for (let k = first; k + 2 < template.end.length; k += 2)
      template.index.push(k, k + 1, k + 3, k, k + 3, k + 2);
  }
}
