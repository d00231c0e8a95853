// The picture as a file, the whole film as a file.

import { colour, css } from "../base/colours";
import { text } from "../base/dom";
import { ticks } from "../overlay/legend";
import type { Scene } from "../scene/scene";

/** Draws the picture with its background, title and legend. */
export function compose(
  canvas: HTMLCanvasElement,
  scene: Scene,
  caption: string,
  field: string,
): HTMLCanvasElement {
  const page = document.createElement("canvas");
  [page.width, page.height] = [canvas.width, canvas.height];
  const pen = page.getContext("2d");
  if (!pen) return canvas;
  const style = getComputedStyle(document.documentElement);
  const unit = page.width / Math.max(1, canvas.clientWidth);
  pen.fillStyle = style.getPropertyValue("--stage").trim();
  pen.fillRect(0, 0, page.width, page.height);
  pen.drawImage(canvas, 0, 0);
  pen.scale(unit, unit);
  pen.fillStyle = style.getPropertyValue("--ink").trim();
  pen.font = "600 14px system-ui, sans-serif";
  pen.fillText(scene.title, 16, 28);
  pen.font = "13px system-ui, sans-serif";
  pen.fillText(caption, 16, 48);
  const shown = scene.fields.find((f) => f.name === field);
  if (shown) {
    const values = ticks(scene, shown);
    const left = canvas.clientWidth - 100;
    pen.fillText(`${shown.name} ${shown.unit}`.trim(), left - 40, 28, 130);
    for (let i = 0; i < 140; i++) {
      pen.fillStyle = css(colour(shown.diverging, 1 - i / 139));
      pen.fillRect(left, 40 + i, 14, 1.5);
    }
    pen.fillStyle = style.getPropertyValue("--ink").trim();
    for (const i of [0, 2, 4]) pen.fillText(text(values[i], 3), left + 22, 45 + (138 * i) / 4);
  }
  return page;
}

export function filmable(): boolean {
  return (
    typeof MediaRecorder !== "undefined" && typeof HTMLCanvasElement.prototype.captureStream === "function"
  );
}

/** Records a canvas until `stop` is called. */
export class Film {
  private readonly recorder: MediaRecorder;
  private readonly parts: Blob[] = [];

  constructor(canvas: HTMLCanvasElement) {
    const kinds = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
    const mimeType = kinds.find((k) => MediaRecorder.isTypeSupported(k)) ?? "";
    this.recorder = new MediaRecorder(canvas.captureStream(30), { mimeType, videoBitsPerSecond: 8e6 });
    this.recorder.addEventListener("dataavailable", (event) => this.parts.push(event.data));
    this.recorder.start(500);
  }

  stop(): Promise<Blob> {
    return new Promise((done) => {
      this.recorder.addEventListener("stop", () =>
        done(new Blob(this.parts, { type: this.recorder.mimeType })),
      );
      this.recorder.stop();
    });
  }
}
