// Playground: edits a model, runs it in the browser, and shows it in the viewer.

import "./playground.css";
import { Theme } from "../base/theme";
import { ModelEditor } from "./editor";
import { exampleOf, fragmentOf, modelOf } from "./link";
import type { Problem, RunOutcome } from "./messages";
import type { Schema } from "./schema";
import { RunStopped, Solver } from "./solver";
import { Stage } from "./stage";

/** Model of the repository. */
interface Example {
  name: string;
  title: string;
  text: string;
}

/** Pause of typing before the text is checked, in ms. */
const PAUSE = 300;

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`no element #${id}`);
  return found as T;
}

async function json<T>(address: string): Promise<T> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: status ${response.status}`);
  return (await response.json()) as T;
}

class Playground {
  private readonly solver = new Solver();
  private readonly stage = new Stage(element("stage"), (number, to) => void this.move(number, to));
  private readonly editor: ModelEditor;
  private readonly runButton = element<HTMLButtonElement>("run");
  private readonly stopButton = element<HTMLButtonElement>("stop");
  private readonly dragButton = element<HTMLButtonElement>("drag");
  private readonly table = element<HTMLAnchorElement>("table");
  private readonly list = element<HTMLSelectElement>("example");
  /** Table of the last complete run. */
  csv = "";
  private timer = 0;
  private checks = 0;

  constructor(
    schema: Schema,
    private readonly examples: Example[],
  ) {
    this.editor = new ModelEditor(
      element("editor"),
      schema,
      () => this.changed(),
      () => void this.run(),
    );
    for (const { name, title } of examples) this.list.add(new Option(title, name));
    this.list.addEventListener("change", () => this.openExample(this.list.value));
    this.runButton.addEventListener("click", () => void this.run());
    this.stopButton.addEventListener("click", () => this.solver.stop());
    this.dragButton.addEventListener("click", () => {
      this.dragButton.setAttribute("aria-pressed", String(!this.isDragging));
      void this.showHandles();
    });
    element("share").addEventListener("click", () => void this.share());
    element("save").addEventListener("click", () => this.save());
    window.addEventListener("hashchange", () => void this.openLink());
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.solver.stop();
    });
    this.solver.ready.catch((error: Error) => this.say(error.message, "error"));
  }

  /** Text of the model. */
  get text(): string {
    return this.editor.text;
  }

  set text(text: string) {
    this.editor.text = text;
  }

  /** Opens the model of the address, or the first example. */
  async openLink(): Promise<void> {
    const { hash } = window.location;
    try {
      const text = await modelOf(hash);
      if (text !== null) this.open(text, "");
      else this.openExample(exampleOf(hash) ?? this.examples[0].name);
    } catch {
      this.openExample(this.examples[0].name);
      this.say("The link holds no readable model.", "error");
    }
  }

  private openExample(name: string): void {
    const example = this.examples.find((one) => one.name === name);
    if (example) this.open(example.text, name);
    else this.say(`There is no example “${name}”.`, "error");
  }

  private open(text: string, example: string): void {
    this.list.value = example;
    this.editor.text = text;
    void this.run();
  }

  private changed(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.check(), PAUSE);
  }

  /** Marks the problems of the text. Returns true if it has no errors. */
  private async check(): Promise<boolean> {
    clearTimeout(this.timer);
    this.checks += 1;
    const number = this.checks;
    const problems = await this.solver.check(this.editor.text);
    const hasErrors = problems.some((problem) => problem.severity === "error");
    if (number === this.checks) {
      this.editor.mark(problems);
      this.showProblems(problems);
    }
    return !hasErrors;
  }

  private showProblems(problems: Problem[]): void {
    const items = problems.map((problem) => {
      const item = document.createElement("li");
      const button = document.createElement("button");
      const place = problem.length > 0 ? `line ${problem.line}: ` : "";
      button.textContent = `${place}${problem.message}`;
      button.className = problem.severity;
      button.addEventListener("click", () => this.editor.goTo(problem));
      item.append(button);
      return item;
    });
    element("problems").replaceChildren(...items);
  }

  private get isDragging(): boolean {
    return this.dragButton.getAttribute("aria-pressed") === "true";
  }

  /** Shows the points that one drags, if they are on. */
  private async showHandles(): Promise<void> {
    await this.stage.showHandles(this.isDragging ? await this.solver.handles(this.editor.text) : []);
  }

  /** Moves a point of the model, and runs it in the same view. */
  private async move(number: number, to: [number, number, number]): Promise<void> {
    this.editor.text = await this.solver.moved(this.editor.text, number, to);
    await this.run(true);
  }

  /** Runs the model, in the open viewer if the view is kept. */
  private async run(keepsView = false): Promise<void> {
    this.solver.stop();
    const text = this.editor.text;
    this.say("running …");
    try {
      if (!(await this.check())) {
        this.say("The model has errors.", "error");
        return;
      }
      this.setRunning(true);
      if (!keepsView || !this.stage.isOpen) this.stage.open();
      const title = this.list.selectedOptions[0]?.text ?? "model";
      const outcome = await this.solver.run(text, title, { update: (scene) => void this.stage.show(scene) });
      this.show(outcome);
      await this.showHandles();
    } catch (error) {
      if (error instanceof RunStopped) this.say("stopped");
      else this.say(error instanceof Error ? error.message : String(error), "error");
    } finally {
      this.setRunning(false);
    }
  }

  private show(outcome: RunOutcome): void {
    void this.stage.show(outcome.scene);
    URL.revokeObjectURL(this.table.href);
    this.csv = outcome.csv;
    this.table.href = URL.createObjectURL(new Blob([outcome.csv], { type: "text/csv" }));
    this.table.hidden = false;
    this.say(outcome.sentence, outcome.finished ? "" : "error");
  }

  private setRunning(running: boolean): void {
    this.stopButton.disabled = !running;
    document.body.classList.toggle("running", running);
  }

  /** Writes the model into the address and copies the link. */
  private async share(): Promise<void> {
    const address = new URL(window.location.href);
    address.hash = await fragmentOf(this.editor.text);
    window.history.replaceState(null, "", address);
    try {
      await navigator.clipboard.writeText(address.href);
      this.say("The link to this model is copied.");
    } catch {
      this.say("The address of this page is now the link to this model.");
    }
  }

  private save(): void {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([this.editor.text], { type: "application/toml" }));
    link.download = `${this.list.value || "model"}.toml`;
    link.click();
    URL.revokeObjectURL(link.href);
  }

  private say(text: string, className = ""): void {
    const status = element("status");
    status.textContent = text;
    status.className = className;
  }
}

async function start(): Promise<void> {
  const theme = new Theme(() => undefined);
  // The button for the theme is in the viewer.
  window.addEventListener("storage", () => theme.follow());
  try {
    const [schema, examples] = await Promise.all([
      json<Schema>("model.schema.json"),
      json<Example[]>("examples.json"),
    ]);
    const playground = new Playground(schema, examples);
    Object.assign(window, { playground });
    await playground.openLink();
  } catch (error) {
    element("status").textContent = `The playground cannot be loaded: ${String(error)}`;
  }
  if ("serviceWorker" in navigator && window.isSecureContext) {
    // Without it, the page needs the network.
    await navigator.serviceWorker.register("offline.js").catch(() => undefined);
  }
}

void start();
