// Handles over the 3-D view: points of the model that one drags, in the plane of the screen.

import { h } from "../base/dom";
import { formatQuantity } from "../base/units";
import type { Viewport } from "../draw/viewport";
import type { Scene, Vector } from "../scene/scene";

/** Point of a model that one drags: a joint, or the end of a force vector. */
export interface Handle {
  name: string;
  /** Position in the reference state. */
  position: Vector;
  /** Force of a load; null for joints. */
  force: Vector | null;
}

/** Receiver of the new position of a joint, or of a new force. */
export type HandleListener = (number: number, to: Vector) => void;

/** Length of the arrow of the largest force, relative to the size of the scene. */
const ARROW = 0.25;
/** Movement by an arrow key in pixels. */
const KEY_STEP = 10;
/** Time after the last arrow key at which the movement ends, in ms. */
const KEY_PAUSE = 600;
const KEYS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

const SVG = "http://www.w3.org/2000/svg";

/** Handle with its elements and its dragged point. */
interface Grip {
  handle: Handle;
  button: HTMLButtonElement;
  line: SVGLineElement;
  /** Current point: of a joint its position, of a force the end of its arrow. */
  point: Vector;
}

export class Handles {
  readonly element = h("div", { class: "handles" });
  private readonly lines = document.createElementNS(SVG, "svg");
  private readonly note = h("div", { class: "handle-note", role: "status", hidden: true });
  private grips: Grip[] = [];
  /** Size of a unit of force in the scene. */
  private arrow = 0;
  private units: Scene["units"] = null;
  private timer = 0;

  constructor(
    private readonly viewport: Viewport,
    private readonly changed: () => void,
  ) {
    this.lines.setAttribute("aria-hidden", "true");
    this.element.append(this.lines, this.note);
  }

  /** Shows the handles of a model; `moved` is called when one is released. */
  show(handles: Handle[], scene: Scene, moved: HandleListener): void {
    const largest = Math.max(...handles.map(({ force }) => Math.hypot(...(force ?? [0]))), 0);
    this.arrow = largest > 0 ? (ARROW * scene.size) / largest : ARROW * scene.size;
    this.units = scene.units;
    const focused = this.grips.findIndex(({ button }) => button === document.activeElement);
    for (const { button, line } of this.grips) {
      button.remove();
      line.remove();
    }
    this.grips = handles.map((handle, number) => this.grip(handle, (to) => moved(number, to)));
    this.grips[focused]?.button.focus();
    this.note.hidden = true;
    this.changed();
  }

  /** Moves the elements to the projections of their points. */
  draw(): void {
    for (const { handle, button, line, point } of this.grips) {
      const [at, start] = [this.viewport.project(point), this.viewport.project(handle.position)];
      button.hidden = !at;
      line.toggleAttribute("hidden", !at || !start);
      if (!at || !start) continue;
      button.style.transform = `translate(${at[0].toFixed(1)}px, ${at[1].toFixed(1)}px)`;
      const ends = { x1: start[0], y1: start[1], x2: at[0], y2: at[1] };
      for (const [name, value] of Object.entries(ends)) line.setAttribute(name, value.toFixed(1));
    }
  }

  private grip(handle: Handle, moved: (to: Vector) => void): Grip {
    const { position, force } = handle;
    const what = force ? `force on ${handle.name}` : `joint ${handle.name}`;
    const title = `Drag the ${what}, or move it by the arrow keys`;
    const button = h("button", {
      ...{ type: "button", title, "aria-label": title, class: force ? "handle force" : "handle joint" },
    });
    const line = document.createElementNS(SVG, "line");
    const point: Vector = force ? add(position, force, this.arrow) : [...position];
    const grip: Grip = { handle, button, line, point };
    this.listen(grip, moved);
    this.element.append(button);
    this.lines.append(line);
    return grip;
  }

  private listen(grip: Grip, moved: (to: Vector) => void): void {
    const { button } = grip;
    let last: [number, number] | null = null;
    button.addEventListener("pointerdown", (event) => {
      last = [event.clientX, event.clientY];
      button.setPointerCapture(event.pointerId);
    });
    button.addEventListener("pointermove", (event) => {
      if (!last) return;
      this.move(grip, event.clientX - last[0], event.clientY - last[1]);
      last = [event.clientX, event.clientY];
    });
    const end = () => {
      if (last) this.release(grip, moved);
      last = null;
    };
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
    button.addEventListener("keydown", (event) => {
      const step = KEYS[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      this.move(grip, KEY_STEP * step[0], KEY_STEP * step[1]);
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.release(grip, moved), KEY_PAUSE);
    });
  }

  /** Moves a point by a distance on the screen, in pixels. */
  private move(grip: Grip, x: number, y: number): void {
    const [right, up] = this.viewport.camera.screenAxes;
    const scale = 1 / this.viewport.pixelsPerUnit(grip.point);
    grip.point = add(add(grip.point, right, x * scale), up, -y * scale);
    const value = this.value(grip);
    const unit = (grip.handle.force ? this.units?.force : this.units?.length) ?? "";
    this.note.hidden = false;
    this.note.textContent = `${grip.handle.name}: (${value.map((v) => formatQuantity(v, "")).join(", ")}) ${unit}`;
    this.changed();
  }

  private release(grip: Grip, moved: (to: Vector) => void): void {
    const before = grip.handle.force ?? grip.handle.position;
    const value = this.value(grip);
    if (value.some((v, k) => v !== before[k])) moved(value);
  }

  /** Position or force of a handle. */
  private value({ handle, point }: Grip): Vector {
    if (!handle.force) return point;
    return point.map((v, k) => (v - handle.position[k]) / this.arrow) as Vector;
  }
}

function add(a: ArrayLike<number>, b: ArrayLike<number>, factor: number): Vector {
  return [a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]];
}
