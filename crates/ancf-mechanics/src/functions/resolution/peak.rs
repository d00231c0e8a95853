use crate::functions::function::Function;
use crate::functions::variation::Variation;

/// Number of values for the mean of a function over a step.
const INNER: u32 = 16;
/// Number of bisections for the width of a peak.
const BISECTIONS: u32 = 30;

/// Step beside a peak, from its end at the peak to its other end.
#[derive(Clone, Copy)]
struct Side {
    near: f64,
    far: f64,
    /// Height of the peak above the value at the other end; negative for a dip.
    height: f64,
}

impl Side {
    fn length(&self) -> f64 {
        (self.far - self.near).abs()
    }
}

impl Function {
    /// Returns a peak or a dip at the end of a step by more than a limit, whose integral by the values at the ends of the steps is wrong
    /// by more than the limit times the step: a pulse that is narrower than a step.
    ///
    /// `ends` are the ends of some successive steps. A peak may be at the `start` of the motion, and not at its end.
    pub(super) fn unresolved_peak(&self, ends: &[f64], start: f64, limit: f64) -> Option<Variation> {
        let at_start = ends.get(1).filter(|_| ends[0] == start).map(|&after| (None, start, after));
        let inner = ends.windows(3).map(|near| (Some(near[0]), near[1], near[2]));
        at_start.into_iter().chain(inner).find_map(|(before, at, after)| {
            // Values on both sides of a jump.
            [at.next_down(), at].into_iter().find_map(|own| {
                let peak = self.value(own);
                let side = |near: f64, far: f64| Side { near, far, height: peak - self.value(far) };
                let left = before.map(|before| side(at.next_down(), before));
                let sides = [left, Some(side(at, after.next_down()))].into_iter().flatten();
                let is_peak = sides.clone().all(|side| side.height > limit);
                let is_dip = sides.clone().all(|side| side.height < -limit);
                if !is_peak && !is_dip {
                    return None;
                }
                let error: f64 = sides.clone().map(|side| self.error_of_ends(&side)).sum();
                let step = sides.clone().map(|side| side.length()).fold(0.0, f64::max);
                let height = sides.clone().map(|side| side.height.abs()).fold(f64::INFINITY, f64::min);
                (error.abs() > limit * step).then(|| {
                    let width = sides.map(|side| self.half_width(&side)).sum();
                    Variation { at, deviation: height, width }
                })
            })
        })
    }

    /// Returns the integral over a step by the values at its ends, less that of the function.
    fn error_of_ends(&self, side: &Side) -> f64 {
        let Side { near, far, .. } = *side;
        let inner = (0..INNER).map(|k| (f64::from(k) + 0.5) / f64::from(INNER));
        let mean = inner.map(|part| self.value(near + part * (far - near))).sum::<f64>() / f64::from(INNER);
        side.length() * (0.5 * (self.value(near) + self.value(far)) - mean)
    }

    /// Returns the distance from a peak at which half of its height is left; zero on the side of a jump.
    fn half_width(&self, side: &Side) -> f64 {
        let (mut high, mut low) = (side.near, side.far);
        let bottom = self.value(side.far);
        let is_high = |t: f64| (self.value(t) - bottom).abs() > 0.5 * side.height.abs();
        if !is_high(high) {
            return 0.0;
        }
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (high + low);
            if is_high(middle) { high = middle } else { low = middle }
        }
        (low - side.near).abs()
    }
}
