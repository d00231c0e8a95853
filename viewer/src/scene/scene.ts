// The scene: what a simulation left to look at, read from its binary container.

export type Numbers = Float32Array | Float64Array | Int16Array | Uint16Array | Uint32Array;
export type Vector = [number, number, number];

export interface Body {
  name: string;
  kind: "beam" | "cable" | "rigid" | "point";
  /** Stations first .. first + count of the scene are this body's. */
  first: number;
  count: number;
  outline: number[][];
  inner: number[][] | null;
  scale: Numbers | null;
  nodes: number[];
  box: Vector | null;
}

export interface Field {
  name: string;
  symbol: string;
  unit: string;
  diverging: boolean;
  range: [number, number];
  /** [F][P], (value - min) / (max - min) * 65534; 65535 is not a number. */
  values: Numbers;
}

export interface Marker {
  name: string;
  kind: "joint" | "probe" | "load";
  detail: string;
  at: Numbers;
  reference?: Vector | null;
}

export interface Reaction {
  name: string;
  marker: number;
  force: Numbers;
  moment: Numbers;
}

export interface Link {
  name: string;
  /** An arm goes from the centre of a rigid body to a joint. */
  kind: "spring" | "damper" | "rope" | "rod" | "bushing" | "arm";
  ends: Numbers;
  reference?: [Vector, Vector] | null;
}

export interface Obstacle {
  name: string;
  kind: "plane" | "sphere" | "cylinder";
  radius: number;
  length: number | null;
  /** What touches it is within. */
  inside?: boolean;
  pose: Numbers;
}

export interface Column {
  name: string;
  label: string;
  unit: string;
  values: Numbers;
}

export interface Chart {
  title: string;
  group: string;
  log: boolean;
  columns: Column[];
}

export interface Scene {
  program: string;
  title: string;
  text: string;
  sha256: string;
  analysis: "dynamics" | "statics" | "path" | "modes" | "buckling";
  units: { length: string; time: string; force: string } | null;
  outcome: { kind: "finished" | "stopped" | "failed" | "running"; message: string };
  live: boolean;
  summary: [string, string][];
  messages: string[];
  bounds: [Vector, Vector];
  size: number;
  up: Vector;
  frames: { count: number; values: Numbers; labels: string[] | null };
  stations: number;
  bodies: Body[];
  centres: Numbers;
  directors: Numbers;
  reference: { centres: Numbers; directors: Numbers };
  fields: Field[];
  markers: Marker[];
  reactions: Reaction[];
  links: Link[];
  obstacles: Obstacle[];
  charts: Chart[];
  abscissa: { name: string; unit: string; values: Numbers };
}

/** A scene that cannot be read; its message is a sentence for the reader of the page. */
export class SceneError extends Error {}

const KINDS = {
  f32: Float32Array,
  f64: Float64Array,
  i16: Int16Array,
  u16: Uint16Array,
  u32: Uint32Array,
} as const;

type Reference = { type: keyof typeof KINDS; at: number; count: number };

function isReference(value: unknown): value is Reference {
  const it = value as Partial<Reference> | null;
  return (
    typeof it?.type === "string" && it.type in KINDS && Number.isInteger(it.at) && Number.isInteger(it.count)
  );
}

/** Replaces every description of an array in `value` by the array itself. */
function resolve(value: unknown, blob: ArrayBuffer, start: number): unknown {
  if (isReference(value)) {
    const kind = KINDS[value.type];
    const { at, count } = value;
    if (at < 0 || count < 0 || start + at + count * kind.BYTES_PER_ELEMENT > blob.byteLength) {
      throw new SceneError("The data of this page are incomplete: an array reaches beyond their end.");
    }
    return new kind(blob, start + at, count);
  }
  if (Array.isArray(value)) {
    return typeof value[0] === "object" ? value.map((item) => resolve(item, blob, start)) : value;
  }
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, resolve(v, blob, start)]));
  }
  return value;
}

