use std::ops::ControlFlow;

use super::equilibrium::{Equilibrium, check_change};
use super::leave::leave;
use super::linear_response::{EquilibriumResponse, linear_response};
use crate::equations::{Energy, EquationsOfMotion, State};
use crate::newton::{ActiveSet, AdmissibleUpdate, EquilibriumError, Newton, SolveError, SolveFailure};

/// Sizes of load increments, relative to the interval between the first and the last load factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadIncrements {
    /// First increment.
    pub first: f64,
    /// Smallest permitted increment.
    pub smallest: f64,
    /// Largest permitted increment.
    pub largest: f64,
    /// Iteration count up to which the next increment is doubled.
    pub fast_iterations: u32,
    /// Largest increment after which a loss of stability is accepted.
    ///
    /// Newton's method also finds unstable equilibria, such as the straight state of a buckling column. After larger
    /// increments they are rejected.
    pub trusted: f64,
    /// Continuation after a loss of stability.
    pub unstable: UnstablePolicy,
}

/// Continuation of load increments after a loss of stability.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnstablePolicy {
    /// The analysis fails at the last stable equilibrium.
    Stop,
    /// The unstable branch is followed.
    #[default]
    Follow,
    /// The analysis continues on a stable branch in an unstable direction.
    Leave,
}

impl Default for LoadIncrements {
    /// A single increment, halved down to 2⁻²⁰, trusted from 2⁻¹⁶.
    fn default() -> Self {
        Self {
            first: 1.0,
            smallest: 0.5_f64.powi(20),
            largest: 1.0,
            fast_iterations: 12,
            trusted: 0.5_f64.powi(16),
            unstable: UnstablePolicy::Follow,
        }
    }
}

/// Stagnation limit. A slender beam that the first increment stretched takes about twenty iterations.
const STAGNATION_LIMIT: u32 = 30;
/// Rotation to which the next increment is limited, relative to the largest permitted one.
const PLANNED_ROTATION: f64 = 0.8;
/// Tolerance of the end of the interval, relative to its length.
const END_TOLERANCE: f64 = 1e-12;

/// Linear response K⁻¹ f of an equilibrium to small additional forces f; `None` if it is not accurate.
pub type Response<'a> = dyn FnMut(&[f64]) -> Option<Vec<f64>> + 'a;

/// Incremental-iterative solution of static equilibrium: r(q, λ, s) = 0 with v = a = 0 up to a final load factor s.
///
/// Each increment of s is predicted on the line through the last two equilibria. Newton's method corrects it, with
/// shorter increments where a state would be inadmissible. Failed increments are halved, and increments follow that double after fast convergence. An increment also
/// fails if a drive, a body or a section turns too far, or if a body passes through its contact partner
/// ([`EquationsOfMotion::rotation`], [`EquationsOfMotion::crossing`]): the equations are satisfied on both sides. Beyond a limit point, use [`ArcLength`](super::arc_length::ArcLength).
#[derive(Debug)]
pub struct LoadStepper<'a, E: EquationsOfMotion + ?Sized> {
    eom: ActiveSet<'a, E>,
    newton: Newton,
    increments: LoadIncrements,
    update: AdmissibleUpdate,
    state: State,
    /// Number of unstable directions of the current state.
    unstable: Option<usize>,
    /// Previous equilibrium.
    before: Option<State>,
    trial: State,
}

impl<'a, E: EquationsOfMotion> LoadStepper<'a, E> {
    /// Starts from a state at or near equilibrium under its load factor, such as the state at rest with `load` = 0.
    ///
    /// Velocities and accelerations are set to zero. The start is assumed to be stable.
    pub fn new(eom: &'a E, mut newton: Newton, increments: LoadIncrements, mut start: State) -> Self {
        start.stop();
        newton.set_stagnation_limit(STAGNATION_LIMIT);
        let update = AdmissibleUpdate::new(&start);
        let (unstable, before, trial) = (Some(0), None, start.clone());
        Self { eom: ActiveSet::new(eom), newton, increments, update, state: start, unstable, before, trial }
    }

    /// Returns the current state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Advances to the load factor `to`. `each` receives every equilibrium and may stop the analysis.
    ///
    /// Returns the last equilibrium with the iterations and attempts of all increments.
    ///
    /// # Errors
    /// If the smallest permitted increment fails. The state is then the last equilibrium.
    pub fn advance(
        &mut self,
        to: f64,
        mut each: impl FnMut(&State, &Equilibrium) -> ControlFlow<()>,
    ) -> Result<Equilibrium, EquilibriumError> {
        self.advance_with(to, |s, found, _| each(s, found))
    }

