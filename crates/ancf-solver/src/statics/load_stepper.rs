use std::ops::ControlFlow;

use super::equilibrium::Equilibrium;
use crate::equations::{Energy, EquationsOfMotion, State};
use crate::newton::{Current, EquilibriumError, Failure, LineSearch, Newton, SolveError};
use crate::sparse::SparseMatrix;

/// Sizes of load increments, as parts of the way from the first load factor to the last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increments {
    /// What is tried first.
    pub first: f64,
    /// The least that is tried.
    pub smallest: f64,
    /// An increment that took at most so many iterations is followed by one twice as large.
    pub quick: u32,
    /// An equilibrium less stable than the one before it is refused after any larger increment than this: Newton's
    /// method finds unstable equilibria as readily as stable ones, the straight state of a buckling column first of all.
    pub trusted: f64,
}

impl Default for Increments {
    /// All at once; at least 2⁻²⁰, trusted from 2⁻¹⁶ on.
    fn default() -> Self {
        Self { first: 1.0, smallest: 0.5_f64.powi(20), quick: 12, trusted: 0.5_f64.powi(16) }
    }
}

/// Iterations without progress that are borne: a slender beam whose first increment stretched it takes about twenty.
const PATIENCE: u32 = 30;
/// Parts of the way closer than this to its end are its end.
const CLOSE: f64 = 1e-12;

/// Equilibrium under growing loads: r(q, λ, s) = 0 with v = a = 0, for load factors s from that of the start to a last one.
///
/// Each increment of s starts from the line through the last two equilibria and is solved by Newton's method with a line
/// search as a safeguard; one that fails is halved, quick ones are followed by larger ones. Past a load that has no
/// equilibrium near by, [`Path`](super::path::Path) leads.
#[derive(Debug)]
pub struct Statics<'a, E: EquationsOfMotion + ?Sized> {
    eom: Current<'a, E>,
    newton: Newton,
    increments: Increments,
    search: LineSearch,
    state: State,
    /// Number of unstable directions of the current state.
    unstable: Option<usize>,
    /// The equilibrium before the current one, if there was any.
    before: Option<State>,
    trial: State,
}

impl<'a, E: EquationsOfMotion> Statics<'a, E> {
    /// Starts from a state at or near equilibrium under its own load factor, such as that of rest with `load` = 0.
    ///
    /// Velocities and accelerations are set to zero. The start is taken to be stable.
    pub fn new(eom: &'a E, mut newton: Newton, increments: Increments, mut start: State) -> Self {
        start.v.fill(0.0);
        start.a.fill(0.0);
        newton.bear(PATIENCE);
        let search = LineSearch::new(&start);
        let (unstable, before, trial) = (Some(0), None, start.clone());
        Self { eom: Current::new(eom), newton, increments, search, state: start, unstable, before, trial }
    }

    /// The current state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Moves on to the load factor `to`; `each` sees every equilibrium on the way and may break there.
    ///
    /// Reports the last equilibrium and the iterations and attempts of all.
    ///
    /// # Errors
    /// If the smallest permitted increment fails; the state is then that of the last equilibrium.
    pub fn advance(
        &mut self,
        to: f64,
        mut each: impl FnMut(&State, &Equilibrium) -> ControlFlow<()>,
    ) -> Result<Equilibrium, EquilibriumError> {
        let (from, way) = (self.state.load, to - self.state.load);
        let (mut done, mut part) = (0.0, self.increments.first.max(self.increments.smallest));
        let (mut total, mut found) = (Equilibrium::default(), Equilibrium::default());
        loop {
            let next = if done + part > 1.0 - CLOSE { 1.0 } else { done + part };
            let load = if next == 1.0 { to } else { from + next * way };
            match self.attempt(load, next - done > self.increments.trusted) {
                Ok(last) => {
                    (total, found) = (total.after(last), found.after(last));
                    done = next;
                    if each(&self.state, &found).is_break() || done == 1.0 {
                        return Ok(total);
                    }
                    found = Equilibrium::default();
                    part *= if last.iterations <= self.increments.quick { 2.0 } else { 1.0 };
                }
                Err(cause) => {
                    total.failed(&cause);
                    found.failed(&cause);
                    part = 0.5 * (next - done);
                    if part < self.increments.smallest || way == 0.0 || cause.is_final() {
                        return Err(EquilibriumError { reached: self.state.load, load, cause });
                    }
                }
            }
        }
    }

    /// Finds the equilibrium at a load factor and makes it the current state.
    fn attempt(&mut self, load: f64, wary: bool) -> Result<Equilibrium, SolveError> {
        self.take_in()?;
        let mut found = Equilibrium::default();
        loop {
            self.predict(load);
            let Self { newton, search, eom, trial, .. } = self;
            found = found.again(Equilibrium::find(newton, search, &**eom, trial)?);
            let Some((eom, matrix)) = eom.completed(trial) else { break };
            // Something acts there that was not among the equations.
            self.renew(eom, matrix)?;
        }
        let lost = matches!((self.unstable, found.unstable), (Some(before), Some(now)) if now > before);
        if wary && lost {
            return Err(found.refuse(Failure::Unstable, &self.trial));
        }
        self.newton.met(found.energy.largest());
        let before = self.before.get_or_insert_with(|| self.state.clone());
        before.copy_from(&self.state);
        self.state.copy_from(&self.trial);
        self.unstable = found.unstable;
        Ok(found)
    }

    /// The energies of the current state.
    pub fn energy(&self) -> Energy {
        self.eom.energy(&self.state)
    }

    /// Takes in the terms that may soon act. To be called before the first look at the energy; increments do it by themselves.
    ///
    /// # Errors
    /// If memory does not suffice.
    pub fn take_in(&mut self) -> Result<(), SolveError> {
        match self.eom.ahead(&self.state) {
            Some((eom, matrix)) => self.renew(eom, matrix),
            None => Ok(()),
        }
    }

    fn renew(&mut self, eom: E, matrix: SparseMatrix) -> Result<(), SolveError> {
        self.eom.replace(eom);
        self.newton.adopt(matrix)
    }

    /// Sets the trial state on the line through the last two equilibria.
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
