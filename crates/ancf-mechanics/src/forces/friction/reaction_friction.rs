use ancf_solver::equations::{LOCAL, Local, LocalMatrix, State, Term, Weights};

use super::bearing::Bearing;
use super::slip::Slip;
use crate::constraints::{Wrench, add_outer};
use crate::laws::FrictionCurve;

/// Dry friction along the slip of a bearing, of a given amount and in proportion to the reaction: f = −(F + μ ρ N(λ)) g(|s|) s/|s|.
///
/// The slip s has one or more components ([`Slip`]) that share one friction, as of a shaft that turns and slides in a sleeve. The
/// factor ρ is 1 if the slip is a velocity, and the radius of the pin or ball if it is an angular velocity. N is the sum of normal
/// forces of the [`Bearing`], g the [`FrictionCurve`]. The friction of step ends depends on the multipliers of the same step ends.
///
/// The tangent lacks the derivatives by multipliers and directions, which are not symmetric. Newton's method converges linearly, by a
/// factor of the order of μ times a ratio of lengths. Where it is 1 the joint is self-locking and the iterations fail.
#[derive(Clone, Debug)]
pub struct ReactionFriction {
    coordinates: Vec<usize>,
    /// Multipliers of the joint that N depends on; none without a coefficient.
    multipliers: Vec<usize>,
    global: Vec<Slip>,
    slip: Vec<Slip>,
    bearing: Bearing,
    law: FrictionLaw,
}

/// Magnitude of friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionLaw {
    /// Amount F without a reaction.
    pub amount: f64,
    /// Coefficient μ.
    pub coefficient: f64,
    /// Dependence g on the rate.
    pub curve: FrictionCurve,
}

/// Largest number of components.
const COMPONENTS: usize = 3;

/// Slip of a state.
struct Sliding {
    rows: [[f64; LOCAL]; COMPONENTS],
    components: [f64; COMPONENTS],
    /// F + μ ρ N.
    amount: f64,
    /// |s|.
    rate: f64,
    /// g(|s|)/|s|.
    ratio: f64,
}

impl ReactionFriction {
    /// Creates the friction of up to three components of slip, with the first of the multipliers of the joint.
    pub fn new(slip: Vec<Slip>, first: usize, bearing: Bearing, law: FrictionLaw) -> Self {
        assert!(slip.len() <= COMPONENTS, "a slip has up to three components");
        let of_bearing = bearing.directions().iter().flat_map(|direction| direction.coordinates());
        let mut coordinates: Vec<usize> = slip.iter().flat_map(Slip::coordinates).chain(of_bearing).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        let bearing = bearing.within(&coordinates);
        let count = if law.coefficient > 0.0 { bearing.multipliers() } else { 0 };
        let multipliers = (first..first + count).collect();
        let own = slip.iter().map(|slip| slip.within(&coordinates)).collect();
        Self { coordinates, multipliers, global: slip, slip: own, bearing, law }
    }

    /// Returns the slip and the magnitude of friction; without multipliers, as in the evaluation of masses, that without a reaction.
    fn sliding(&self, q: &[f64], v: &[f64], l: &[f64]) -> Sliding {
        let (mut rows, mut components) = ([[0.0; LOCAL]; COMPONENTS], [0.0; COMPONENTS]);
        for (k, slip) in self.slip.iter().enumerate() {
            rows[k] = slip.row(q);
            components[k] = rows[k].iter().zip(v).map(|(j, v)| j * v).sum();
        }
        let rate = components.iter().map(|s| s * s).sum::<f64>().sqrt();
        let FrictionLaw { mut amount, coefficient, curve } = self.law;
        if coefficient > 0.0 && l.len() >= self.multipliers.len() {
            amount += coefficient * self.bearing.normal(l, q, coefficient * curve.at(rate));
        }
        Sliding { rows, components, amount, rate, ratio: curve.ratio(rate) }
    }

    /// Returns the force and moment of friction on the first body, apart from those of equations that define coordinates.
    pub fn reaction(&self, s: &State) -> Wrench {
        let of = |x: &[f64], places: &[usize]| places.iter().map(|&i| x[i]).collect::<Vec<f64>>();
        let [q, v] = [&s.q, &s.v].map(|x| of(x, &self.coordinates));
        let now = self.sliding(&q, &v, &of(&s.lambda, &self.multipliers));
        let parts = self.global.iter().zip(now.components);
        parts.map(|(slip, component)| slip.wrench(s, -now.amount * now.ratio * component)).sum()
    }
}

impl Term for ReactionFriction {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn observed_multipliers(&self) -> &[usize] {
        &self.multipliers
    }

    fn has_kinks(&self) -> bool {
        true
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let now = self.sliding(at.q, at.v, at.lambda);
        for (row, component) in now.rows.iter().zip(now.components) {
            let force = now.amount * now.ratio * component;
            r.iter_mut().zip(row).for_each(|(r, j)| *r += force * j);
        }
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let now = self.sliding(at.q, at.v, at.lambda);
        let size = |row: &[f64; LOCAL]| row.iter().zip(at.v).map(|(j, v)| (j * v).abs()).sum::<f64>();
        let of_rates = now.rows.iter().map(size).sum::<f64>();
        let steepness = self.law.curve.slope(now.rate).abs().max(now.ratio);
        let force = now.amount * (now.ratio * now.rate + steepness * of_rates);
        for row in &now.rows {
            // Entries are sums, whose errors are of the order of the largest one.
            let error = 32.0 * f64::EPSILON * force * row.iter().fold(0.0, |size: f64, j| size.max(j.abs()));
            let touched = floor.iter_mut().zip(row).filter(|(_, j)| **j != 0.0);
            touched.for_each(|(floor, _)| *floor += error);
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (now, n, count) = (self.sliding(at.q, at.v, at.lambda), at.q.len(), self.slip.len());
        let along = if now.rate > 0.0 {
            (self.law.curve.slope(now.rate) - now.ratio) / (now.rate * now.rate)
        } else {
            0.0
        };
        for (i, row) in now.rows.iter().enumerate().take(count) {
            let mut weighted = [0.0; LOCAL];
            for (j, other) in now.rows.iter().enumerate().take(count) {
                let own = if i == j { now.ratio } else { 0.0 };
                let factor = own + along * now.components[i] * now.components[j];
                weighted.iter_mut().zip(other).for_each(|(sum, x)| *sum += factor * x);
            }
            add_outer(row, &weighted, w.v * now.amount, n, k);
        }
    }
}
