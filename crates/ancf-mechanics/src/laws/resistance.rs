use std::sync::Arc;

use ancf_solver::equations::LocalStep;

use super::force_law::{ForceLaw, LawState, LawValue};
use crate::kinematics::gauss;

/// Units of the arguments and of the force of a law, measured in units of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawUnits {
    /// Unit of the coordinate x; 1 for an angle.
    pub position: f64,
    /// Unit of time.
    pub time: f64,
    /// Unit of the force, or of the moment.
    pub force: f64,
}

/// Force N of a law that resists the increase of a coordinate, in the units of the equations.
///
/// N(x, v, t, s) = ± f(x − x₀, v, t) ∓ (1 − s) f(−x₀, 0, t). The load factor s differs from 1 in statics only and scales the
/// force in the reference state, where x = 0. x₀ is the value of x at which the coordinate of the law is 0.
#[derive(Clone, Debug)]
pub struct Resistance {
    law: Arc<dyn ForceLaw>,
    units: LawUnits,
    /// Sign of N for a positive force of the law.
    sign: f64,
    /// x₀.
    origin: f64,
    /// Time of the law, if it is fixed.
    frozen: Option<f64>,
}

/// Relative error of the integral of a law.
const INTEGRAL_ERROR: f64 = 1e-13;
/// Relative error of the extrapolation of a law to the ends of an interval of integration.
const END_ERROR: f64 = 1e-6;
/// Maximum number of bisections of an interval of integration: jumps are located to 2⁻⁴⁰ of it.
const BISECTIONS: u32 = 40;

impl LawUnits {
    /// Equal units.
    pub const OWN: Self = Self { position: 1.0, time: 1.0, force: 1.0 };
}

impl Resistance {
    /// Creates the resistance of a law whose positive force resists the increase of the coordinate, as tension does.
    pub fn tensile(law: Arc<dyn ForceLaw>, units: LawUnits, origin: f64) -> Self {
        Self { law, units, sign: 1.0, origin, frozen: None }
    }

    /// Creates the resistance of a law whose positive force acts in the direction of the coordinate.
    pub fn acting(law: Arc<dyn ForceLaw>, units: LawUnits) -> Self {
        Self { law, units, sign: -1.0, origin: 0.0, frozen: None }
    }

    /// Fixes the time of the law, in its own unit of time.
    #[must_use]
    pub fn frozen_at(self, t: f64) -> Self {
        Self { frozen: Some(t), ..self }
    }

    /// True if the force has a potential at zero rate.
    pub fn is_autonomous(&self) -> bool {
        self.frozen.is_some() || self.law.is_autonomous()
    }

    /// Returns N and its derivatives at full load.
    fn full(&self, t: f64, x: f64, v: f64) -> LawValue {
        let LawUnits { position, time, force } = self.units;
        let t = self.frozen.unwrap_or(t * time);
        let state = LawState { t, x: (x - self.origin) * position, v: v * position / time };
        let value = self.law.at(state);
        let factor = self.sign / force;
        LawValue {
            force: value.force * factor,
            by_position: value.by_position * factor * position,
            by_rate: value.by_rate * factor * position / time,
        }
    }

    /// Returns N and its derivatives for a load factor.
    pub(crate) fn at(&self, t: f64, x: f64, v: f64, load: f64) -> LawValue {
        let mut value = self.full(t, x, v);
        if load != 1.0 {
            value.force -= (1.0 - load) * self.reference(t);
        }
        value
    }

    /// Returns N in the reference state, the derivative of N by the load factor.
    pub(crate) fn reference(&self, t: f64) -> f64 {
        self.full(t, 0.0, 0.0).force
    }

    /// Returns the mean of N at zero rate over an interval of x.
    pub(crate) fn mean(&self, t: f64, [from, to]: [f64; 2], load: f64) -> f64 {
        let force = |x: f64| self.full(t, x, 0.0).force;
        let mean = mean(&force, [from, to], BISECTIONS, 0.0);
        if load == 1.0 { mean } else { mean - (1.0 - load) * self.reference(t) }
    }

    /// Returns N of a step of the energy-momentum scheme for zero rate: the mean over the step, ΔU/Δx, for χ = 0.
    pub(crate) fn of_step(&self, ends: [f64; 2], step: &LocalStep<'_>) -> f64 {
        let LocalStep { middle, damping, .. } = step;
        let mean = self.mean(middle.t, ends, middle.load);
        if *damping == 0.0 {
            return mean;
        }
        let [before, now] = ends.map(|x| self.full(middle.t, x, 0.0).force);
        mean + damping * (now - before)
    }

