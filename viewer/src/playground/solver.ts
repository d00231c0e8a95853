// Client of the two workers: one checks the text while it is edited, the other one runs models.

import type { Handle, Problem, Reply, Request, RunOutcome } from "./messages";

/** Receiver of the results of a run. */
export interface RunListener {
  update(scene: Uint8Array<ArrayBuffer>): void;
}

export class RunStopped extends Error {}

class SolverWorker {
  private readonly worker = new Worker(new URL("worker.js", document.baseURI));
  /** Resolves when the solver is loaded. */
  readonly ready: Promise<void>;
  private listener: ((reply: Reply) => void) | null = null;

  constructor() {
    this.ready = new Promise((resolve, reject) => {
      this.worker.addEventListener("message", (event: MessageEvent<Reply>) => {
        const reply = event.data;
        if (reply.kind === "ready") resolve();
        else if (this.listener) this.listener(reply);
        else if (reply.kind === "failed") reject(new Error(reply.message));
      });
      this.worker.addEventListener("error", (event) => reject(new Error(event.message)));
    });
    // A failure is reported by the next request.
    this.ready.catch(() => undefined);
  }

  /** Sends a request; `take` returns true for the last reply. */
  async request(message: Request, take: (reply: Reply) => boolean): Promise<void> {
    await this.ready;
    await new Promise<void>((resolve, reject) => {
      this.listener = (reply) => {
        if (reply.kind === "failed") reject(new Error(reply.message));
        else if (take(reply)) resolve();
      };
      this.worker.postMessage(message);
    });
  }

  end(): void {
    this.worker.terminate();
  }
}

export class Solver {
  private readonly checker = new SolverWorker();
  private runner = new SolverWorker();
  private stopRun: ((reason: Error) => void) | null = null;
  private checking: Promise<unknown> = Promise.resolve();

  /** Resolves when the solver is loaded. */
  get ready(): Promise<void> {
    return this.checker.ready;
  }

  /** Returns the errors and warnings of a text. */
  async check(text: string): Promise<Problem[]> {
    const reply = await this.ask({ kind: "check", text });
    return reply.kind === "checked" ? reply.problems : [];
  }

  /** Returns the points of a text that one drags. */
  async handles(text: string): Promise<Handle[]> {
    const reply = await this.ask({ kind: "handles", text });
    return reply.kind === "handles" ? reply.handles : [];
  }

  /** Returns a text in which a point that one drags has moved. */
  async moved(text: string, number: number, to: [number, number, number]): Promise<string> {
    const reply = await this.ask({ kind: "move", text, number, to });
    return reply.kind === "moved" ? reply.text : text;
  }

  /** Sends a request with one reply to the checker, after those before it. */
  private ask(request: Request): Promise<Reply> {
    const one = async () => {
      let answer: Reply = { kind: "ready" };
      await this.checker.request(request, (reply) => {
        answer = reply;
        return true;
      });
      return answer;
    };
    const found = this.checking.then(one, one);
    this.checking = found;
    return found;
  }

  /** Runs a model. Rejects with `RunStopped` after `stop`. */
  async run(text: string, title: string, listener: RunListener): Promise<RunOutcome> {
    let outcome: RunOutcome | null = null;
    const run = this.runner.request({ kind: "run", text, title }, (reply) => {
      if (reply.kind === "update") listener.update(reply.scene);
      if (reply.kind === "done") outcome = reply;
      return reply.kind === "done";
    });
    const stopped = new Promise<never>((_, reject) => {
      this.stopRun = reject;
    });
    try {
      await Promise.race([run, stopped]);
    } finally {
      this.stopRun = null;
    }
    if (!outcome) throw new Error("the run has no outcome");
    return outcome;
  }

  /** Stops the run, if any. */
  stop(): void {
    if (!this.stopRun) return;
    this.runner.end();
    this.runner = new SolverWorker();
    this.stopRun(new RunStopped());
  }
}
