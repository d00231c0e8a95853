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

export type Request = { kind: "check"; text: string } | { kind: "run"; text: string; title: string };

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
  | { kind: "update"; scene: Uint8Array<ArrayBuffer> }
  | ({ kind: "done" } & RunOutcome)
  | { kind: "failed"; message: string };