    /// Returns ∫ N dx from the reference state at zero rate; 0 for a law without a potential.
    pub(crate) fn potential(&self, t: f64, x: f64, load: f64) -> f64 {
        if self.is_autonomous() { x * self.mean(t, [0.0, x], load) } else { 0.0 }
    }

    /// Returns a bound of the rounding error of N, for the rounding errors of x and v.
    pub(crate) fn rounding(&self, t: f64, [x, v]: [f64; 2], [of_x, of_v]: [f64; 2], load: f64) -> f64 {
        let value = self.at(t, x, v, load);
        let own = value.by_position.abs() * (x.abs() + self.origin.abs()) + value.by_rate.abs() * v.abs();
        let reference = if load == 1.0 { 0.0 } else { self.reference(t).abs() };
        8.0 * f64::EPSILON * (value.force.abs() + own + reference)
            + value.by_position.abs() * of_x
            + value.by_rate.abs() * of_v
    }
}

/// Mean of a function over an interval by adaptive Gauss-Legendre integration. `scale` is the mean of its magnitude on the
/// whole interval.
fn mean(f: &impl Fn(f64) -> f64, [a, b]: [f64; 2], bisections: u32, scale: f64) -> f64 {
    let rule = |a: f64, b: f64| gauss().map(|(x, w)| (w, f(a + (b - a) * x)));
    let sum = |values: [(f64, f64); 5]| values.iter().map(|(w, f)| w * f).sum::<f64>();
    let size = |values: [(f64, f64); 5]| values.iter().map(|(w, f)| w * f.abs()).sum::<f64>();
    let middle = 0.5 * (a + b);
    let [whole, left, right] = [rule(a, b), rule(a, middle), rule(middle, b)];
    let scale = scale.max(size(whole)).max(0.5 * (size(left) + size(right)));
    let halves = 0.5 * (sum(left) + sum(right));
    let values = whole.map(|(_, f)| f);
    // A kink beyond the outermost points is not in the sums.
    let ends = [(b, extrapolated(values)), (a, extrapolated([4, 3, 2, 1, 0].map(|k| values[k])))];
    let is_smooth = ends.into_iter().all(|(x, expected)| {
        let found = f(x);
        (found - expected).abs() <= END_ERROR * scale.max(found.abs())
    });
    let is_exact = is_smooth && (sum(whole) - halves).abs() <= INTEGRAL_ERROR * scale;
    if is_exact || bisections == 0 || !halves.is_finite() || middle == a || middle == b {
        return halves;
    }
    // The error of a half counts half in the mean.
    let half = |ends| mean(f, ends, bisections - 1, 2.0 * scale);
    0.5 * (half([a, middle]) + half([middle, b]))
}

/// Extrapolates the polynomial through the values at the points of the Gauss rule to the end 1.
fn extrapolated(values: [f64; 5]) -> f64 {
    let points = gauss().map(|(x, _)| x);
    let weight = |k: usize| {
        let others = (0..5).filter(|&i| i != k);
        others.map(|i| (1.0 - points[i]) / (points[k] - points[i])).product::<f64>()
    };
    (0..5).map(|k| weight(k) * values[k]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_is_exact_for_polynomials_kinks_and_jumps() {
        let of = |f: &dyn Fn(f64) -> f64, a, b| mean(&|x| f(x), [a, b], BISECTIONS, 0.0);
        assert!((of(&|x| x.powi(9), 0.0, 2.0) - 51.2).abs() < 1e-12);
        assert!((of(&|x| (x - 0.99).max(0.0), 0.0, 1.0) - 5e-5).abs() < 1e-14);
        assert!((of(&|x| x.max(0.0), -1.0, 2.0) - 2.0 / 3.0).abs() < 1e-12);
        assert!((of(&|x| f64::from(u8::from(x > 0.3)), 0.0, 1.0) - 0.7).abs() < 1e-11);
        assert!((of(&f64::exp, 3.0, 3.0) - 3.0_f64.exp()).abs() < 1e-13 * 3.0_f64.exp());
        assert!((of(&|x| 1.0 / (x * x + 1e-6), -1.0, 1.0) - 1e3 * 1e3_f64.atan()).abs() < 1e-9);
        assert!(of(&|_| f64::NAN, 0.0, 1.0).is_nan());
    }
}
