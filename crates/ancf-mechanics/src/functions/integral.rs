use std::f64::consts::TAU;

use super::varying::{Function, Instant};

/// The integral of a function from 0 to t, in closed form.
#[derive(Clone, Debug)]
pub struct Integral {
    of: Function,
    /// Of a table: its points (t, f) and the integral up to each from the first.
    sums: Vec<[f64; 3]>,
    /// The integral from the origin of the closed form to 0.
    origin: f64,
}

impl Integral {
    /// The integral of a function, if there is a closed form: of formulas and of what the program supplies there is none.
    pub fn new(of: Function) -> Option<Self> {
        let sums = match &of {
            Function::Expression { .. } | Function::External { .. } | Function::Integral(_) => return None,
            Function::Table(table) => sums(table.points()),
            _ => Vec::new(),
        };
        let mut integral = Self { of, sums, origin: 0.0 };
        integral.origin = integral.primitive(0.0);
        Some(integral)
    }

    /// Integral, function and rate.
    pub(crate) fn at(&self, t: f64) -> Instant {
        let Instant { value, rate, .. } = self.of.at(t);
        Instant { value: self.primitive(t) - self.origin, rate: value, acceleration: rate }
    }

    /// Where the function jumps or kinks.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        self.of.breaks()
    }

    fn primitive(&self, t: f64) -> f64 {
        match &self.of {
            Function::Constant(value) => value * t,
            Function::Table(_) => self.area(t),
            Function::Ramp { start, end } => {
                // Not `clamp`, which wants them in order: ramps are made before they are found to be wrong.
                let on = (t.max(*start).min(*end) - start).powi(2) / (2.0 * (end - start));
                on + (t - end).max(0.0)
            }
            Function::Step { at, until } => (until.map_or(t, |until| t.min(until)) - at).max(0.0),
            Function::Sine { frequency, phase } => {
                let half = 0.5 * TAU * frequency * t;
                // (cos φ − cos(ωt + φ))/ω without cancellation.
                let part = if half == 0.0 { 1.0 } else { half.sin() / half };
                t * part * (half + phase).sin()
            }
            Function::Expression { .. } | Function::External { .. } | Function::Integral(_) => 0.0,
        }
    }

    /// The integral of the table from its first point.
    fn area(&self, t: f64) -> f64 {
        let next = self.sums.partition_point(|[time, ..]| *time <= t);
        match (next.checked_sub(1).map(|last| self.sums[last]), self.sums.first()) {
            (Some([from, _, sum]), _) => sum + 0.5 * (t - from) * (self.held(next - 1) + self.of.value(t)),
            (None, Some([from, value, _])) => (t - from) * value,
            (None, None) => 0.0,
        }
    }

    fn held(&self, point: usize) -> f64 {
        self.sums[point][1]
    }
}

fn sums(points: &[[f64; 2]]) -> Vec<[f64; 3]> {
    let (mut sum, mut before): (f64, Option<[f64; 2]>) = (0.0, None);
    let next = |&[t, f]: &[f64; 2]| {
        if let Some([t0, f0]) = before.replace([t, f]) {
            sum += 0.5 * (t - t0) * (f + f0);
        }
        [t, f, sum]
    };
    points.iter().map(next).collect()
}
