// Interpolation in lists of numbers, with fractional indices.

/** True if no value is less than the one before it. */
export function isAscending(values: ArrayLike<number>): boolean {
  for (let i = 1; i < values.length; i++) if (!(values[i] >= values[i - 1])) return false;
  return true;
}

/** Fractional index of `x` in ascending values; index of the nearest value if they are not ascending. */
export function fractionalIndex(values: ArrayLike<number>, x: number): number {
  if (values.length === 0) return 0;
  if (!isAscending(values)) {
    let nearest = 0;
    for (let i = 1; i < values.length; i++)
      if (Math.abs(values[i] - x) < Math.abs(values[nearest] - x)) nearest = i;
    return nearest;
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

/** Linear interpolation of the values at a fractional index. */
export function interpolate(values: ArrayLike<number>, index: number): number {
  const i = Math.min(values.length - 1, Math.max(0, Math.floor(index)));
  const j = Math.min(values.length - 1, i + 1);
  return values[i] + (index - i) * (values[j] - values[i]);
}
