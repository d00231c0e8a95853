// Playback: current frame, speed, and advance with the clock.

import { fractionalIndex, interpolate, isAscending } from "../base/sequence";
import type { FrameBlend } from "../scene/blend";
import { hasFailed, isModal, type Scene } from "../scene/scene";
import { firstElasticShape } from "../scene/shapes";

export const SPEEDS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** Duration of an animation at the default speed, in seconds. */
const DURATION = 8;
/** Period of the oscillation of a shape at speed one, in seconds. */
const PERIOD = 2;

export class Player {
  /** Fractional frame; for modes the index of the shape. */
  position = 0;
  /** Phase of the oscillation of a shape. */
  phase = Math.PI / 2;
  playing = false;
  speed = 1;
  /** True if the animation restarts at its end. */
  repeat = false;
  private modal = false;
  private values: ArrayLike<number> = [];
  /** Of each frame the one with the imaginary part of its shape. */
  private imaginary: (number | null)[] = [];
  /** True if the user has selected the speed. Otherwise it follows from the duration of the run. */
  private speedSelected = false;
  private lastTick: number | null = null;

  constructor(private readonly changed: () => void) {}

  /** Loads a scene. An update of a live run keeps the time, or stays at the end. */
  load(scene: Scene, update: boolean): void {
    const atEnd = this.position >= this.values.length - 1;
    const time = this.time;
    this.modal = isModal(scene);
    this.values = scene.frames.values;
    this.imaginary = scene.frames.imaginary ?? [];
    if (!this.speedSelected) this.speed = this.timed ? nearestSpeed(this.duration / DURATION) : 1;
    // Live and failed runs and statics open at their last frame, shapes at the first one that is not rigid.
    const last = scene.live || hasFailed(scene) || scene.analysis === "statics";
    if (!update) this.position = last ? this.end : firstElasticShape(scene);
    else if (atEnd && !this.playing) this.position = this.end;
    else this.seek(time);
  }

  /** Index of the last frame. */
  get end(): number {
    return Math.max(0, this.values.length - 1);
  }

  /** True if the frames ascend in time or load factor. */
  get timed(): boolean {
    return !this.modal && isAscending(this.values) && this.duration > 0;
  }

  private get duration(): number {
    return this.values.length > 1 ? this.values[this.end] - this.values[0] : 0;
  }

  get time(): number {
    return this.values.length === 0 ? 0 : interpolate(this.values, this.position);
  }

  /** Moves to a time, or to the nearest frame if the times do not ascend. */
  seek(time: number): void {
    this.goTo(fractionalIndex(this.values, time));
  }

  /** Moves to a fractional frame. */
  goTo(position: number): void {
    const target = this.modal ? Math.round(position) : position;
    this.position = Math.min(this.end, Math.max(0, Number.isFinite(target) ? target : 0));
    this.changed();
  }

  /** Moves by a number of whole frames and pauses. */
  step(count: number): void {
    this.playing = false;
    const whole = count > 0 ? Math.floor(this.position + 1e-6) : Math.ceil(this.position - 1e-6);
    this.goTo(whole + count);
  }

  /** Starts or pauses the playback. */
  toggle(): void {
    if (!this.playing && this.end === 0 && !this.modal) return;
    this.playing = !this.playing;
    if (this.playing && !this.modal && this.position >= this.end) this.position = 0;
    this.lastTick = null;
    this.changed();
  }

  /** Changes the speed by a number of entries of `SPEEDS`. */
  changeSpeed(steps: number): void {
    const i = SPEEDS.indexOf(this.speed);
    this.selectSpeed(SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, i + steps))]);
  }

  selectSpeed(speed: number): void {
    this.speed = speed;
    this.speedSelected = true;
    this.changed();
  }

  /** Advances to the clock time `now` in seconds. Called before each drawing. */
  tick(now: number): void {
    const dt = this.lastTick === null ? 0 : Math.min(0.1, now - this.lastTick);
    this.lastTick = now;
    if (!this.playing) return;
    this.advance(dt * this.speed);
  }

  /** Advances by `dt` seconds of the run, or of the oscillation of a shape. */
  private advance(dt: number): void {
    if (this.modal) this.phase = (this.phase + (2 * Math.PI * dt) / PERIOD) % (2 * Math.PI);
    else if (this.timed) this.position = fractionalIndex(this.values, this.time + dt);
    else this.position += (dt * this.end) / DURATION;
    if (!this.modal && this.position >= this.end) {
      this.position = this.repeat ? 0 : this.end;
      this.playing = this.repeat;
    }
    this.changed();
  }

  /** Frames to draw, with the displacements scaled by `deformation`. Shapes move with a constant amplitude. */
  blend(deformation: number): FrameBlend {
    const first = Math.min(this.end, Math.floor(this.position));
    const next = Math.min(this.end, first + 1);
    const weight = this.position - first;
    if (!this.modal) return { first, second: next, weight, scale: deformation, imaginary: 0 };
    const scale = deformation * Math.sin(this.phase);
    const second = this.imaginary[first] ?? null;
    if (second === null) return { first, second: next, weight, scale, imaginary: 0 };
    // Re cos(wt) - Im sin(wt) with the phase wt + pi/2.
    return { first, second, weight: 0, scale, imaginary: deformation * Math.cos(this.phase) };
  }
}

/** Entry of `SPEEDS` nearest to a speed on a logarithmic scale. */
function nearestSpeed(speed: number): number {
  const distance = (s: number) => Math.abs(Math.log(s / speed));
  return SPEEDS.reduce((best, s) => (distance(s) < distance(best) ? s : best), 1);
}
