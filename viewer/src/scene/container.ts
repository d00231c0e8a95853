// Reader of the binary container; the crate ancf-report documents its layout.

import { checkArrays, damaged } from "./check";
import { type Scene, SceneError } from "./scene";

const ARRAY_TYPES = {
  f32: Float32Array,
  f64: Float64Array,
  i16: Int16Array,
  u16: Uint16Array,
  u32: Uint32Array,
} as const;

const MAGIC = 0x414e4346; // "ANCF"
const VERSION = 1;
const HEADER_START = 16;

/** Description of an array in the header: type, byte offset in the blob, number of elements. */
type ArrayReference = { type: keyof typeof ARRAY_TYPES; at: number; count: number };

function isArrayReference(value: unknown): value is ArrayReference {
  const it = value as Partial<ArrayReference> | null;
  return (
    typeof it?.type === "string" &&
    it.type in ARRAY_TYPES &&
    Number.isInteger(it.at) &&
    Number.isInteger(it.count)
  );
}

/** Replaces every description of an array in `value` by a view of the array. */
function resolveArrays(value: unknown, bytes: ArrayBuffer, start: number): unknown {
  if (isArrayReference(value)) {
    const array = ARRAY_TYPES[value.type];
    const { at, count } = value;
    if (at < 0 || count < 0 || start + at + count * array.BYTES_PER_ELEMENT > bytes.byteLength) {
      throw incomplete("an array extends beyond the end of the data");
    }
    return new array(bytes, start + at, count);
  }
  if (Array.isArray(value)) {
    return typeof value[0] === "object" ? value.map((item) => resolveArrays(item, bytes, start)) : value;
  }
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([k, v]) => [k, resolveArrays(v, bytes, start)]));
  }
  return value;
}

function incomplete(detail: string): SceneError {
  return new SceneError(`The data of this page are incomplete: ${detail}. Create the page again.`);
}

/** Decodes a container. Throws a `SceneError` if it is damaged. */
export function decodeScene(bytes: ArrayBuffer): Scene {
  const view = new DataView(bytes);
  if (bytes.byteLength < HEADER_START || view.getUint32(0, false) !== MAGIC) {
    throw new SceneError("The data of this page are not a scene of ancf. Create the page again.");
  }
  const version = view.getUint32(4, true);
  if (version !== VERSION) {
    throw new SceneError(
      `The data of this page have version ${version}, expected ${VERSION}. Create the page again.`,
    );
  }
  const length = view.getUint32(8, true);
  const start = HEADER_START + Math.ceil(length / 8) * 8;
  if (HEADER_START + length > bytes.byteLength) throw incomplete("they end within the header");
  let header: unknown;
  try {
    header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, HEADER_START, length)));
  } catch {
    throw damaged("the header is not valid JSON");
  }
  return withDefaults(resolveArrays(header, bytes, start) as Partial<Scene>);
}

/** Adds defaults for missing keys and checks the arrays. */
function withDefaults(header: Partial<Scene>): Scene {
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
    ...{ supports: [], loads: [] },
    ...{ obstacles: [], charts: [], abscissa: { name: "t", unit: "", values: none } },
    bounds: [
      [0, 0, 0],
      [1, 1, 1],
    ],
    ...header,
  };
  checkArrays(scene);
  const [low, high] = scene.bounds;
  const diagonal = Math.hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (!(scene.size > 0)) scene.size = diagonal > 0 ? diagonal : 1;
  return scene;
}
