use serde::{Deserialize, Serialize};

use super::scheme::SchemeCoefficients;
use super::start::StartValues;
use super::step_change::Auxiliary;
use crate::equations::{Power, State};
use crate::vectors::{copy, for_each_chunk, sum_of_chunks};

/// Damping forces of the state, from which the scheme computes their work.
///
/// With the mean velocity v̄ = ½(vₙ + vₙ₊₁) a step changes the kinetic energy by v̄·M(vₙ₊₁ − vₙ). For a constant mass
/// matrix this is the work of the impulses h [(1 − γ) aₙ + γ aₙ₊₁] M. The damping forces F have the same share in the
/// auxiliary accelerations as in the true ones:
///
/// ΔW = h v̄·[(1 − γ) φₙ + γ φₙ₊₁],   (1 − αm) φₙ₊₁ + αm φₙ = (1 − αf) Fₙ₊₁ + αf Fₙ.
///
/// The sum of ΔW is thus the kinetic energy that the scheme removes by damping, in steps of any size. The integral of
/// the power F·v has no such bound: it diverges where a velocity decays within a step.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct DampingForces {
    /// F, over the coordinates.
    force: Vec<f64>,
    /// Auxiliary forces φ.
    auxiliary: Vec<f64>,
}

impl DampingForces {
    /// Creates the forces of a start with φ = F. Entries of multipliers are ignored.
    pub(crate) fn new(coordinates: usize, force: &[f64]) -> Self {
        let force = force[..coordinates].to_vec();
        Self { auxiliary: force.clone(), force }
    }

    /// Sets φ = F at a start.
    pub(crate) fn restart(&mut self, force: &[f64]) {
        let force = &force[..self.force.len()];
        self.force.copy_from_slice(force);
        self.auxiliary.copy_from_slice(force);
    }

    /// Replaces F by forces of a state nearby. φ − F remains.
    pub(crate) fn replace(&mut self, force: &[f64]) {
        for ((own, auxiliary), force) in self.force.iter_mut().zip(&mut self.auxiliary).zip(force) {
            *auxiliary += force - *own;
            *own = *force;
        }
    }

    /// Removes the forces of a start with accelerations that do not contain them.
    pub(crate) fn clear(&mut self) {
        self.force.fill(0.0);
        self.auxiliary.fill(0.0);
    }

    /// Returns the auxiliary and the actual forces.
    pub(crate) fn auxiliary(&mut self) -> Auxiliary<'_> {
        Auxiliary { auxiliary: &mut self.auxiliary, actual: &self.force }
    }

    /// Scales φ − F with the step size, as the accelerations.
    fn rescaled(&self, i: usize, ratio: f64) -> f64 {
        self.force[i] + ratio * (self.auxiliary[i] - self.force[i])
    }

    /// Returns the work ΔW of a step between two states, and sets the auxiliary forces at its end.
    ///
    /// `start` has the forces of a first step. For other steps `ratio` is the ratio to the step size of φ.
    pub(crate) fn work(
        &self,
        scheme: SchemeCoefficients,
        (before, now): (&State, &State),
        (start, ratio): (Option<&StartValues>, f64),
        attempt: &mut DampingAttempt,
    ) -> f64 {
        let h = now.t - before.t;
        let first =
            |i: usize| start.map_or_else(|| self.rescaled(i, ratio), |start| start.auxiliary_damping[i]);
        let before_force = start.map_or(&self.force[..], |start| &start.damping);
        let DampingAttempt { force, auxiliary } = attempt;
        for_each_chunk(auxiliary, |range, auxiliary| {
            for (last, i) in auxiliary.iter_mut().zip(range) {
                *last = scheme.auxiliary(first(i), before_force[i], force[i]);
            }
        });
        let work = |i: usize| {
            let mean = (1.0 - scheme.gamma) * first(i) + scheme.gamma * auxiliary[i];
            0.5 * h * (before.v[i] + now.v[i]) * mean
        };
        sum_of_chunks(now.v.len(), |range| range.map(work).sum())
    }

    /// Returns true if the forces dissipate at both ends of a step. `start` has the forces of a first step.
    pub(crate) fn dissipate(
        &self,
        (before, now): (&State, &State),
        start: Option<&StartValues>,
        attempt: &DampingAttempt,
    ) -> bool {
        let before_force = start.map_or(&self.force[..], |start| &start.damping);
        let power =
            |force: &[f64], v: &[f64]| sum_of_chunks(v.len(), |range| range.map(|i| force[i] * v[i]).sum());
        power(before_force, &before.v) >= 0.0 && power(&attempt.force, &now.v) >= 0.0
    }

    /// Advances to the end of an attempted step.
    pub(crate) fn accept(&mut self, attempt: &DampingAttempt) {
        let n = self.force.len();
        copy(&attempt.force[..n], &mut self.force);
        copy(&attempt.auxiliary, &mut self.auxiliary);
    }

    /// Returns true if the forces have the given number of entries and are finite.
    pub(crate) fn is_valid(&self, size: usize) -> bool {
        let Self { force, auxiliary } = self;
        let sizes = force.len() == size && auxiliary.len() == size;
        sizes && force.iter().chain(auxiliary).all(|x| x.is_finite())
    }
}

