use std::ops::ControlFlow;

use serde::{Deserialize, Serialize};

use super::error::{Failure, SolveError};
use super::interrupt::Interrupt;
use super::line_search::{Linear, Mover, Whole, dot};
use super::report::Report;
use super::rounding_floor::raise_to_achievable;
use super::tangent::{Tangent, TangentMemory};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::sparse::SparseMatrix;

/// When a Newton iteration ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// The energy of the increment, |Δq·r| + |Δλ·Φ|, is at most tolerance² times the largest energy met, or the
    /// residual is down to its own rounding error.
    ///
    /// The products are free of units, of the choice of slope coordinates and of the frame of reference: iterations in
    /// any of them end alike. Newton's method converges quadratically, so the error left behind is far below the
    /// tolerance, which is relative to the size of the motion in the energy norm. Where tangents are used again increments
    /// fall by a rate θ, and what they leave, θ/(1 − θ) times the last one, has to be at most a thousandth of the tolerance.
    Energy(f64),
    /// |r|₂ is at most this number, forces and constraints alike. Depends on units.
    Residual(f64),
    /// |Δq|₂ is at most this number. Depends on units.
    Increment(f64),
}

/// Newton's method with the exact tangent for equations of motion, with its working storage.
///
/// In [`Dynamics`](crate::dynamics::Dynamics) under the rule [`Stop::Energy`] a tangent is used again as long as this is cheaper than
/// a new one; the rules of absolute numbers, which are there to compare with others, get a new one in each iteration.
#[derive(Debug)]
pub struct Newton {
    stop: Stop,
    max_iterations: u32,
    patience: u32,
    full: bool,
    interrupt: Interrupt,
    pub(crate) tangent: Tangent,
    pub(crate) r: Vec<f64>,
    pub(crate) z: Vec<f64>,
    floor: Vec<f64>,
    weights: Weights,
    /// The largest energy of the converged states met.
    energy: f64,
}

/// What the further iterations of [`Newton`] depend on.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct NewtonMemory {
    energy: f64,
    tangent: TangentMemory,
}

/// A residual within this many times its rounding bound cannot be told from zero.
const FLOOR: f64 = 8.0;
/// What increments leave may be so much of the tolerance.
const NEAR: f64 = 1e-3;
/// So many iterations without progress are a stagnation, unless more patience is asked for.
const STUCK: u32 = 3;

impl Newton {
    /// A solver for equations whose tangents have the pattern of `matrix`.
    ///
    /// # Errors
    /// If memory does not suffice for the factorisation.
    pub fn new(matrix: SparseMatrix, stop: Stop, max_iterations: u32) -> Result<Self, SolveError> {
        let zeros = vec![0.0; matrix.pattern().size()];
        Ok(Self {
            stop,
            max_iterations,
            patience: STUCK,
            full: false,
            interrupt: Interrupt::default(),
            tangent: Tangent::new(matrix).map_err(SolveError::at_start)?,
            r: zeros.clone(),
            z: zeros.clone(),
            floor: zeros,
            weights: Weights::STIFFNESS,
            energy: 0.0,
        })
    }

    /// Takes a matrix of another pattern in the place of its own.
    ///
    /// # Errors
    /// If memory does not suffice for the factorisation.
    pub(crate) fn adopt(&mut self, matrix: SparseMatrix) -> Result<(), SolveError> {
        self.tangent.adopt(matrix).map_err(SolveError::at_start)
    }

    /// The same with a new tangent in each iteration, also in steps of time.
    #[must_use]
    pub fn full(self) -> Self {
        Self { full: true, ..self }
    }