/** Reads a container; see docs of the container for its layout. */
export function decode(bytes: ArrayBuffer): Scene {
  const view = new DataView(bytes);
  if (bytes.byteLength < 16 || view.getUint32(0, false) !== 0x414e4346) {
    throw new SceneError("The data of this page are not a scene of ancf.");
  }
  const version = view.getUint32(4, true);
  if (version !== 1) {
    throw new SceneError(`The data of this page have version ${version}; this viewer reads version 1.`);
  }
  const length = view.getUint32(8, true);
  const start = 16 + Math.ceil(length / 8) * 8;
  if (16 + length > bytes.byteLength) {
    throw new SceneError("The data of this page are incomplete: they end within their header.");
  }
  let header: unknown;
  try {
    header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 16, length)));
  } catch {
    throw new SceneError("The data of this page are damaged: their header cannot be read.");
  }
  return complete(resolve(header, bytes, start) as Partial<Scene>);
}

function complete(raw: Partial<Scene>): Scene {
  const none = new Float32Array(0);
  const scene: Scene = {
    ...{ program: "ancf", title: "", text: "", sha256: "", analysis: "dynamics", units: null, live: false },
    ...{
      outcome: { kind: "finished", message: "" },
      summary: [],
      messages: [],
      size: 0,
      stations: 0,
      bodies: [],
    },
    ...{ frames: { count: 0, values: none, labels: null }, centres: none, directors: none, up: [0, 1, 0] },
    ...{ reference: { centres: none, directors: none }, fields: [], markers: [], reactions: [], links: [] },
    ...{ obstacles: [], charts: [], abscissa: { name: "t", unit: "", values: none } },
    bounds: [
      [0, 0, 0],
      [1, 1, 1],
    ],
    ...raw,
  };
  check(scene);
  const [low, high] = scene.bounds;
  const diagonal = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (!(scene.size > 0)) scene.size = diagonal > 0 ? diagonal : 1;
  return scene;
}

/** Every array that the picture indexes has the length it is indexed by. */
function check(scene: Scene): void {
  const frames = scene.frames.count;
  const points = scene.stations;
  const demand = (found: Numbers, wanted: number, name: string) => {
    if (!ArrayBuffer.isView(found) || found.length !== wanted) {
      const count = ArrayBuffer.isView(found) ? found.length : "no";
      throw new SceneError(`The data of this page are damaged: ${name} has ${count} numbers, not ${wanted}.`);
    }
  };
  demand(scene.frames.values, frames, "frames");
  demand(scene.centres, 3 * frames * points, "centres");
  demand(scene.directors, 9 * frames * points, "directors");
  demand(scene.reference.centres, 3 * points, "centres of the reference shape");
  demand(scene.reference.directors, 9 * points, "directors of the reference shape");
  for (const field of scene.fields) demand(field.values, frames * points, field.name);
  for (const marker of scene.markers) demand(marker.at, 3 * frames, marker.name);
  for (const link of scene.links) demand(link.ends, 6 * frames, link.name);
  for (const reaction of scene.reactions) {
    demand(reaction.force, 3 * frames, `force of ${reaction.name}`);
    demand(reaction.moment, 3 * frames, `moment of ${reaction.name}`);
    if (!scene.markers[reaction.marker]) {
      throw new SceneError(`The data of this page are damaged: the reaction ${reaction.name} has no marker.`);
    }
  }
  for (const body of scene.bodies) {
    if (!(body.first >= 0 && body.first + body.count <= points)) {
      throw new SceneError(`The data of this page are damaged: the body ${body.name} has no such stations.`);
    }
    if (body.scale) demand(body.scale, 2 * body.count, `scale of ${body.name}`);
  }
}

/** Modes and buckling shapes are looked at one by one, swinging; everything else is a film. */
export function isModal(scene: Scene): boolean {
  return scene.analysis === "modes" || scene.analysis === "buckling";
}

/** The value of a field at an entry of its array, NaN where it has none. */
export function fieldValue(field: Field, entry: number): number {
  const [low, high] = field.range;
  const raw = field.values[entry];
  return raw === 65535 ? Number.NaN : low + (raw / 65534) * (high - low);
}

/** A film that ended where it should not have. */
export function failed(scene: Scene): boolean {
  return scene.outcome.kind === "failed" && !isModal(scene);
}
