// Export of the 3-D view as an image and of the animation as a video.

import { cssColour, mapColour } from "../base/colours";
import { saveFile } from "../base/dom";
import { formatNumber } from "../base/numbers";
import { colourScale, legendValues } from "../scene/fields";
import type { App } from "./app";

/** Height of the colour bar of an image in CSS pixels. */
const BAR_HEIGHT = 140;
/** Duration of the video of a shape at speed one, in ms: two oscillations. */
const SHAPE_DURATION = 4000;
/** Upper limit on the duration of a video, in ms. */
const MAX_DURATION = 120_000;

function fileStem(app: App): string {
  return app.scene.title.replace(/[^\w-]+/g, "_") || "ancf";
}

export function saveImage(app: App): void {
  if (!app.viewport) return;
  app.viewport.draw(app.blend);
  const image = composeImage(app);
  image.toBlob((blob) => blob && saveFile(`${fileStem(app)}.png`, blob));
}

/** Draws the 3-D view with its background, title, caption and legend. */
function composeImage(app: App): HTMLCanvasElement {
  const { canvas } = app.layout;
  const image = document.createElement("canvas");
  [image.width, image.height] = [canvas.width, canvas.height];
  const context = image.getContext("2d");
  if (!context) return canvas;
  const style = getComputedStyle(document.documentElement);
  const pixelRatio = image.width / Math.max(1, canvas.clientWidth);
  context.fillStyle = style.getPropertyValue("--stage").trim();
  context.fillRect(0, 0, image.width, image.height);
  context.drawImage(canvas, 0, 0);
  context.scale(pixelRatio, pixelRatio);
  context.fillStyle = style.getPropertyValue("--ink").trim();
  context.font = "600 14px system-ui, sans-serif";
  context.fillText(app.scene.title, 16, 28);
  context.font = "13px system-ui, sans-serif";
  context.fillText(app.caption, 16, 48);
  drawLegend(app, context, canvas.clientWidth - 100);
  return image;
}

function drawLegend(app: App, context: CanvasRenderingContext2D, left: number): void {
  const field = app.scene.fields.find((f) => f.name === app.settings.values.field);
  if (!field) return;
  const ink = context.fillStyle;
  const scale = colourScale(field, app.settings.values);
  context.fillText(`${field.name} ${scale.unit.name}`.trim(), left - 40, 28, 130);
  for (let i = 0; i < BAR_HEIGHT; i++) {
    context.fillStyle = cssColour(mapColour(scale.map, 1 - i / (BAR_HEIGHT - 1)));
    context.fillRect(left, 40 + i, 14, 1.5);
  }
  context.fillStyle = ink;
  const values = legendValues(app.scene, field, scale);
  for (const i of [0, 2, 4]) {
    context.fillText(formatNumber(values[i], 3), left + 22, 45 + ((BAR_HEIGHT - 2) * i) / 4);
  }
}

/** True if the browser can record a canvas. */
export function canRecord(): boolean {
  return (
    typeof MediaRecorder !== "undefined" && typeof HTMLCanvasElement.prototype.captureStream === "function"
  );
}

/** Recording of a canvas until `stop` is called. */
class CanvasRecording {
  private readonly recorder: MediaRecorder;
  private readonly parts: Blob[] = [];

  constructor(canvas: HTMLCanvasElement) {
    const types = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];
    const mimeType = types.find((type) => MediaRecorder.isTypeSupported(type)) ?? "";
    this.recorder = new MediaRecorder(canvas.captureStream(30), { mimeType, videoBitsPerSecond: 8e6 });
    this.recorder.addEventListener("dataavailable", (event) => this.parts.push(event.data));
    this.recorder.start(500);
  }

  stop(): Promise<Blob> {
    return new Promise((resolve) => {
      this.recorder.addEventListener("stop", () =>
        resolve(new Blob(this.parts, { type: this.recorder.mimeType })),
      );
      this.recorder.stop();
    });
  }
}

/** Plays the animation from the start to the end, or two oscillations of a shape, and saves the recording. */
export function saveVideo(app: App, button: HTMLButtonElement): void {
  const { player } = app;
  const recording = new CanvasRecording(app.layout.canvas);
  const { repeat } = player;
  player.repeat = false;
  button.setAttribute("aria-pressed", "true");
  button.disabled = true;
  player.playing = false;
  if (player.end > 0 && player.timed) player.goTo(0);
  player.toggle();
  const start = performance.now();
  const timer = setInterval(async () => {
    const elapsed = performance.now() - start;
    const complete = !player.playing || (!player.timed && elapsed > SHAPE_DURATION / player.speed);
    if (!complete && elapsed < MAX_DURATION) return;
    clearInterval(timer);
    if (player.playing) player.toggle();
    player.repeat = repeat;
    const blob = await recording.stop();
    saveFile(`${fileStem(app)}.${blob.type.includes("mp4") ? "mp4" : "webm"}`, blob);
    button.disabled = false;
    button.setAttribute("aria-pressed", "false");
  }, 100);
}
