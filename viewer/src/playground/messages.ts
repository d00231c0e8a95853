// Messages between the page and the worker.

/** Error or warning of a model text. */
export interface Problem {
  severity: "error" | "warning";
  /** Line and column in characters, from 1. */
  line: number;
  column: number;
  /** Number of characters of the wrong text; 0 if the place is unknown. */
  length: number;
  message: string;
}

/** Point of a model that one drags. */
export interface Handle {
  name: string;
  position: [number, number, number];
  /** Force of a load; null for joints. */
  force: [number, number, number] | null;
}

export type Request =
  | { kind: "check"; text: string }
  | { kind: "handles"; text: string }
  | { kind: "move"; text: string; number: number; to: [number, number, number] }
  | { kind: "run"; text: string; title: string };

/** Results of a complete run. */
export interface RunOutcome {
  scene: Uint8Array<ArrayBuffer>;
  csv: string;
  sentence: string;
  finished: boolean;
}

export type Reply =
  | { kind: "ready" }
  | { kind: "checked"; problems: Problem[] }
  | { kind: "handles"; handles: Handle[] }
  | { kind: "moved"; text: string }
  | { kind: "update"; scene: Uint8Array<ArrayBuffer> }
  | ({ kind: "done" } & RunOutcome)
  | { kind: "failed"; message: string };
