// Instances of the mesh templates: tube walls between two stations, end caps, shells, boxes and spheres.

import { bodyRadius } from "../scene/geometry";
import type { Body, Grid, Scene } from "../scene/scene";
import { creases } from "./creases";
import { box, cap, isPolygon, type MeshTemplate, shell, sphere, triangles, wall } from "./templates";

/** Numbers per instance: station, body, radius, scale factors at the start (3) and at the end (3). */
export const STRIDE = 9;

/** Instances that share a template and are drawn at once. */
export interface InstanceBatch {
  template: MeshTemplate;
  instances: Float32Array;
  count: number;
}

/** Number of vertices above which smooth outlines are coarsened. */
const MAX_VERTICES = 3e6;
/** Size of a body without dimensions, relative to the model. */
const DEFAULT_SIZE = 0.01;

/** Growing list of instances of a template. */
class InstanceList {
  private data = new Float32Array(STRIDE * 16);
  private count = 0;

  constructor(private readonly template: MeshTemplate) {}

  add(station: number, body: number, radius: number, start: ArrayLike<number>, end: ArrayLike<number>): void {
    if (STRIDE * (this.count + 1) > this.data.length) {
      const larger = new Float32Array(2 * this.data.length);
      larger.set(this.data);
      this.data = larger;
    }
    this.data.set([station, body, radius], STRIDE * this.count);
    this.data.set(start, STRIDE * this.count + 3);
    this.data.set(end, STRIDE * this.count + 6);
    this.count += 1;
  }

  batch(): InstanceBatch {
    return {
      template: this.template,
      instances: this.data.subarray(0, STRIDE * this.count),
      count: this.count,
    };
  }
}

/** Instance lists by template. */
class InstanceLists {
  private readonly lists = new Map<string, InstanceList>();

  /** Returns the list with a key, and creates its template if there is none. */
  get(key: string, template: () => MeshTemplate): InstanceList {
    const known = this.lists.get(key);
    if (known) return known;
    const list = new InstanceList(template());
    this.lists.set(key, list);
    return list;
  }

  batches(): InstanceBatch[] {
    return [...this.lists.values()].map((list) => list.batch()).filter((batch) => batch.count > 0);
  }
}

/** Batches of all bodies of a scene. */
export function bodyBatches(scene: Scene): InstanceBatch[] {
  const step = coarsening(scene.bodies);
  const lists = new InstanceLists();
  scene.bodies.forEach((body, number) => {
    if (body.count === 0) return;
    if (body.grid) addShell(lists, body, body.grid, number);
    else if (body.surface) addSurface(lists, body, number);
    else if (body.box || body.outline.length === 0) addRigid(lists, body, number, DEFAULT_SIZE * scene.size);
    else addSwept(lists, body, number, step);
  });
  return lists.batches();
}

/** Adds a box or a sphere. Bodies without dimensions are drawn as spheres of radius `fallback`. */
function addRigid(lists: InstanceLists, body: Body, number: number, fallback: number): void {
  const round = body.kind === "point" || !body.box;
  const half = body.box && !round ? body.box : new Array(3).fill(body.box?.[0] || fallback);
  const list = lists.get(round ? "sphere" : "box", round ? sphere : box);
  list.add(body.first, number, bodyRadius(body) || fallback, half, half);
}

/** Adds both faces and the border of a shell. */
function addShell(lists: InstanceLists, body: Body, grid: Grid, number: number): void {
  const list = lists.get(JSON.stringify({ ...grid, patches: 1 }), () => shell(grid));
  const stride = grid.counts[0] * grid.counts[1];
  for (let k = 0; k < grid.patches; k++) {
    list.add(body.first + k * stride, number, grid.half, [1, 1, 1], [1, 1, 1]);
  }
}

/** Adds the triangles of a body and its edges. */
function addSurface(lists: InstanceLists, body: Body, number: number): void {
  const { surface } = body;
  if (!surface) return;
  const parts = [
    lists.get(`surface ${number}`, () => triangles(surface)),
    lists.get(`edges ${number}`, () => creases(surface)),
  ];
  for (const list of parts) list.add(body.first, number, bodyRadius(body), [1, 1, 1], [1, 1, 1]);
}

/** Adds the walls and caps of a body with a section. */
function addSwept(lists: InstanceLists, body: Body, number: number, step: number): void {
  const radius = bodyRadius(body);
  const outline = coarsened(body.outline, step);
  const inner = body.inner && coarsened(body.inner, step);
  const addWalls = (points: number[][], sign: number, scale: typeof sectionScale) => {
    const walls = lists.get(`wall ${sign} ${JSON.stringify(points)}`, () => wall(points, sign));
    for (let i = 0; i + 1 < body.count; i++) {
      walls.add(body.first + i, number, radius, scale(body, i), scale(body, i + 1));
    }
  };
  addWalls(outline, 1, sectionScale);
  if (inner) addWalls(inner, -1, boreScale);
  const last = body.count - 1;
  for (const [i, side] of [[0, -1] as const, [last, 1] as const]) {
    const [scale, bore] = [sectionScale(body, i), boreScale(body, i)];
    const hole = inner?.map(([y, z]) => [(y * bore[1]) / scale[1], (z * bore[2]) / scale[2]]) ?? null;
    const key = JSON.stringify([outline, hole]);
    const caps = lists.get(`cap ${side} ${key}`, () => cap(outline, hole, side));
    caps.add(body.first + i, number, radius, scale, scale);
  }
}

/** Scale factors of the section at a station, along d1, d2, d3. */
function sectionScale(body: Body, i: number): [number, number, number] {
  return body.scale ? [1, body.scale[2 * i], body.scale[2 * i + 1]] : [1, 1, 1];
}

/** Scale factors of the bore at a station, along d1, d2, d3. */
function boreScale(body: Body, i: number): [number, number, number] {
  return body.bore ? [1, body.bore[i], body.bore[i]] : [1, 1, 1];
}

/** Step between the outline points that are drawn, from the number of vertices. */
function coarsening(bodies: Body[]): number {
  let vertices = 0;
  for (const b of bodies) vertices += 2 * b.count * (b.outline.length + (b.inner?.length ?? 0));
  return Math.ceil(vertices / MAX_VERTICES);
}

/** Every `step`-th point of a smooth outline, at least six. An outline with corners is not changed. */
function coarsened(outline: number[][], step: number): number[][] {
  const n = outline.length;
  const stride = Math.max(1, Math.min(step, Math.floor(n / 6)));
  return isPolygon(outline) ? outline : outline.filter((_, i) => i % stride === 0);
}