    /// The same, heeding what may end it.
    #[must_use]
    pub fn heeding(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// Lets tangents be used again, if the rule for the end of the iteration knows what is left.
    pub(crate) fn reuse(&mut self, s: &State) {
        if matches!(self.stop, Stop::Energy(_)) && !self.full {
            self.tangent.reuse(s);
        }
    }

    /// Tells the energy rule of an energy that a converged state has; before that the rule goes by the iterate's own.
    pub fn met(&mut self, energy: f64) {
        self.energy = self.energy.max(energy);
    }

    /// What its further iterations depend on, as of the last accepted step.
    pub(crate) fn memory(&self) -> NewtonMemory {
        NewtonMemory { energy: self.energy, tangent: self.tangent.memory() }
    }

    /// Goes on from a memory.
    pub(crate) fn recall(
        &mut self,
        eom: &dyn EquationsOfMotion,
        memory: &NewtonMemory,
    ) -> Result<(), SolveError> {
        self.energy = memory.energy;
        self.tangent.recall(eom, &memory.tangent).map_err(SolveError::at_start)
    }

    /// Whether a memory is one of such a solver.
    pub(crate) fn knows(&self, memory: &NewtonMemory, coordinates: usize, multipliers: usize) -> bool {
        let NewtonMemory { energy, tangent } = memory;
        energy.is_finite() && self.tangent.knows(tangent, coordinates, multipliers)
    }

    /// Bears so many iterations without progress before it calls them a stagnation.
    pub(crate) fn bear(&mut self, patience: u32) {
        self.patience = patience;
    }

    /// Iterates a state until r(s) = 0, moving it by `w`.
    ///
    /// One iteration solves [w_q ∂r/∂q + .. + w_a M, Φ_qᵀ; Φ_q, 0] (dz, dλ) = −(r, Φ/w_q): the constraints are those of
    /// Kim et al. (2017), eq. (38), divided by w_q, which makes the matrix symmetric and its condition bounded as h → 0.
    ///
    /// # Errors
    /// If the matrix is singular or the iteration does not end; the state is then of no use.
    pub fn solve(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
    ) -> Result<Report, SolveError> {
        self.solve_by(&mut Whole, eom, s, w)
    }

    /// The same, with another way of moving the state by an increment.
    pub(crate) fn solve_by(
        &mut self,
        mover: &mut dyn Mover,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
    ) -> Result<Report, SolveError> {
        let mut progress = Progress::default();
        self.weights = w;
        self.z.fill(0.0);
        self.tangent.begin(w);
        loop {
            eom.residual(s, &mut self.r);
            progress.report.residual = norm(&self.r);
            if let ControlFlow::Break(end) = self.judge_residual(eom, s, &progress) {
                return end.map_err(|failure| self.error(failure, eom, s, progress.report));
            }
            let energy = self
                .increment(mover, eom, s, w, &mut progress.report)
                .map_err(|failure| self.error(failure, eom, s, progress.report))?;
            if let ControlFlow::Break(end) = self.judge_increment(eom, s, energy, &mut progress) {
                end.iter().for_each(|done| self.tangent.end(done.iterations));
                return end.map_err(|failure| self.error(failure, eom, s, progress.report));
            }
        }
    }

    /// One Newton increment of the state; returns its energy |Δq·r| + |Δλ·Φ|.
    fn increment(
        &mut self,
        mover: &mut dyn Mover,
        eom: &dyn EquationsOfMotion,
        s: &mut State,
        w: Weights,
        report: &mut Report,
    ) -> Result<f64, Failure> {
        let n = s.q.len();
        self.tangent.prepare(eom, s, w)?;
        for (i, (z, r)) in self.z.iter_mut().zip(&self.r).enumerate() {
            *z = if i < n { -r } else { -r / w.q };
        }
        let Self { tangent: Tangent { matrix, factor, .. }, r, z, .. } = self;
        factor.solve_increment(matrix, z, &s.lambda).map_err(|_| Failure::Singular)?;
        mover.go(Linear { eom, matrix, factor, r, z }, s, w)?;
        report.iterations += 1;
        report.increment = w.q * norm(&self.z[..n]);
        Ok(w.q * dot(&self.z[..n], &self.r[..n]).abs() + dot(&self.z[n..], &self.r[n..]).abs())
    }

    /// Negative eigenvalues of the matrix that was factorised last, less the one that each multiplier brings: in statics
    /// the number of unstable directions. `None` if the factors do not tell.
    pub(crate) fn unstable(&self, eom: &dyn EquationsOfMotion) -> Option<usize> {
        self.tangent.factor.negative_pivots()?.checked_sub(eom.multipliers())
    }

    /// Ends the iteration on a residual that is small enough, at its floor, or not finite, or from outside.
    fn judge_residual(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        progress: &Progress,
    ) -> ControlFlow<Result<Report, Failure>> {
        let report = progress.report;
        if self.interrupt.is_set() {
            return ControlFlow::Break(Err(Failure::Interrupted));
        }
        if !report.residual.is_finite() {
            return ControlFlow::Break(Err(Failure::Diverged));
        }
        if matches!(self.stop, Stop::Residual(tolerance) if report.residual <= tolerance) {
            return ControlFlow::Break(Ok(report));
        }
        if progress.stuck > 0 && self.excess(eom, s).1 <= FLOOR {
            return ControlFlow::Break(Ok(Report { floor: true, ..report }));
        }
        if progress.stuck >= self.patience {
            return ControlFlow::Break(Err(Failure::Stagnated));
        }
        if report.iterations >= self.max_iterations {
            return ControlFlow::Break(Err(Failure::NotConverged));
        }
        ControlFlow::Continue(())
    }

    /// Ends the iteration on an increment that is small enough; takes note of a lack of progress.
    fn judge_increment(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        energy: f64,
        progress: &mut Progress,
    ) -> ControlFlow<Result<Report, Failure>> {
        match self.stop {
            Stop::Energy(tolerance) => {
                // Energies of increments do not count: those of a stiff beam in a large step dwarf any that the motion has.
                let largest = if self.energy > 0.0 { self.energy } else { eom.energy(s).largest() };
                let (size, wanted) = (energy.sqrt(), tolerance * largest.sqrt());
                self.tangent.note(progress.rate(energy));
                if size <= wanted && self.tangent.left(size) <= NEAR * wanted {
                    return ControlFlow::Break(Ok(progress.report));
                }
                if !self.tangent.foresee(NEAR * wanted / size) {
                    return ControlFlow::Break(Err(Failure::Stagnated));
                }
                progress.note(energy);
            }
            Stop::Increment(tolerance) if progress.report.increment <= tolerance => {
                return ControlFlow::Break(Ok(progress.report));
            }
            // The absolute rules mean what they say: near the rounding error they wander until a residual happens to
            // be small enough, which is what Kim et al. (2017), fig. 7, show.
            Stop::Increment(_) | Stop::Residual(_) => {}
        }
        ControlFlow::Continue(())
    }

    /// The equation whose residual is the largest multiple of what the arithmetic can reach, and that multiple.
    fn excess(&mut self, eom: &dyn EquationsOfMotion, s: &State) -> (usize, f64) {
        eom.rounding(s, &mut self.floor);
        raise_to_achievable(&self.tangent.matrix, &s.q, &self.z, self.weights, &mut self.floor);
        let mut worst = (0, 0.0);
        for (i, (r, floor)) in self.r.iter().zip(&self.floor).enumerate() {
            let excess = if *r == 0.0 { 0.0 } else { r.abs() / floor };
            if excess > worst.1 || excess.is_nan() {
                worst = (i, excess);
            }
        }
        worst
    }

    fn error(
        &mut self,
        failure: Failure,
        eom: &dyn EquationsOfMotion,
        s: &State,
        last: Report,
    ) -> SolveError {
        SolveError::after(last, s.t, failure, self.excess(eom, s).0)
    }
}

/// The course of one iteration.
#[derive(Default)]
struct Progress {
    report: Report,
    /// The smallest energy of an increment so far.
    least: Option<f64>,
    /// That of the last one.
    last: Option<f64>,
    /// Consecutive iterations that did not halve it.
    stuck: u32,
}

impl Progress {
    /// θ, by which the last increment is smaller than the one before, both in the norm whose square is the energy.
    fn rate(&self, energy: f64) -> Option<f64> {
        self.last.map(|last| (energy / last).sqrt())
    }

    fn note(&mut self, energy: f64) {
        let stuck = self.least.is_some_and(|least| energy > 0.5 * least);
        self.stuck = if stuck { self.stuck + 1 } else { 0 };
        self.last = Some(energy);
        self.least = Some(self.least.map_or(energy, |least| least.min(energy)));
    }
}

fn norm(x: &[f64]) -> f64 {
    dot(x, x).sqrt()
}
