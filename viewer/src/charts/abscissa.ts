// The horizontal axis of the charts, and how it goes with the frames of the picture.

import { isModal, type Scene } from "../scene/scene";
import { ascending, positionOf } from "../ui/player";

export class Abscissa {
  readonly xs: number[];
  readonly label: string;
  readonly unit: string;
  /** Rows are shapes: nothing lies between them. */
  readonly discrete: boolean;
  /** Row of the charts at each frame; null: the frames have no place in the charts. */
  private readonly rows: number[] | null;

  constructor(scene: Scene) {
    const { values, name, unit } = scene.abscissa;
    const straight = ascending(values);
    // A path may turn back in its load factor: then its points are counted.
    this.xs = straight ? Array.from(values) : Array.from(values, (_, i) => i);
    this.label = straight ? name : "point of the path";
    this.unit = straight ? unit : "";
    this.discrete = isModal(scene);
    this.rows = values.length === 0 ? null : rows(scene.frames.values, values, straight);
  }

  /** Place on the axis of a (fractional) frame. */
  at(position: number): number | null {
    if (!this.rows || this.rows.length === 0) return null;
    return between(this.xs, between(this.rows, position));
  }

  /** Frame (fractional) at a place on the axis. */
  frame(x: number): number | null {
    return this.rows && positionOf(this.rows, positionOf(this.xs, x));
  }

  /** Row at a place on the axis: the nearest. */
  row(x: number): number {
    return Math.round(positionOf(this.xs, x));
  }
}

function between(list: number[], place: number): number {
  const i = Math.min(list.length - 1, Math.max(0, Math.floor(place)));
  const j = Math.min(list.length - 1, i + 1);
  return list[i] + (place - i) * (list[j] - list[i]);
}

function rows(frames: ArrayLike<number>, values: ArrayLike<number>, straight: boolean): number[] {
  if (frames.length === values.length) return Array.from(frames, (_, i) => i);
  if (straight) return Array.from(frames, (x) => positionOf(values, x));
  // Frames are some of the rows, in the same order.
  const close = 1e-9 * Math.max(...Array.from(values, Math.abs));
  let next = 0;
  return Array.from(frames, (x) => {
    let best = next;
    for (let i = next; i < values.length; i++) {
      if (Math.abs(values[i] - x) < Math.abs(values[best] - x)) best = i;
      if (Math.abs(values[best] - x) <= close) break;
    }
    next = Math.min(values.length - 1, best + 1);
    return best;
  });
}
