// Web worker with the solver: checks and runs models. Its page stops a run by ending the worker.

import type { Handle, Problem, Reply, Request } from "./messages";

/** Module of the solver, as wasm-bindgen writes it. */
interface SolverModule {
  default(options: { module_or_path: string }): Promise<unknown>;
  check(text: string): string;
  handle_list(text: string): string;
  moved_text(text: string, number: number, x: number, y: number, z: number): string;
  run(text: string, title: string, update: (scene: Uint8Array<ArrayBuffer>) => void): RunResult;
}

interface RunResult {
  scene(): Uint8Array<ArrayBuffer>;
  csv(): string;
  sentence(): string;
  is_finished(): boolean;
  free(): void;
}

function reply(message: Reply, transfer: Transferable[] = []): void {
  (self as unknown as Worker).postMessage(message, transfer);
}

async function load(): Promise<SolverModule> {
  const address = new URL("ancf_web.js", self.location.href).href;
  const solver = (await import(address)) as SolverModule;
  await solver.default({ module_or_path: new URL("ancf_web_bg.wasm", self.location.href).href });
  return solver;
}

const solver = load();

function run(module: SolverModule, text: string, title: string): void {
  const result = module.run(text, title, (scene) => reply({ kind: "update", scene }, [scene.buffer]));
  const scene = result.scene();
  const [csv, sentence, finished] = [result.csv(), result.sentence(), result.is_finished()];
  result.free();
  reply({ kind: "done", scene, csv, sentence, finished }, [scene.buffer]);
}

function answer(module: SolverModule, request: Request): void {
  const { text } = request;
  if (request.kind === "run") {
    run(module, text, request.title);
  } else if (request.kind === "handles") {
    reply({ kind: "handles", handles: JSON.parse(module.handle_list(text)) as Handle[] });
  } else if (request.kind === "move") {
    reply({ kind: "moved", text: module.moved_text(text, request.number, ...request.to) });
  } else {
    reply({ kind: "checked", problems: JSON.parse(module.check(text)) as Problem[] });
  }
}

self.addEventListener("message", async (event: MessageEvent<Request>) => {
  const request = event.data;
  try {
    const module = await solver;
    answer(module, request);
  } catch (error) {
    reply({ kind: "failed", message: error instanceof Error ? error.message : String(error) });
  }
});

solver.then(
  () => reply({ kind: "ready" }),
  (error) => reply({ kind: "failed", message: `The solver cannot be loaded: ${String(error)}` }),
);
