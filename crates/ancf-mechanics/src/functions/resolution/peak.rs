use crate::functions::function::Function;
use crate::functions::variation::Variation;

/// Number of values for the mean of a function over a step.
const INNER: u32 = 16;
/// Number of bisections for the width of a peak, below which it counts as that of the last interval.
const BISECTIONS: u32 = 30;

/// Step beside a peak.
struct Side {
    /// Length of the step.
    length: f64,
    /// Height of the peak above the value at the other end of the step; negative for a dip.
    height: f64,
    /// Integral over the step by the values at its ends, less that of the function.
    error: f64,
    /// Distance from the peak at which half of the height is left.
    width: f64,
}

impl Function {
    /// Returns a peak or a dip at the end of a step by more than a limit, whose integral by the values at the ends of the steps is wrong
    /// by more than the limit times the step: a pulse that is narrower than a step.
    ///
    /// `ends` are the ends of some successive steps. A peak may be at the `start` of the motion, and not at its end.
    pub(super) fn unresolved_peak(&self, ends: &[f64], start: f64, limit: f64) -> Option<Variation> {
        let is_start = ends.first() == Some(&start);
        let from_start = is_start.then(|| ends.get(1).map(|&after| (None, start, after))).flatten();
        let inner = ends.windows(3).map(|near| (Some(near[0]), near[1], near[2]));
        from_start.into_iter().chain(inner).find_map(|(before, at, after)| {
            // Values on both sides of a jump.
            let sides = |peak: f64| {
                let left = before.map(|before| self.side(peak, at.next_down(), before));
                [left, Some(self.side(peak, at, after.next_down()))].into_iter().flatten()
            };
            [self.value(at.next_down()), self.value(at)].into_iter().find_map(|peak| {
                let least = sides(peak).map(|side| side.height.abs()).fold(f64::INFINITY, f64::min);
                let is_peak = sides(peak).all(|side| side.height > 0.0);
                let is_dip = sides(peak).all(|side| side.height < 0.0);
                let error: f64 = sides(peak).map(|side| side.error).sum();
                let step = sides(peak).map(|side| side.length).fold(0.0, f64::max);
                let is_unresolved = (is_peak || is_dip) && least > limit && error.abs() > limit * step;
                let width = || sides(peak).map(|side| side.width).sum();
                is_unresolved.then(|| Variation { at, deviation: least, width: width() })
            })
        })
    }

    /// Returns the step from the end `near` at a peak to the end `far`.
    fn side(&self, peak: f64, near: f64, far: f64) -> Side {
        let [of_near, of_far] = [near, far].map(|t| self.value(t));
        let (length, height) = ((far - near).abs(), peak - of_far);
        let inner = (0..INNER).map(|k| (f64::from(k) + 0.5) / f64::from(INNER));
        let mean = inner.map(|part| self.value(near + part * (far - near))).sum::<f64>() / f64::from(INNER);
        let is_high = |t: f64| (self.value(t) - of_far).abs() > 0.5 * height.abs();
        let (mut high, mut low) = (near, far);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (high + low);
            if is_high(middle) { high = middle } else { low = middle }
        }
        let width = if is_high(near) { (low - near).abs() } else { 0.0 };
        Side { length, height, error: length * (0.5 * (of_near + of_far) - mean), width }
    }
}
