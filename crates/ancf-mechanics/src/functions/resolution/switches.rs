use crate::functions::function::Function;
use crate::functions::function_value::FunctionValue;

/// Largest numbers of parts in the search for switches, and of switches.
const PARTS: usize = 1_000_000;
const SWITCHES: usize = 10_000;
/// Largest interval of a switch, a multiple of the smallest part: beyond it rates are not bounded over an interval.
const WIDEST: f64 = 1000.0;
/// Largest jump that counts as rounding, relative to the value and the rates times the duration.
const CONTINUOUS: f64 = 1e-9;
/// Smallest jump of a value between adjacent times, relative to the value and its rate times the duration.
const JUMP: f64 = 1e-12;
/// Smallest part in the search for switches, relative to the duration.
const SMALLEST: f64 = 1e-13;

impl Function {
    /// True if a formula jumps within a duration.
    pub fn jumps(&self, duration: f64) -> bool {
        self.switches(duration).into_iter().any(|t| {
            let [left, right] = [t.next_down(), t].map(|t| self.at(t));
            let size = |f: &FunctionValue| f.value.abs() + duration * f.rate.abs();
            (right.value - left.value).abs() > JUMP * size(&left).max(size(&right))
        })
    }

    /// Returns the times up to a duration at which a formula may jump or have a kink, in ascending order: those of
    /// conditions, comparisons and functions such as `abs`.
    ///
    /// They are the times near which interval arithmetic does not bound the second rate, and at which the value, the rate or
    /// the second rate jumps. A formula with more than ten
    /// thousand of them, or with unbounded rates over a whole interval, has none.
    pub fn switches(&self, duration: f64) -> Vec<f64> {
        let mut zones: Vec<(f64, f64)> = Vec::new();
        let is_searched = matches!(self, Self::Expression { .. }) && duration.is_finite() && duration > 0.0;
        let mut parts = if is_searched { vec![(0.0, duration)] } else { Vec::new() };
        let smallest = SMALLEST * duration;
        let mut count = 0;
        while let Some((a, b)) = parts.pop() {
            let middle = 0.5 * (a + b);
            count += 1;
            if self.bounds(a, b).acceleration.magnitude().is_finite() {
                continue;
            }
            if count > PARTS || zones.len() > SWITCHES {
                return Vec::new();
            }
            if b - a > smallest {
                parts.extend([(middle, b), (a, middle)]);
                continue;
            }
            match zones.last_mut().filter(|zone| a - zone.1 <= smallest) {
                Some(zone) if b - zone.0 > WIDEST * smallest => return Vec::new(),
                Some(zone) => zone.1 = b,
                None => zones.push((a, b)),
            }
        }
        zones.into_iter().filter_map(|zone| self.switch_in(zone, duration)).collect()
    }

    /// Returns the first time after a switch, to the last digit, or `None` if value and rates are continuous there, or if the
    /// value ceases to be finite.
    fn switch_in(&self, (mut a, mut b): (f64, f64), duration: f64) -> Option<f64> {
        if !self.value(b).is_finite() {
            return None;
        }
        let scaled = |f: FunctionValue| [f.value, f.rate * duration, f.acceleration * duration.powi(2)];
        let (left, right) = (scaled(self.at(a)), scaled(self.at(b)));
        let sizes = left.iter().chain(&right).map(|x| x.abs()).filter(|x| x.is_finite());
        let limit = CONTINUOUS * sizes.fold(0.0, f64::max);
        // Numbers that are not finite count as jumps.
        let jumps = |i: usize| {
            let change = (right[i] - left[i]).abs();
            change.is_nan() || change > limit
        };
        let which = (0..3).find(|&i| jumps(i))?;
        loop {
            let middle = 0.5 * (a + b);
            if middle <= a || middle >= b {
                return Some(b);
            }
            let here = scaled(self.at(middle))[which];
            let is_right = (here - right[which]).abs() < (here - left[which]).abs();
            if is_right { b = middle } else { a = middle }
        }
    }
}
