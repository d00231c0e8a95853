// The clock of the picture: which frame, and how it goes on.

import type { Instant } from "../scene/blend";
import { failed, isModal, type Scene } from "../scene/scene";
import { firstShape } from "../scene/shapes";

export const SPEEDS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Seconds that a film takes at first, and that a swing of a shape takes at speed one. */
const FILM = 8;
const SWING = 2;

export class Player {
  /** Frame, with a fraction between two frames; of modes the number of the shape. */
  position = 0;
  phase = Math.PI / 2;
  playing = false;
  speed = 1;
  /** Whether the film begins again at its end. */
  repeat = false;
  private modal = false;
  private values: ArrayLike<number> = [];
  /** Whether the speed is the user's choice; else it follows from the length of the run. */
  private chosen = false;
  private last: number | null = null;

  constructor(private readonly changed: () => void) {}

  /** Another scene; of a run that goes on the time stays, or the end if it was at the end. */
  load(scene: Scene, again: boolean): void {
    const atEnd = this.position >= this.values.length - 1;
    const time = this.time;
    this.modal = isModal(scene);
    this.values = scene.frames.values;
    if (!this.chosen) this.speed = this.timed ? nearest(this.duration / FILM) : 1;
    // What goes on or has failed is seen as it was last, shapes from the first that is not rigid.
    if (!again) this.position = scene.live || failed(scene) ? this.end : firstShape(scene);
    else if (atEnd && !this.playing) this.position = this.end;
    else this.seek(time);
  }

  get end(): number {
    return Math.max(0, this.values.length - 1);
  }

  /** The frames follow one another in time (or in load) without turning back. */
  get timed(): boolean {
    return !this.modal && ascending(this.values) && this.duration > 0;
  }

  private get duration(): number {
    return this.values.length > 1 ? this.values[this.end] - this.values[0] : 0;
  }

  get time(): number {
    if (this.values.length === 0) return 0;
    const i = Math.floor(this.position);
    const j = Math.min(i + 1, this.end);
    return this.values[i] + (this.position - i) * (this.values[j] - this.values[i]);
  }

  /** Goes to a time (the nearest frame if frames turn back in it). */
  seek(time: number): void {
    this.go(positionOf(this.values, time));
  }

  go(position: number): void {
    const whole = this.modal ? Math.round(position) : position;
    this.position = Math.min(this.end, Math.max(0, Number.isFinite(whole) ? whole : 0));
    this.changed();
  }

  /** Goes `count` frames on, from the frame that is nearest. */
  step(count: number): void {
    this.playing = false;
    const whole = count > 0 ? Math.floor(this.position + 1e-6) : Math.ceil(this.position - 1e-6);
    this.go(whole + count);
  }

  toggle(): void {
    if (!this.playing && this.end === 0 && !this.modal) return;
    this.playing = !this.playing;
    if (this.playing && !this.modal && this.position >= this.end) this.position = 0;
    this.last = null;
    this.changed();
  }

  faster(count: number): void {
    const i = SPEEDS.indexOf(this.speed);
    this.choose(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, i + count))]);
  }

  choose(speed: number): void {
    this.speed = speed;
    this.chosen = true;
    this.changed();
  }

  /** Moves on to `now` (seconds); to be called before each picture while it plays. */
  tick(now: number): void {
    const dt = this.last === null ? 0 : Math.min(0.1, now - this.last);
    this.last = now;
    if (!this.playing) return;
    this.advance(dt * this.speed);
  }

  /** Moves on by `dt` seconds of the film (of modes: of the swing). */
  advance(dt: number): void {
    if (this.modal) this.phase = (this.phase + (2 * Math.PI * dt) / SWING) % (2 * Math.PI);
    else if (this.timed) this.position = positionOf(this.values, this.time + dt);
    else this.position += (dt * this.end) / FILM;
    if (!this.modal && this.position >= this.end) {
      this.position = this.repeat ? 0 : this.end;
      this.playing = this.repeat;
    }
    this.changed();
  }

  instant(deformation: number): Instant {
    const first = Math.min(this.end, Math.floor(this.position));
    const second = Math.min(this.end, first + 1);
    const scale = this.modal ? deformation * Math.sin(this.phase) : deformation;
    return { first, second, weight: this.position - first, scale };
  }
}

export function ascending(values: ArrayLike<number>): boolean {
  for (let i = 1; i < values.length; i++) if (!(values[i] >= values[i - 1])) return false;
  return true;
}

/** Place of `x` in `values`: between two of them if they ascend, else the nearest one. */
export function positionOf(values: ArrayLike<number>, x: number): number {
  if (values.length === 0) return 0;
  if (!ascending(values)) {
    let best = 0;
    for (let i = 1; i < values.length; i++)
      if (Math.abs(values[i] - x) < Math.abs(values[best] - x)) best = i;
    return best;
  }
  let [low, high] = [0, values.length - 1];
  if (x <= values[low]) return low;
  if (x >= values[high]) return high;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= x) low = middle;
    else high = middle;
  }
  return low + (x - values[low]) / (values[high] - values[low]);
}

function nearest(speed: number): number {
  const off = (s: number) => Math.abs(Math.log(s / speed));
  return SPEEDS.reduce((best, s) => (off(s) < off(best) ? s : best), 1);
}
