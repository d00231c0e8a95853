// `window.ancf`: a few handles for tests and for the console.

import { station } from "../scene/blend";
import type { Vector } from "../scene/scene";
import type { App } from "./app";

export interface Api {
  /** Fulfilled when the first scene is shown (true), or when it cannot be read (false). */
  ready: Promise<boolean>;
  /** Goes to a time (statics and paths: load factor; modes: number of the shape as in the frames). */
  setTime(time: number): void;
  /** The time that is shown. */
  readonly time: number;
  /** The frame that is shown, with a fraction between two frames. */
  readonly frame: number;
  readonly playing: boolean;
  /** Position, as drawn (deformation scale and swing of a mode included), of a station of a body. */
  station(body: number, index: number): Vector;
  /** The same on the canvas, in CSS pixels; null behind the camera. */
  spot(body: number, index: number): [number, number] | null;
  /** Share (0 to 1) of the canvas that something other than background and grid covers. */
  pixels(): number;
}

export function api(app: App, ready: Promise<boolean>): Api {
  const at = (body: number, index: number) =>
    station(app.scene, app.scene.bodies[body].first + index, app.instant);
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
    station: at,
    spot: (body, index) => app.stage?.project(at(body, index)) ?? null,
    pixels: () => app.stage?.pixels(app.instant) ?? 0,
  };
}