/// Damping forces at the end of an attempted step.
#[derive(Clone, Debug)]
pub(crate) struct DampingAttempt {
    /// F, with entries of multipliers, which are ignored.
    pub(crate) force: Vec<f64>,
    /// Auxiliary forces φ.
    auxiliary: Vec<f64>,
}

impl DampingAttempt {
    pub(crate) fn new(coordinates: usize, multipliers: usize) -> Self {
        Self { force: vec![0.0; coordinates + multipliers], auxiliary: vec![0.0; coordinates] }
    }
}

/// Integral of the powers of loads, prescribed motions and flows.
///
/// Auxiliary powers as in [`DampingForces`], with the γ of second order: a motion at constant speed against damping
/// forces then supplies what they dissipate. For Newmark schemes this is the trapezoidal rule.
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub(crate) struct PowerIntegral {
    power: Power,
    auxiliary: Power,
}

impl PowerIntegral {
    /// Sets the power at a start.
    pub(crate) const fn new(power: Power) -> Self {
        Self { power, auxiliary: power }
    }

    /// Replaces the power by that of a state nearby. The difference of the auxiliary power remains.
    pub(crate) fn replace(&mut self, power: Power) {
        self.auxiliary.work += power.work - self.power.work;
        self.auxiliary.dissipation += power.dissipation - self.power.dissipation;
        self.power = power;
    }

    /// Returns work and dissipation of a step h and advances to the power at its end. `ratio` is the ratio to the last
    /// step size, `None` for the first step.
    pub(crate) fn advance(
        &mut self,
        scheme: SchemeCoefficients,
        ratio: Option<f64>,
        h: f64,
        next: Power,
    ) -> Power {
        let lead = scheme.lead();
        let part = |power: f64, auxiliary: f64, next: f64| {
            let start =
                ratio.map_or(power + lead * (next - power), |ratio| power + ratio * (auxiliary - power));
            let end = scheme.auxiliary(start, power, next);
            (h * ((0.5 + lead) * start + (0.5 - lead) * end), end)
        };
        let Self { power, auxiliary } = *self;
        let (work, work_end) = part(power.work, auxiliary.work, next.work);
        let (dissipation, dissipation_end) = part(power.dissipation, auxiliary.dissipation, next.dissipation);
        *self = Self { power: next, auxiliary: Power { work: work_end, dissipation: dissipation_end } };
        Power { work, dissipation }
    }

    /// Returns true if the powers are finite.
    pub(crate) fn is_valid(&self) -> bool {
        let Self { power, auxiliary } = self;
        [power.work, power.dissipation, auxiliary.work, auxiliary.dissipation].iter().all(|x| x.is_finite())
    }
}
