use std::iter::repeat_n;
use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use super::error::{SolveError, SolveFailure};
use super::interrupt::Interrupt;
use super::iteration_progress::IterationProgress;
use super::rounding_errors::Iterate;
use super::rounding_floor::FLOOR;
use super::state_update::{FullUpdate, LinearSolution, StateUpdate};
use super::stopping::{NewtonReport, REMAINDER, StopRule, remainder_target};
use super::tangent::{NewtonTangent, TangentCheckpoint};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::sparse::SparseMatrix;
use crate::vectors::{dot, for_each_chunk, norm};

/// Newton's method with the exact tangent of the equations of motion, with its working storage.
///
/// [`TimeStepper`](crate::dynamics::TimeStepper) with the rule [`StopRule::Energy`] reuses a tangent while this costs less than a
/// new one. The absolute rules serve comparisons with other programs and use a new tangent in each iteration.
#[derive(Debug)]
pub struct Newton {
    stop: StopRule,
    max_iterations: u32,
    stagnation_limit: u32,
    new_tangents: bool,
    interrupt: Interrupt,
    pub(crate) tangent: NewtonTangent,
    pub(crate) r: Vec<f64>,
    pub(crate) z: Vec<f64>,
    floor: Vec<f64>,
    weights: Weights,
    /// Largest energy of the converged states so far.
    energy: f64,
    /// Energy of the first increment of the last solution.
    first: f64,
}

/// State of [`Newton`] on which later iterations depend.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct NewtonCheckpoint {
    energy: f64,
    tangent: TangentCheckpoint,
}

/// Energy of a system at rest, relative to that of rounding errors.
const REST: f64 = 1e-20;
/// Energy of an increment, relative to that of the state, below which the iteration may end at its rounding errors.
const SMALL: f64 = 1e-8;
/// Gap of the constraints, relative to the largest one of a solution, that may be a rounding error.
const REMAINING_GAP: f64 = 1e-6;
/// Default number of iterations without progress that counts as stagnation.
const STAGNATION_LIMIT: u32 = 3;

impl Newton {
    /// Creates a solver for equations whose tangents have the pattern of `matrix`.
    ///
    /// # Errors
    /// If the memory does not suffice for the factorisation.
    pub fn new(matrix: SparseMatrix, stop: StopRule, max_iterations: u32) -> Result<Self, SolveError> {
        let zeros = vec![0.0; matrix.pattern().size()];
        Ok(Self {
            stop,
            max_iterations,
            stagnation_limit: STAGNATION_LIMIT,
            new_tangents: false,
            interrupt: Interrupt::default(),
            tangent: NewtonTangent::new(matrix).map_err(SolveError::at_start)?,
            r: zeros.clone(),
            z: zeros.clone(),
            floor: zeros,
            weights: Weights::STIFFNESS,
            energy: 0.0,
            first: 0.0,
        })
    }

    /// Replaces the matrix by one of another pattern.
    ///
    /// # Errors
    /// If the memory does not suffice for the factorisation.
    pub(crate) fn replace_matrix(&mut self, matrix: SparseMatrix) -> Result<(), SolveError> {
        self.tangent.replace_matrix(matrix).map_err(SolveError::at_start)
    }

    /// Uses a new tangent in each iteration, also in time steps.
    #[must_use]
    pub fn with_new_tangents(self) -> Self {
        Self { new_tangents: true, ..self }
    }