    /// Advances as [`advance`](Self::advance). `each` also receives the linear response of the equilibrium to small additional forces
    /// ([`into_response`](Self::into_response)).
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn advance_with(
        &mut self,
        to: f64,
        mut each: impl FnMut(&State, &Equilibrium, &mut Response<'_>) -> ControlFlow<()>,
    ) -> Result<Equilibrium, EquilibriumError> {
        let (from, way) = (self.state.load, to - self.state.load);
        let LoadIncrements { first, smallest, largest, .. } = self.increments;
        let (mut done, mut part) = (0.0, first.min(largest).max(smallest));
        let (mut total, mut found) = (Equilibrium::default(), Equilibrium::default());
        loop {
            let next = if done + part > 1.0 - END_TOLERANCE { 1.0 } else { done + part };
            let load = if next == 1.0 { to } else { from + next * way };
            let trusted = next - done <= self.increments.trusted;
            let accepted = trusted && self.increments.unstable != UnstablePolicy::Stop;
            match self.attempt(load, !accepted) {
                Ok((last, rotation)) => {
                    (total, found) = (total.followed_by(last), found.followed_by(last));
                    done = next;
                    let Self { newton, eom, state, .. } = self;
                    let mut response = |force: &[f64]| linear_response(newton, &**eom, state, force);
                    if each(state, &found, &mut response).is_break() || done == 1.0 {
                        return Ok(total);
                    }
                    found = Equilibrium::default();
                    let factor: f64 =
                        if last.iterations <= self.increments.fast_iterations { 2.0 } else { 1.0 };
                    part = (part * factor.min(PLANNED_ROTATION / rotation)).min(largest).max(smallest);
                }
                Err(cause) => {
                    total.failed(&cause);
                    found.failed(&cause);
                    part = 0.5 * (next - done);
                    if part < smallest || way == 0.0 || cause.is_final() {
                        return Err(EquilibriumError { reached: self.state.load, load, cause });
                    }
                }
            }
        }
    }

    /// Solves for the equilibrium at a load factor and makes it the current state. Returns also its largest rotation.
    fn attempt(&mut self, load: f64, check_stability: bool) -> Result<(Equilibrium, f64), SolveError> {
        self.include_near_terms()?;
        let mut found = Equilibrium::default();
        self.trial.copy_from(&self.state);
        self.trial.load = load;
        // Only prescribed rotations change with the load factor alone.
        check_change(&*self.eom, &found, &self.state, &self.trial)?;
        loop {
            self.predict(load);
            let Self { newton, update, eom, state, trial, .. } = self;
            newton.tangent.predict_stresses(state);
            let solution = Equilibrium::find(newton, update, &**eom, trial);
            newton.tangent.end_prediction();
            found = found.repeated(solution?);
            if !eom.include_active_terms(newton, trial)? {
                break;
            }
        }
        let rotation = check_change(&*self.eom, &found, &self.state, &self.trial)?;
        let lost = matches!((self.unstable, found.unstable), (Some(before), Some(now)) if now > before);
        if check_stability && lost {
            return Err(found.reject(SolveFailure::Unstable, &self.trial));
        }
        self.newton.record_energy(found.energy.largest());
        let before = self.before.get_or_insert_with(|| self.state.clone());
        before.copy_from(&self.state);
        self.state.copy_from(&self.trial);
        self.unstable = found.unstable;
        if lost && self.increments.unstable == UnstablePolicy::Leave {
            let left = leave(&mut self.eom, &mut self.newton, &mut self.update, &mut self.state)?;
            (found, self.unstable, self.before) = (found.repeated(left), left.unstable, None);
        }
        Ok((found, rotation))
    }

    /// Ends the analysis and returns the current equilibrium, whose linear response can still be computed.
    pub fn into_response(self) -> EquilibriumResponse<'a, E> {
        let Self { eom, mut newton, state, .. } = self;
        newton.tangent.discard_prediction();
        EquilibriumResponse::new(eom, newton, state)
    }

    /// Returns the energies of the current state.
    pub fn energy(&self) -> Energy {
        self.eom.energy(&self.state)
    }

    /// Includes the terms that may become active soon. Must be called before the first evaluation of the energy.
    ///
    /// Increments call it automatically.
    ///
    /// # Errors
    /// If the memory does not suffice.
    pub fn include_near_terms(&mut self) -> Result<(), SolveError> {
        self.eom.include_near_terms(&mut self.newton, &self.state).map(|_| ())
    }

    /// Predicts the trial state on the line through the last two equilibria.
    fn predict(&mut self, load: f64) {
        let Self { trial, state, before, .. } = self;
        trial.copy_from(state);
        trial.load = load;
        let Some(before) = before else { return };
        let part = (load - state.load) / (state.load - before.load);
        if !part.is_finite() {
            return;
        }
        let extrapolate = |trial: &mut [f64], now: &[f64], before: &[f64]| {
            for (trial, (now, before)) in trial.iter_mut().zip(now.iter().zip(before)) {
                *trial += part * (now - before);
            }
        };
        extrapolate(&mut trial.q, &state.q, &before.q);
        extrapolate(&mut trial.lambda, &state.lambda, &before.lambda);
    }
}
