// Areas of the 3-D view that buttons and legends do not cover.

import type { Rectangle } from "../view/camera";

/** Gap between an element and a free area in pixels. */
const GAP = 6;
/** Smallest side of a free area in pixels. */
const MIN_SIDE = 120;

/** Rectangles of visible elements relative to the canvas. */
export function coveredAreas(canvas: HTMLElement, elements: Element[]): Rectangle[] {
  const origin = canvas.getBoundingClientRect();
  return elements
    .map((element) => element.getBoundingClientRect())
    .filter(({ width, height }) => width > 0 && height > 0)
    .map(({ left, top, right, bottom }) => ({
      left: left - origin.left,
      top: top - origin.top,
      right: right - origin.left,
      bottom: bottom - origin.top,
    }));
}

export function overlap(a: Rectangle, b: Rectangle): boolean {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

function contains(a: Rectangle, b: Rectangle): boolean {
  return a.left <= b.left && a.top <= b.top && a.right >= b.right && a.bottom >= b.bottom;
}

/** Largest rectangles of a view that do not overlap the covered ones; the whole view if there are none. */
export function freeAreas(width: number, height: number, covered: Rectangle[]): Rectangle[] {
  const whole = { left: 0, top: 0, right: width, bottom: height };
  const found: Rectangle[] = [];
  for (const left of [0, ...covered.map((c) => c.right + GAP)]) {
    for (const top of [0, ...covered.map((c) => c.bottom + GAP)]) {
      for (const right of [width, ...covered.map((c) => c.left - GAP)]) {
        for (const bottom of [height, ...covered.map((c) => c.top - GAP)]) {
          const area = { left, top, right, bottom };
          const large = right - left >= MIN_SIDE && bottom - top >= MIN_SIDE;
          if (large && !covered.some((c) => overlap(area, c))) found.push(area);
        }
      }
    }
  }
  const largest = found.filter((a) => !found.some((b) => b !== a && contains(b, a) && !contains(a, b)));
  return largest.length > 0 ? largest : [whole];
}