    /// Sets the interrupt flag that stops the iteration.
    #[must_use]
    pub fn with_interrupt(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// Permits the reuse of tangents, if the stopping rule estimates the remaining error.
    pub(crate) fn permit_reuse(&mut self, s: &State) {
        if self.has_energy_rule() && !self.new_tangents {
            self.tangent.permit_reuse(s);
        }
    }

    /// States that new tangents are approximations: increments are first irregular and then decrease linearly.
    pub(crate) fn expect_linear_convergence(&mut self) {
        self.tangent.set_inexact();
        self.stagnation_limit = 2 * STAGNATION_LIMIT;
    }

    /// Adds the energy of a converged state to the reference energy of the energy rule.
    ///
    /// Before the first call the rule uses the energy of the current iterate.
    pub fn record_energy(&mut self, energy: f64) {
        self.energy = self.energy.max(energy);
    }

    /// Returns true if the iteration stops by the energies of its increments.
    pub(crate) fn has_energy_rule(&self) -> bool {
        matches!(self.stop, StopRule::Energy(_))
    }

    /// Returns the energy of the first increment of the last solution, relative to the largest energy of the converged states so far.
    ///
    /// It is the energy of the error of the state from which the iteration started.
    pub(crate) fn start_error(&self) -> f64 {
        self.first / self.energy
    }

    /// Returns zᵀ K z with the last tangent K, for an increment z of n coordinates.
    pub(crate) fn energy_of(&mut self, n: usize, z: impl Fn(usize) -> f64) -> f64 {
        let (of_coordinates, of_multipliers) = self.z.split_at_mut(n);
        of_coordinates.iter_mut().enumerate().for_each(|(i, own)| *own = z(i));
        of_multipliers.fill(0.0);
        self.tangent.factor.energy(&self.tangent.matrix, &self.z)
    }

    /// Returns the energy of rounding errors: Σ (Kᵢᵢ/w_q) (8ε)² with the last tangent K and a unit size of the coordinates.
    ///
    /// A system at rest without loads moves by its rounding errors, and its dampers dissipate their energy.
    pub(crate) fn rounding_energy(&self) -> f64 {
        self.tangent.error_energy(self.weights, repeat_n(FLOOR * f64::EPSILON, self.z.len()))
    }

    /// Returns true if all states so far and an energy have no motion: displacements below 1e-10 of their rounding errors.
    fn is_at_rest(&self, energy: f64) -> bool {
        self.energy.max(energy) <= REST * self.rounding_energy()
    }

    /// Returns the state on which later iterations depend, as of the last accepted step.
    pub(crate) fn checkpoint(&self) -> NewtonCheckpoint {
        NewtonCheckpoint { energy: self.energy, tangent: self.tangent.checkpoint() }
    }

    /// Resumes from a saved state.
    pub(crate) fn restore(
        &mut self,
        eom: &dyn EquationsOfMotion,
        checkpoint: &NewtonCheckpoint,
    ) -> Result<(), SolveError> {
        self.energy = checkpoint.energy;
        self.tangent.restore(eom, &checkpoint.tangent).map_err(SolveError::at_start)
    }

    /// Returns true if a saved state is valid for this solver.
    pub(crate) fn accepts(
        &self,
        checkpoint: &NewtonCheckpoint,
        coordinates: usize,
        multipliers: usize,
    ) -> bool {
        let NewtonCheckpoint { energy, tangent } = checkpoint;
        energy.is_finite() && self.tangent.accepts(tangent, coordinates, multipliers)
    }

    /// Sets the number of iterations without progress that counts as stagnation.
    pub(crate) fn set_stagnation_limit(&mut self, stagnation_limit: u32) {
        self.stagnation_limit = stagnation_limit;
    }

    /// Iterates a state until r(s) = 0. The weights `w` map increments to the state.
    ///
    /// Each iteration solves [w_q ∂r/∂q + .. + w_a M, Φ_qᵀ; Φ_q, 0] (dz, dλ) = −(r, Φ/w_q). The constraints are those
    /// of Kim et al. (2017), eq. (38), divided by w_q. The matrix is then symmetric and its condition bounded as h → 0.
    ///
    /// # Errors
    /// If the matrix is singular or the iteration does not converge. The state is then undefined.
    pub fn solve(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
    ) -> Result<NewtonReport, SolveError> {
        self.solve_with(&mut FullUpdate, eom, s, w)
    }

    /// Iterates a state until r(s) = 0, with a given update rule.
    pub(crate) fn solve_with(
        &mut self,
        update: &mut dyn StateUpdate,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
    ) -> Result<NewtonReport, SolveError> {
        let mut progress = IterationProgress::default();
        self.weights = w;
        self.z.fill(0.0);
        self.tangent.begin(w);
        loop {
            eom.residual(s, &mut self.r);
            progress.report.residual = norm(&self.r);
            if let ControlFlow::Break(end) = self.check_residual(eom, s, &progress) {
                return end.map_err(|failure| self.error(failure, eom, s, progress.report));
            }
            let energy = self
                .increment(update, eom, s, w, &mut progress.report)
                .map_err(|failure| self.error(failure, eom, s, progress.report))?;
            if let ControlFlow::Break(end) = self.check_increment(eom, s, energy, &mut progress) {
                end.iter().for_each(|done| self.tangent.end(done.iterations));
                return end.map_err(|failure| self.error(failure, eom, s, progress.report));
            }
        }
    }

    /// Applies one Newton increment to the state. Returns its energy |Δq·r| + |Δλ·Φ|.
    fn increment(
        &mut self,
        update: &mut dyn StateUpdate,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
        report: &mut NewtonReport,
    ) -> Result<f64, SolveFailure> {
        let n = s.q.len();
        loop {
            self.tangent.prepare(eom, s, w)?;
            let (of_coordinates, of_multipliers) = self.z.split_at_mut(n);
            for_each_chunk(of_coordinates, |range, z| {
                z.iter_mut().zip(&self.r[range]).for_each(|(z, r)| *z = -r);
            });
            of_multipliers.iter_mut().zip(&self.r[n..]).for_each(|(z, r)| *z = -r / w.q);
            self.tangent.solve(eom, s, w, &mut self.z)?;
            if !self.tangent.changes_tension(eom, s, &self.z) {
                break;
            }
        }
        let Self { tangent: NewtonTangent { matrix, factor, .. }, z, .. } = self;
        update.apply(LinearSolution { eom, matrix, factor, z }, s, w)?;
        report.iterations += 1;
        report.increment = w.q * norm(&self.z[..n]);
        Ok(w.q * dot(&self.z[..n], &self.r[..n]).abs() + dot(&self.z[n..], &self.r[n..]).abs())
    }

    /// True in motions, and in statics if the energy of the last increment is small compared with that of the state.
    ///
    /// The residual of an iterate has rounding errors in proportion to the increment that led to it. A slender body may
    /// have large increments with a residual below these errors, far from any equilibrium.
    fn is_small(&self, eom: &dyn EquationsOfMotion, s: &State, progress: &IterationProgress) -> bool {
        let is_small = |last| last <= SMALL * self.energy.max(eom.energy(s).largest());
        !self.weights.is_static() || progress.last.is_some_and(is_small)
    }

    /// Ends the iteration if the residual is small enough, at its rounding floor or not finite, or on interrupt.
    fn check_residual(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        progress: &IterationProgress,
    ) -> ControlFlow<Result<NewtonReport, SolveFailure>> {
        let report = progress.report;
        if self.interrupt.is_set() {
            return ControlFlow::Break(Err(SolveFailure::Interrupted));
        }
        if !report.residual.is_finite() {
            return ControlFlow::Break(Err(SolveFailure::Diverged));
        }
        if matches!(self.stop, StopRule::Residual(tolerance) if report.residual <= tolerance) {
            return ControlFlow::Break(Ok(report));
        }
        let is_last = report.iterations >= self.max_iterations;
        let is_settled = !self.weights.is_static() || progress.is_settled(norm(&s.q));
        let is_floor =
            progress.stagnant > 0 && self.is_small(eom, s, progress) && self.at(eom, s).excess().1 <= FLOOR;
        // Without an energy of a motion, increments may decrease without limit or vary randomly.
        let may_be_zero = progress.stagnant > 0 || is_last || progress.is_exhausted();
        let largest = self.energy;
        let is_zero = |newton: &mut Self| {
            newton.at(eom, s).is_rounding(largest)
                || newton.at(eom, s).is_increment_of_rounding(progress.recent())
        };
        let is_at_rest = |newton: &Self| {
            progress.last.is_some_and(|last| newton.is_at_rest(last.max(eom.energy(s).largest())))
        };
        // The energy does not see motions without forces. In statics their gaps close until they are rounding errors. A gap that
        // remains as it was is none: the increments do not solve the equations.
        let gap = norm(&self.r[s.q.len()..]);
        let is_closed = |newton: &mut Self| {
            let is_least = |least| gap >= 0.5 * least && gap <= REMAINING_GAP * progress.widest;
            progress.gap.is_none_or(is_least) || newton.at(eom, s).has_closed_gaps()
        };
        let is_done = is_floor || (may_be_zero && (is_at_rest(self) || is_zero(self)) && is_closed(self));
        if is_settled && is_done {
            return ControlFlow::Break(Ok(NewtonReport { floor: true, ..report }));
        }
        if progress.stagnant >= self.stagnation_limit {
            return ControlFlow::Break(Err(SolveFailure::Stagnated));
        }
        if is_last {
            return ControlFlow::Break(Err(SolveFailure::NotConverged));
        }
        ControlFlow::Continue(())
    }

    /// Ends the iteration if the increment is small enough, and counts iterations without progress.
    fn check_increment(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        energy: f64,
        progress: &mut IterationProgress,
    ) -> ControlFlow<Result<NewtonReport, SolveFailure>> {
        let is_static = self.weights.is_static();
        if is_static {
            let gap = norm(&self.r[s.q.len()..]);
            progress.gap = Some(progress.gap.map_or(gap, |least| least.min(gap)));
            progress.widest = progress.widest.max(gap);
        }
        match self.stop {
            StopRule::Energy(tolerance) => {
                // The energy of an iterate is no reference in motions: in large steps of stiff beams it far exceeds the energy
                // of the motion. In statics the states so far may be without load, and their energy that of rounding errors.
                let is_motion = self.energy > 0.0 && !is_static;
                let largest = if is_motion { self.energy } else { self.energy.max(eom.energy(s).largest()) };
                let (size, expected) = (energy.sqrt(), tolerance * largest.sqrt());
                let first = *progress.first.get_or_insert(energy);
                self.first = first;
                let mut remainder = remainder_target(expected, first.sqrt(), largest.sqrt());
                self.tangent.record(progress.rate(energy));
                let left = self.tangent.remainder(size);
                if is_motion && left > remainder && left <= REMAINDER * expected {
                    // Increments of a system at rest are rounding errors of its coordinates, without a rate.
                    let rounding = s.q.iter().map(|q| f64::EPSILON * q);
                    let rounding = self.tangent.error_energy(self.weights, rounding).sqrt();
                    remainder = remainder.max(rounding.min(REMAINDER * expected));
                }
                if size <= expected && self.tangent.remainder(size) <= remainder {
                    // In statics the energy does not depend on motions without forces, for any gaps of the constraints.
                    if (size > 0.0 && !is_static) || self.at(eom, s).has_closed_gaps() {
                        return ControlFlow::Break(Ok(progress.report));
                    } else if size > 0.0 || progress.report.increment == 0.0 {
                        progress.record(energy);
                    }
                    return ControlFlow::Continue(());
                }
                if !self.tangent.plan_iteration(remainder / size) {
                    return ControlFlow::Break(Err(SolveFailure::Stagnated));
                }
                progress.record(energy);
            }
            StopRule::Increment(tolerance) if progress.report.increment <= tolerance => {
                return ControlFlow::Break(Ok(progress.report));
            }
            // The absolute rules have no rounding floor. Near the rounding error the iterates vary randomly until a
            // residual is small enough, as in Kim et al. (2017), fig. 7.
            StopRule::Increment(_) | StopRule::Residual(_) => {}
        }
        ControlFlow::Continue(())
    }

    /// Iterate in a state, with the last residual, increment and tangent.
    fn at<'a>(&'a mut self, eom: &'a dyn EquationsOfMotion, s: &'a State) -> Iterate<'a> {
        let Self { tangent, r, z, floor, weights, .. } = self;
        Iterate { eom, s, r, z, weights: *weights, tangent, floor }
    }

    fn error(
        &mut self,
        failure: SolveFailure,
        eom: &dyn EquationsOfMotion,
        s: &State,
        last: NewtonReport,
    ) -> SolveError {
        SolveError::after(last, s.t, failure, self.at(eom, s).excess().0)
    }
}
