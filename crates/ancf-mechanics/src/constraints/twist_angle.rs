use std::ops::Range;

use ancf_solver::equations::{
    Inadmissibility, Level, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
};

use super::hinge_angle::HingeAngle;
use super::wrench::Wrench;
use crate::kinematics::BodyVector;

/// Twist of a body about an axis of another one as a massless coordinate τ, defined by one equation.
///
/// The rotation of the first body relative to the other one is a twist about the axis e, followed by the smallest
/// rotation that takes e to its axis. With directions p, p' of the first body that coincide with u and v = e × u of the
/// other one in the reference state: Φ = p·(cos τ v − sin τ u) − p'·(cos τ u + sin τ v) = (1 + cos β) sin(φ − τ) for
/// the angle β between the axes and the twist φ. τ counts full turns as a [`HingeAngle`] does. For β = 0 it is the angle
/// of a hinge.
///
/// Units: none; λ is half the moment about the axis for β = 0.
#[derive(Clone, Debug)]
pub struct TwistAngle {
    parts: [HingeAngle; 2],
}

impl TwistAngle {
    /// Defines the twist of the directions p and p' about u × v as a coordinate.
    pub fn new(
        coordinate: usize,
        [p, other]: [BodyVector; 2],
        [u, v]: [BodyVector; 2],
        multiplier: usize,
    ) -> Self {
        let others = BodyVector::union_coordinates([&p, &other, &u, &v]);
        let coordinates: Vec<usize> = [coordinate].into_iter().chain(others).collect();
        let back = BodyVector::combined([(-1.0, &u)]);
        let second = HingeAngle::over(coordinates.clone(), [other, v.clone(), back], multiplier);
        Self { parts: [HingeAngle::over(coordinates, [p, u, v], multiplier), second] }
    }

    /// Returns the contribution to the joint reaction on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        let [a, b] = self.parts.each_ref().map(|part| part.reaction(s));
        Wrench { force: a.force + b.force, moment: a.moment + b.moment }
    }
}

impl Term for TwistAngle {
    fn coordinates(&self) -> &[usize] {
        self.parts[0].coordinates()
    }

    fn multipliers(&self) -> Range<usize> {
        self.parts[0].multipliers()
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, _: usize) -> String {
        "definition of the twist".to_owned()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.parts.iter().for_each(|part| part.residual(at, r));
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.parts.iter().for_each(|part| part.rounding(at, floor));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.parts.iter().for_each(|part| part.tangent(at, w, k));
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        discrete_residual(self, step, r);
    }

    fn massless(&self) -> &[usize] {
        self.parts[0].massless()
    }

    fn counted_angle(&self) -> Option<usize> {
        self.parts[0].counted_angle()
    }

    fn rotation(&self, from: &Local<'_>, to: &Local<'_>) -> f64 {
        self.parts[0].rotation(from, to)
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let is_admissible = self.parts.iter().map(|part| part.along(at)).sum::<f64>() > 0.0;
        (!is_admissible).then_some(Inadmissibility::HalfTurn)
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        self.parts.iter().for_each(|part| part.constraints(at, level, phi));
    }
}
