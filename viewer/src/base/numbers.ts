// Numbers: text for display, rounding noise, round values.

/** Relative size below which a number counts as rounding noise. */
export const ROUNDING_NOISE = 1e-12;

/** Formats a number with `digits` significant digits and an exponent where it saves zeros. */
export function formatNumber(x: number, digits = 4): string {
  if (Number.isNaN(x)) return "–";
  if (!Number.isFinite(x)) return x > 0 ? "∞" : "−∞";
  if (x === 0) return "0";
  const size = Math.abs(x);
  const rounded = Number(x.toPrecision(digits));
  const plain = size >= 1e-3 && size < 1e5;
  const short = plain ? String(rounded) : rounded.toExponential().replace("e+", "e");
  return short.replace(/-/g, "−");
}

/** Returns the number, or zero if it is rounding noise relative to `reference`. */
export function suppressNoise(x: number, reference: number): number {
  return Math.abs(x) < ROUNDING_NOISE * reference ? 0 : x;
}

/** Largest absolute value of the finite numbers of a list. */
export function largestMagnitude(values: ArrayLike<number>): number {
  let largest = 0;
  for (let i = 0; i < values.length; i++) {
    const size = Math.abs(values[i]);
    if (size > largest && Number.isFinite(size)) largest = size;
  }
  return largest;
}

/** Smallest and largest finite value; null if there is none. */
export function valueRange(values: ArrayLike<number>): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < values.length; i++) {
    const x = values[i];
    if (!Number.isFinite(x)) continue;
    if (x < low) low = x;
    if (x > high) high = x;
  }
  return low <= high ? [low, high] : null;
}

/** Smallest round number (1, 2 or 5 times a power of ten) not below `x`. */
export function roundUp(x: number): number {
  if (!(x > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(x));
  return power * ([1, 2, 5, 10].find((m) => m * power >= x * (1 - 1e-9)) ?? 10);
}
