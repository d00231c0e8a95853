use std::ops::Range;

use ancf_solver::equations::{
    Inadmissibility, LOCAL, Level, Local, LocalMatrix, LocalStep, State, Term, Weights, discrete_residual,
    middle_residual, quadratic_constraints,
};

use super::bilinear_measure::BilinearMeasure;
use super::bilinear_row::{BilinearRow, QuadraticConstraint};
use super::constraint_group::GroupedConstraint;
use super::measure_target::MeasureTarget;
use super::wrench::Wrench;

/// Equation that prescribes the value of a measure. Joints, drives and couplings consist of such equations.
///
/// Φ = g(q) − g₀ − c(t); Φ_qᵀ λ = λ ∂g/∂q.
///
/// Units: those of the measure; λ is energy per unit of the measure.
#[derive(Clone, Debug)]
pub struct MeasureConstraint {
    global: BilinearMeasure,
    measure: BilinearMeasure,
    target: MeasureTarget,
    coordinates: Vec<usize>,
    massless: Vec<usize>,
    multiplier: usize,
    name: &'static str,
    /// Measure that is positive in admissible states.
    positive: Option<BilinearMeasure>,
}

impl MeasureConstraint {
    /// Keeps a measure at its reference value with the given multiplier.
    pub fn new(measure: BilinearMeasure, multiplier: usize) -> Self {
        Self::driven(measure, MeasureTarget::NONE, multiplier)
    }

    /// Drives a measure to a target.
    pub fn driven(measure: BilinearMeasure, target: MeasureTarget, multiplier: usize) -> Self {
        let coordinates = measure.coordinates();
        let (local, massless, positive) = (measure.within(&coordinates), Vec::new(), None);
        let name = "guide";
        Self { global: measure, measure: local, target, coordinates, massless, multiplier, name, positive }
    }

    /// Restricts the equation to states in which another measure is positive, since it also holds half a turn away.
    #[must_use]
    pub fn where_positive(self, other: &BilinearMeasure) -> Self {
        let mut coordinates = [self.coordinates, other.coordinates()].concat();
        coordinates.sort_unstable();
        coordinates.dedup();
        let measure = self.global.within(&coordinates);
        let positive = Some(other.within(&coordinates));
        Self { measure, coordinates, positive, ..self }
    }

    /// Sets the description of the constraint.
    #[must_use]
    pub fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// Defines the change of a measure as a massless coordinate: Φ = g(q) − g₀ − q_c.
    pub fn defining(coordinate: usize, measure: BilinearMeasure, multiplier: usize) -> Self {
        Self { massless: vec![coordinate], ..Self::new(measure.plus(coordinate, -1.0), multiplier) }
    }

    /// Copies the constraint as a part of a group, if it keeps a quadratic measure at its reference value in all states.
    pub fn grouped(&self) -> Option<GroupedConstraint> {
        GroupedConstraint::new(self)
    }

    /// Returns the contribution to the joint reaction on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        self.global.wrench(s, -s.lambda[self.multiplier])
    }
}

impl QuadraticConstraint for MeasureConstraint {
    fn rows(&self) -> Option<Vec<BilinearRow>> {
        let is_plain = self.positive.is_none() && self.massless.is_empty() && self.target.is_none();
        self.measure.row().filter(|_| is_plain).map(|row| vec![row])
    }
}

impl Term for MeasureConstraint {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let n = at.q.len();
        self.measure.add_gradient(at.q, at.lambda[0], &mut r[..n]);
        r[n] += self.measure.change(at.q) - self.target.value(at);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let n = at.q.len();
        let of_change = self.measure.add_rounding(at.q, at.lambda[0], &mut floor[..n]);
        floor[n] += of_change + f64::EPSILON * self.target.size(at);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (n, mut gradient) = (at.q.len(), [0.0; LOCAL]);
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..n]);
        gradient[..n].iter().enumerate().for_each(|(i, x)| k.add(n, i, *x));
        self.measure.add_curvature(at.q, w.q * at.lambda[0], k);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        if self.measure.is_quadratic() {
            return middle_residual(self, step, r);
        }
        discrete_residual(self, step, r);
    }

    fn constraint_name(&self, _: usize) -> String {
        self.name.to_owned()
    }

    fn massless(&self) -> &[usize] {
        &self.massless
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        if self.measure.is_quadratic() {
            return quadratic_constraints(self, at, level, phi);
        }
        let [rate, acceleration] = self.target.rates(at.t);
        phi[0] += match level {
            Level::Position => self.measure.change(at.q) - self.target.value(at),
            Level::Velocity => self.measure.slope(at.q, at.v) - rate,
            Level::Acceleration => self.measure.second_slope(at.q, at.v) - acceleration,
        };
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        let is_admissible =
            self.positive.as_ref().is_none_or(|measure| measure.reference() + measure.change(at.q) > 0.0);
        (!is_admissible).then_some(Inadmissibility::HalfTurn)
    }

    fn drive(&self, t: f64, rates: &mut [f64], accelerations: &mut [f64]) {
        let [rate, acceleration] = self.target.rates(t);
        rates[0] -= rate;
        accelerations[0] -= acceleration;
    }
}
