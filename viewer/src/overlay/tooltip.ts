// Tooltip with the station under the pointer.

import { h } from "../base/dom";
import type { Settings } from "../base/settings";
import type { Viewport } from "../draw/viewport";
import type { FrameBlend } from "../scene/blend";
import type { Scene } from "../scene/scene";
import { describeStation, pickStation } from "./picking";

export class Tooltip {
  readonly element = h("div", { class: "tooltip", hidden: true });
  /** Position of the pointer on the canvas; null while a button is pressed or the pointer is elsewhere. */
  private pointer: [number, number] | null = null;

  /** Follows the pointer on a canvas, and calls `changed` when it moves. */
  constructor(canvas: HTMLCanvasElement, changed: () => void) {
    const track = (event: PointerEvent) => {
      const box = canvas.getBoundingClientRect();
      this.pointer = event.buttons > 0 ? null : [event.clientX - box.left, event.clientY - box.top];
      changed();
    };
    canvas.addEventListener("pointermove", track);
    canvas.addEventListener("pointerup", track);
    canvas.addEventListener("pointerleave", (event) => {
      if (event.pointerType === "touch") return;
      this.pointer = null;
      changed();
    });
  }

  /** Picks the station under the pointer and describes it. */
  update(viewport: Viewport, scene: Scene, settings: Settings, blend: FrameBlend): void {
    const { pointer } = this;
    const picked = pointer && pickStation(viewport, scene, settings, blend, pointer);
    if (pointer && picked)
      this.show(describeStation(scene, settings, blend, picked), pointer, viewport.width);
    else this.hide();
  }

  hide(): void {
    this.element.hidden = true;
  }

  private show(lines: string[], [x, y]: [number, number], canvasWidth: number): void {
    this.element.hidden = false;
    this.element.replaceChildren(h("strong", {}, lines[0]), ...lines.slice(1).map((l) => h("div", {}, l)));
    const width = this.element.offsetWidth;
    const left = x + 16 + width > canvasWidth ? x - 12 - width : x + 16;
    this.element.style.transform = `translate(${Math.max(4, left)}px, ${y + 12}px)`;
  }
}
