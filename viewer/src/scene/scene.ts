// Scene: the drawable results of a run. The types mirror the header of the container (crate ancf-report).

export type Numbers = Float32Array | Float64Array | Int16Array | Uint16Array | Uint32Array;
export type Vector = [number, number, number];

/** Grid of the stations of a shell, along u first. A mesh of quadrilaterals has a grid for each element, one after another. */
export interface Grid {
  /** Number of grids: 1 for a patch, the number of elements for a mesh. */
  patches: number;
  /** Numbers of stations along u and v. */
  counts: [number, number];
  /** Cells per element in each direction. */
  parts: number;
  /** Half of the thickness. */
  half: number;
}

export interface Body {
  name: string;
  kind: "beam" | "cable" | "shell" | "rigid" | "point";
  /** The stations of the body are first .. first + count of the scene. */
  first: number;
  count: number;
  outline: number[][];
  inner: number[][] | null;
  /** Factors of y and z of the outline at each station of a tapered body. */
  scale: Numbers | null;
  /** Factor of the bore at each station of a tapered tube. */
  bore?: Numbers | null;
  grid?: Grid | null;
  nodes: number[];
  box: Vector | null;
  /** Triangles of a rigid body, in components along its directors from its centre. Normals are times 32767. */
  surface?: { points: Numbers; normals: Numbers; corners: Numbers } | null;
}

export interface Field {
  name: string;
  symbol: string;
  unit: string;
  diverging: boolean;
  range: [number, number];
  /** Range of all data of a live run that the page has received. */
  widest?: [number, number];
  /** Scaled values [F][P]: (value - min) / (max - min) * 65534. The code 65535 stands for no value. */
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

/** Joint along an edge of a shell. */
export interface Support {
  marker: number | null;
  /** Stations along the edge. */
  stations: number[];
}

/** Load on an edge or on the surface of a shell. */
export interface ShellLoad {
  kind: string;
  moment: boolean;
  /** Stations of the arrows. */
  stations: number[];
  /** Vectors at the stations, [F][stations][3]. */
  vectors: Numbers;
}

export interface Link {
  name: string;
  /** An arm connects the centre of a rigid body to a joint. */
  kind: "spring" | "damper" | "rope" | "rod" | "bushing" | "arm";
  ends: Numbers;
  reference?: [Vector, Vector] | null;
}

export interface Obstacle {
  name: string;
  kind: "plane" | "sphere" | "cylinder";
  radius: number;
  length: number | null;
  /** True if bodies touch the obstacle from the inside. */
  inside?: boolean;
  pose: Numbers;
}

export interface Column {
  name: string;
  label: string;
  unit: string;
  values: Numbers;
  /** Estimated errors of the values. */
  errors?: Numbers;
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
  /** `imaginary` has the index of the frame with the imaginary part of a complex shape. These frames follow after `count`. */
  frames: {
    count: number;
    values: Numbers;
    labels: string[] | null;
    imaginary?: (number | null)[] | null;
  };
  stations: number;
  bodies: Body[];
  centres: Numbers;
  directors: Numbers;
  reference: { centres: Numbers; directors: Numbers };
  fields: Field[];
  markers: Marker[];
  reactions: Reaction[];
  supports: Support[];
  loads: ShellLoad[];
  links: Link[];
  obstacles: Obstacle[];
  charts: Chart[];
  abscissa: { name: string; unit: string; values: Numbers };
}

/** Reading error of a scene, with a message for the reader of the page. */
export class SceneError extends Error {}

/** True if the frames are shapes of vibration or buckling, which are shown one at a time. */
export function isModal(scene: Scene): boolean {
  return scene.analysis === "modes" || scene.analysis === "buckling";
}

/** Number of frames in the arrays: those that are shown, and the imaginary parts of complex shapes. */
export function storedFrames(scene: Scene): number {
  const { count, imaginary } = scene.frames;
  return count + (imaginary ?? []).filter((index) => index !== null).length;
}

/** True if the run ended with an error before its last step. */
export function hasFailed(scene: Scene): boolean {
  return scene.outcome.kind === "failed" && !isModal(scene);
}
