// Interface `window.ancf` for tests and for the console.

import { stationPosition } from "../scene/blend";
import type { Vector } from "../scene/scene";
import type { Rectangle } from "../view/camera";
import type { App } from "./app";

export interface Api {
  /** Resolves when the first scene is shown (true) or cannot be read (false). */
  ready: Promise<boolean>;
  /** Moves to a time; for statics and paths a load factor, for modes the number of the shape. */
  setTime(time: number): void;
  /** Time of the current frame. */
  readonly time: number;
  /** Current fractional frame. */
  readonly frame: number;
  readonly playing: boolean;
  /** Number of stations of each body. */
  stations(): number[];
  /** Unit vector from the model towards the camera. */
  readonly direction: Vector;
  /** Drawn position of a station of a body, with scaled displacements. */
  station(body: number, index: number): Vector;
  /** Position of a station on the canvas in CSS pixels; null if it is not visible. */
  canvasPosition(body: number, index: number): [number, number] | null;
  /** Position of a point on the canvas in CSS pixels; null if it is not visible. */
  project(x: number, y: number, z: number): [number, number] | null;
  /** Share of the canvas (0 to 1) that objects other than grid and shadows cover. */
  coverage(): number;
  /** Red, green, blue and opacity (0 to 255) of the 3-D view at points in CSS pixels. */
  pixels(points: ReadonlyArray<readonly [number, number]>): number[][];
  /** Free area of the view, and the box around the projected motion and arrows of all frames, in CSS pixels. */
  framing(): { free: Rectangle; motion: Rectangle; arrows: Rectangle | null } | null;
}

export function createApi(app: App, ready: Promise<boolean>): Api {
  const station = (body: number, index: number) =>
    stationPosition(app.scene, app.scene.bodies[body].first + index, app.blend);
  return {
    ready,
    setTime: (time) => app.player.seek(time),
    get time() {
      return app.player.time;
    },
    get frame() {
      return app.player.position;
    },
    get playing() {
      return app.player.playing;
    },
    stations: () => app.scene.bodies.map((body) => body.count),
    get direction() {
      return app.viewport?.camera.direction ?? [0, 0, 1];
    },
    station,
    canvasPosition: (body, index) => app.viewport?.project(station(body, index)) ?? null,
    project: (x, y, z) => app.viewport?.project([x, y, z]) ?? null,
    coverage: () => app.viewport?.coverage(app.blend) ?? 0,
    pixels: (points) => app.viewport?.pixels(points, app.blend) ?? points.map(() => [0, 0, 0, 0]),
    framing: () => app.viewport?.framing() ?? null,
  };
}
