// Abscissa of the charts, and its relation to the frames of the animation.

import { fractionalIndex, interpolate, isAscending } from "../base/sequence";
import { isModal, type Scene } from "../scene/scene";

export class Abscissa {
  readonly xs: number[];
  readonly label: string;
  readonly unit: string;
  /** True if the rows are shapes, which are not connected by lines. */
  readonly discrete: boolean;
  /** Row of the charts for each frame; null if the charts have no rows. */
  private readonly rows: number[] | null;

  constructor(scene: Scene) {
    const { values, name, unit } = scene.abscissa;
    const ascending = isAscending(values);
    // The load factor of an equilibrium path may decrease. Its points are then numbered.
    this.xs = ascending ? Array.from(values) : Array.from(values, (_, i) => i);
    this.label = ascending ? name : "point of the path";
    this.unit = ascending ? unit : "";
    this.discrete = isModal(scene);
    this.rows = values.length === 0 ? null : rowsOfFrames(scene.frames.values, values, ascending);
  }

  /** Abscissa of a fractional frame. */
  at(frame: number): number | null {
    if (!this.rows || this.rows.length === 0) return null;
    return interpolate(this.xs, interpolate(this.rows, frame));
  }

  /** Fractional frame at an abscissa. */
  frame(x: number): number | null {
    return this.rows && fractionalIndex(this.rows, fractionalIndex(this.xs, x));
  }

  /** Row nearest to an abscissa. */
  row(x: number): number {
    return Math.round(fractionalIndex(this.xs, x));
  }
}

/** Rows of the charts for all frames. */
function rowsOfFrames(frames: ArrayLike<number>, values: ArrayLike<number>, ascending: boolean): number[] {
  if (frames.length === values.length) return Array.from(frames, (_, i) => i);
  if (ascending) return Array.from(frames, (x) => fractionalIndex(values, x));
  // The frames are a subset of the rows, in the same order.
  const tolerance = 1e-9 * Math.max(...Array.from(values, Math.abs));
  let next = 0;
  return Array.from(frames, (x) => {
    let nearest = next;
    for (let i = next; i < values.length; i++) {
      if (Math.abs(values[i] - x) < Math.abs(values[nearest] - x)) nearest = i;
      if (Math.abs(values[nearest] - x) <= tolerance) break;
    }
    next = Math.min(values.length - 1, nearest + 1);
    return nearest;
  });
}
