use std::ops::Range;

use ancf_solver::equations::{
    Inadmissibility, Level, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
};
use nalgebra::Vector3;

use super::wrench::Wrench;
use crate::kinematics::{BodyVector, relative_driven_rotation};

/// Angle of a revolute joint as a massless coordinate θ, defined by one equation.
///
/// A direction p of the first body remains in the plane through the axis that is rotated by θ:
/// Φ = p·w, w = cos θ v − sin θ u, with u, v directions of the other body or the ground normal to the axis and v = axis
/// × u. u is parallel to p in the reference state. θ counts full turns, since it is continuous in time. Φ also vanishes
/// at θ + π, where p is opposite to u. That state is inadmissible. Φ vanishes at θ + 2π, too. Time integration rejects
/// steps that end more than a quarter of a turn from the prediction.
///
/// Units: none; λ is the moment about the axis.
#[derive(Clone, Debug)]
pub struct HingeAngle {
    global: [BodyVector; 3],
    /// Directions p, u, v.
    vectors: [BodyVector; 3],
    /// Coordinates, θ first.
    coordinates: Vec<usize>,
    multiplier: usize,
}

/// Position of θ among the coordinates.
const THETA: usize = 0;

/// Quantities in Φ.
struct AngleValues {
    p: Vector3<f64>,
    sin: f64,
    cos: f64,
    /// w = cos θ v − sin θ u, and −∂w/∂θ = sin θ v + cos θ u.
    w: Vector3<f64>,
    along: Vector3<f64>,
}

impl HingeAngle {
    /// Defines the angle from u to p about u × v as a coordinate.
    pub fn new(
        coordinate: usize,
        p: impl Into<BodyVector>,
        [u, v]: [impl Into<BodyVector>; 2],
        multiplier: usize,
    ) -> Self {
        let global = [p.into(), u.into(), v.into()];
        let others = BodyVector::union_coordinates(&global);
        Self::over([coordinate].into_iter().chain(others).collect(), global, multiplier)
    }

    /// Creates the angle for a term with the given coordinates, θ first.
    pub(crate) fn over(coordinates: Vec<usize>, global: [BodyVector; 3], multiplier: usize) -> Self {
        let vectors = global.each_ref().map(|vector| vector.within(&coordinates));
        Self { global, vectors, coordinates, multiplier }
    }

    /// Returns the contribution to the joint reaction on the body that carries p: the moment p × (−λ w).
    pub fn reaction(&self, s: &State) -> Wrench {
        let [p, u, v] = self.global.each_ref().map(|vector| vector.value(s));
        let (sin, cos) = s.q[self.coordinates[THETA]].sin_cos();
        let moment = p.cross(&((v * cos - u * sin) * -s.lambda[self.multiplier]));
        Wrench { moment, ..Wrench::default() }
    }

    /// Returns the product of p and u rotated by θ, which is positive in admissible states.
    pub(crate) fn along(&self, at: &Local<'_>) -> f64 {
        let AngleValues { p, along, .. } = self.values(at.q);
        p.dot(&along)
    }

    fn values(&self, q: &[f64]) -> AngleValues {
        let [p, u, v] = self.vectors.each_ref().map(|vector| vector.at(q));
        let (sin, cos) = q[THETA].sin_cos();
        AngleValues { p, sin, cos, w: v * cos - u * sin, along: v * sin + u * cos }
    }
}

impl Term for HingeAngle {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, _: usize) -> String {
        "definition of the angle".to_owned()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (n, lambda) = (at.q.len(), at.lambda[0]);
        let AngleValues { p, sin, cos, w, along } = self.values(at.q);
        let [of_p, of_u, of_v] = &self.vectors;
        of_p.add(at.q, w * lambda, r);
        of_u.add(at.q, p * (-sin * lambda), r);
        of_v.add(at.q, p * (cos * lambda), r);
        r[THETA] -= lambda * p.dot(&along);
        r[n] += p.dot(&w);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (n, lambda) = (at.q.len(), at.lambda[0].abs());
        let [p, u, v] = self.vectors.each_ref().map(|vector| vector.size(at.q));
        // The rounding error of an angle of many turns is ε times its value.
        let turn = f64::EPSILON * (2.0 + at.q[THETA].abs());
        let mut of_equation = turn * p * (u + v);
        for (vector, size) in self.vectors.iter().zip([u + v, p, p]) {
            let [error, _] = vector.errors(at.q);
            of_equation += if vector.is_linear() { 0.0 } else { error * size };
            let Some(marker) = vector.marker() else {
                vector.add_errors(at.q, lambda * size, turn * lambda * size, floor);
                continue;
            };
            for &(first, w) in marker.parts() {
                floor[first..first + 3].iter_mut().for_each(|row| *row += turn * lambda * size * w.abs());
            }
        }
        floor[THETA] += turn * lambda * p * (u + v);
        floor[n] += of_equation;
    }

    fn tangent(&self, at: &Local<'_>, weights: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        let AngleValues { p, sin, cos, w, along } = self.values(at.q);
        let f = weights.q * at.lambda[0];
        let [of_p, of_u, of_v] = &self.vectors;
        k.add(n, THETA, -p.dot(&along));
        k.add(THETA, THETA, -f * p.dot(&w));
        for (vector, slope, turned) in
            [(of_p, w, -along), (of_u, p * -sin, p * -cos), (of_v, p * cos, p * -sin)]
        {
            vector.blocks(at.q, |first, block| {
                let (slope, turned) = (block.transpose() * slope, block.transpose() * turned);
                for i in 0..3 {
                    k.add(n, first + i, slope[i]);
                    k.add(first + i, THETA, f * turned[i]);
                }
            });
            vector.add_curvature(at.q, slope * f, k);
        }
        for (vector, factor) in [(of_u, -sin), (of_v, cos)] {
            of_p.add_product(vector, at.q, f * factor, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        discrete_residual(self, step, r);
    }

    fn massless(&self) -> &[usize] {
        &self.coordinates[..=THETA]
    }

    fn counted_angle(&self) -> Option<usize> {
        Some(self.coordinates[THETA])
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        relative_driven_rotation(to.q[THETA] - from.q[THETA])
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let is_admissible = self.along(at) > 0.0;
        (!is_admissible).then_some(Inadmissibility::HalfTurn)
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        let AngleValues { p, sin, cos, w, along } = self.values(at.q);
        let [dp, du, dv] = self.vectors.each_ref().map(|vector| vector.rate(at.q, at.v));
        let [ddp, ddu, ddv] = self.vectors.each_ref().map(|vector| vector.rate_slope(at.q, at.v));
        let (rate, carried) = (at.v[THETA], dv * cos - du * sin);
        phi[0] += match level {
            Level::Position => p.dot(&w),
            Level::Velocity => dp.dot(&w) + p.dot(&carried) - rate * p.dot(&along),
            Level::Acceleration => {
                ddp.dot(&w) + p.dot(&(ddv * cos - ddu * sin)) + 2.0 * dp.dot(&carried)
                    - 2.0 * rate * (dp.dot(&along) + p.dot(&(dv * sin + du * cos)))
                    - rate * rate * p.dot(&w)
            }
        };
    }
}
