use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::error::SolveFailure;
use super::stress_prediction::StressPrediction;
use super::tangent_usage::{TangentAge, TangentPolicy, TangentUsage};
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, FactorHistory, solve_with_skew_part};
use crate::sparse::SparseMatrix;

/// Factorised tangent of Newton's method with the policy of its reuse.
///
/// In time integration the tangent is reused in later iterations and steps while this costs less than a new tangent.
/// An iteration with an old tangent is a fixed-point iteration with the convergence rate θ. The rate predicts the
/// number of remaining iterations.
///
/// * Within a step, a new tangent is computed if it costs less than the remaining iterations.
/// * Before a step, a new tangent is computed if the extra iterations since the last one exceed its cost.
/// * Tangents age within a step in fast rotations. A number of steps then starts with new tangents, and each further
///   failure of an old tangent doubles this number.
///
/// Source: Hairer & Wanner (1996), section IV.8; Deuflhard (2011), section 2.1, for the rate as a monitor.
#[derive(Debug)]
pub(crate) struct NewtonTangent {
    pub(crate) matrix: SparseMatrix,
    pub(crate) factor: Factor,
    usage: TangentUsage,
    /// Usage as of the last accepted step.
    saved: TangentUsage,
    /// States of the computed tangents, if reuse is permitted.
    made: Option<Box<TangentStates>>,
    /// False if new tangents are approximations, so that iterations converge linearly.
    exact: bool,
    /// Cost of a new factorised tangent, in iterations with an old one.
    renewal_cost: u32,
    /// Number of tangents of the current solution.
    computed: u32,
    /// Predicted stresses of the tangents in statics.
    prediction: Option<StressPrediction>,
}

/// States at which tangents were computed.
#[derive(Debug)]
struct TangentStates {
    now: State,
    /// State of the tangent at the last accepted step, if there is a newer tangent.
    saved: State,
    is_new: bool,
}

/// Saved state of a tangent. The factors are large, so they are not saved but computed again.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct TangentCheckpoint {
    usage: TangentUsage,
    /// State at which the tangent was computed, if it is reusable.
    made: Option<State>,
}

/// Cost of a new factorised tangent of a chain, in iterations with an old one.
const CHAIN_COST: u32 = 3;
/// Number of unknowns below which the evaluation of the terms determines the cost. It is then that of a chain.
const SMALL: usize = 500;
/// Smallest and largest cost in other structures. Larger ones changed measured times by a few percent only.
const RENEWAL_COST: [f64; 2] = [6.0, 10.0];
/// Rate of an approximate tangent below which it is kept, and above which it is renewed.
const FAST: f64 = 0.05;
const SLOW: f64 = 0.6;
/// Number of approximate tangents of a solution after which they are renewed only if they converge slowly.
const APPROXIMATIONS: u32 = 3;
/// Relative difference of weights up to which a tangent is reusable.
const WEIGHT_TOLERANCE: f64 = 1e-2;
/// Longest pause of the reuse.
const MAX_PAUSE: u32 = 64;

/// Estimates the cost of a new factorised tangent, in iterations with an old one, by the products of factorisation and substitution.
///
/// The evaluation of the terms adds to both in similar proportions, as measured on chains, nets, lattices and plates.
fn renewal_cost(matrix: &SparseMatrix) -> u32 {
    let (cost, [least, most]) = (matrix.pattern().supernodes().factor_cost(), RENEWAL_COST);
    if matrix.pattern().size() < SMALL || cost < least { CHAIN_COST } else { cost.min(most) as u32 }
}

impl NewtonTangent {
    /// Creates storage for tangents with the pattern of `matrix`, with a new tangent in each iteration.
    pub(crate) fn new(matrix: SparseMatrix) -> Result<Self, SolveFailure> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| SolveFailure::Memory)?;
        let (usage, renewal_cost) = (TangentUsage::new(), renewal_cost(&matrix));
        Ok(Self {
            matrix,
            factor,
            usage,
            saved: usage,
            made: None,
            exact: true,
            renewal_cost,
            computed: 0,
            prediction: None,
        })
    }

    /// Replaces the matrix by one of other equations. The storage of an equal pattern is kept.
    pub(crate) fn replace_matrix(&mut self, matrix: SparseMatrix) -> Result<(), SolveFailure> {
        if !Arc::ptr_eq(matrix.pattern(), self.matrix.pattern()) {
            self.factor = Factor::new(matrix.pattern()).map_err(|_| SolveFailure::Memory)?;
            self.renewal_cost = renewal_cost(&matrix);
            self.matrix = matrix;
        }
        let TangentUsage { policy, pause, last_pause, .. } = self.usage;
        self.usage = TangentUsage { policy, pause, last_pause, ..TangentUsage::new() };
        Ok(())
    }

    /// Permits the reuse of tangents, except with redundant constraints, which are consistent only along the exact
    /// tangent.
    pub(crate) fn permit_reuse(&mut self, s: &State) {
        if !self.matrix.pattern().has_shared_multipliers() {
            self.usage.policy = TangentPolicy::WhenDue;
            self.made = Some(Box::new(TangentStates { now: s.clone(), saved: s.clone(), is_new: false }));
        }
    }

    /// States that new tangents are approximations.
    pub(crate) fn set_inexact(&mut self) {
        self.exact = false;
    }

    /// Starts a static solution from an equilibrium. Its tangents have predicted stresses.
    pub(crate) fn predict_stresses(&mut self, from: &State) {
        self.prediction.get_or_insert_with(|| StressPrediction::new(from)).start(from);
    }

    /// Adds a tension to cables that the first increment of a static solution turns too far, or changes it. Returns true if the
    /// increment has to be computed again with a new tangent.
    pub(crate) fn changes_tension(&mut self, eom: &dyn EquationsOfMotion, s: &State, z: &[f64]) -> bool {
        self.prediction.as_mut().is_some_and(|prediction| prediction.choose_least_strain(eom, s, z))
    }

    /// Ends a static solution. Later tangents have the stresses of the iterate.
    pub(crate) fn end_prediction(&mut self) {
        self.prediction.iter_mut().for_each(StressPrediction::end);
    }

    /// Frees the memory of the prediction.
    pub(crate) fn discard_prediction(&mut self) {
        self.prediction = None;
    }

    /// Returns true if the reuse of tangents is permitted.
    pub(crate) fn is_reusable(&self) -> bool {
        self.usage.policy != TangentPolicy::Always
    }

    /// Requests a new tangent for the next iteration.
    pub(crate) fn renew(&mut self) {
        self.usage.weights = None;
    }

    /// Requests newer tangents after a failed solution. Returns true if a repetition may succeed.
    pub(crate) fn request_newer(&mut self) -> bool {
        self.renew();
        match (self.usage.reused, self.usage.age) {
            (true, TangentAge::Old) => self.extend_pause(),
            (true, _) => self.usage.policy = TangentPolicy::AlwaysInSolution,
            (false, _) => self.reset_policy(),
        }
        self.usage.reused
    }

    /// Lends the matrix and the factor for another use. The next iteration needs a new tangent.
    pub(crate) fn lend(&mut self) -> (&mut SparseMatrix, &mut Factor) {
        self.renew();
        (&mut self.matrix, &mut self.factor)
    }

    /// Starts a solution with the given weights.
    pub(crate) fn begin(&mut self, w: Weights) {
        let alike = |own: f64, other: f64| (own - other).abs() <= WEIGHT_TOLERANCE * other.abs();
        let fits = |own: Weights| alike(own.q, w.q) && alike(own.v, w.v) && alike(own.a, w.a);
        let due = self.usage.extra_iterations >= self.renewal_cost || self.usage.pause > 0;
        self.usage.pause = self.usage.pause.saturating_sub(1);
        self.usage.weights = self.usage.weights.filter(|own| fits(*own) && !due);
        self.usage.age = TangentAge::Old;
        self.computed = 0;
        self.usage.solutions += 1;
        self.usage.reused = false;
    }

    /// Ends a converged solution.
    pub(crate) fn end(&mut self, iterations: u32) {
        self.usage.fewest_iterations = self.usage.fewest_iterations.min(iterations);
        self.usage.extra_iterations += iterations - self.usage.fewest_iterations;
        if self.usage.age == TangentAge::Old {
            self.usage.last_pause /= 2;
        }
        self.reset_policy();
    }

    /// Resets the policy of the current solution.
    fn reset_policy(&mut self) {
        if self.usage.policy == TangentPolicy::AlwaysInSolution {
            self.usage.policy = TangentPolicy::WhenDue;
        }
    }

    /// Computes and factorises the tangent at a state, unless an old one is reusable.
    pub(crate) fn prepare(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        w: Weights,
    ) -> Result<(), SolveFailure> {
        if self.usage.weights.is_some() {
            self.usage.reused = true;
            self.usage.age =
                if self.usage.age == TangentAge::Old { TangentAge::Old } else { TangentAge::Solution };
            return Ok(());
        }
        let Self { matrix, factor, prediction, .. } = self;
        let is_predicted = match prediction {
            Some(prediction) => prediction.factorise(eom, s, (matrix, factor)),
            None => false,
        };
        if !is_predicted {
            eom.tangent(s, w, matrix);
            factor.factorise(matrix).map_err(|_| SolveFailure::Singular)?;
        }
        self.computed += 1;
        self.made.iter_mut().for_each(|made| made.record(s));
        self.usage.weights = Some(w).filter(|_| self.usage.policy == TangentPolicy::WhenDue);
        self.usage.age = TangentAge::Iteration;
        (self.usage.rate, self.usage.fewest_iterations, self.usage.extra_iterations) = (None, u32::MAX, 0);
        (self.usage.solutions, self.usage.rated) = (0, 0);
        Ok(())
    }

    /// Solves for an increment with the last factors. In statics the stiffness includes its skew part, of loads without a potential:
    /// the iteration does not converge where this part is larger than the symmetric one.
    pub(crate) fn solve(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        w: Weights,
        z: &mut [f64],
    ) -> Result<(), SolveFailure> {
        let Self { matrix, factor, .. } = self;
        let mut solve = |x: &mut [f64]| factor.solve_increment(matrix, x, &s.lambda);
        let solved = if w.is_static() {
            solve_with_skew_part(&eom.skew_stiffness(s), z, &mut solve).map(|_| ())
        } else {
            solve(z)
        };
        solved.map_err(|_| SolveFailure::Singular)
    }

    /// Records the rate θ of the last two increments of a solution.
    pub(crate) fn record(&mut self, rate: Option<f64>) {
        if (self.usage.age != TangentAge::Iteration || !self.exact) && rate.is_some() {
            (self.usage.rate, self.usage.rated) = (rate, self.usage.solutions);
        }
    }

    /// Returns the rate θ. Without a measurement in this solution it grows in proportion to the age of the tangent.
    fn rate(&self) -> Option<f64> {
        let TangentUsage { rate, solutions, rated, .. } = self.usage;
        rate.map(|rate| rate * f64::from(1 + solutions) / f64::from(1 + rated))
    }

    /// Estimates the remainder θ/(1 − θ) × the size of the last increment. It is zero for a new tangent.
    pub(crate) fn remainder(&self, size: f64) -> f64 {
        match self.rate() {
            _ if self.exact && self.usage.age == TangentAge::Iteration => 0.0,
            Some(rate) if rate < 1.0 => rate / (1.0 - rate) * size,
            _ => f64::INFINITY,
        }
    }

    /// Returns the energy Σ Kᵢᵢ eᵢ²/w_q of independent errors e of the unknowns.
    pub(crate) fn error_energy(&self, w: Weights, errors: impl Iterator<Item = f64>) -> f64 {
        let of = |(i, error): (usize, f64)| self.matrix.diagonal_of(i).abs() * error * error;
        errors.enumerate().map(of).sum::<f64>() / w.q
    }

    /// Chooses the tangent of the next iteration, given the target for the remainder relative to the last increment.
    ///
    /// Returns false if the current solution should be restarted.
    pub(crate) fn plan_iteration(&mut self, part: f64) -> bool {
        let Some(rate) = self.rate() else { return true };
        if !self.exact {
            // The first tangents are those of predictions. Later ones converge at the same rate.
            if rate > SLOW || rate > FAST && self.computed < APPROXIMATIONS {
                self.renew();
            }
            return true;
        }
        let left = (part * (1.0 - rate)).ln() / rate.ln();
        if rate < 1.0 && left <= f64::from(self.renewal_cost) {
            return true;
        }
        self.renew();
        if self.usage.age != TangentAge::Old {
            return true;
        }
        if rate < 1.0 {
            self.extend_pause();
        }
        rate < 1.0
    }

    /// Extends the pause of the reuse: the reused tangent did not converge.
    fn extend_pause(&mut self) {
        self.usage.last_pause = (2 * self.usage.last_pause).clamp(1, MAX_PAUSE);
        self.usage.pause = self.usage.last_pause;
    }
}

impl TangentStates {
    fn record(&mut self, s: &State) {
        if !self.is_new {
            std::mem::swap(&mut self.now, &mut self.saved);
        }
        self.is_new = true;
        self.now.copy_from(s);
    }
}

impl NewtonTangent {
    /// Saves the usage after an accepted step, to which a failed next step returns.
    pub(crate) fn save(&mut self) {
        let factor = self.usage.weights.map_or(FactorHistory::NEW, |_| self.factor.history());
        self.saved = TangentUsage { factor, ..self.usage };
        self.made.iter_mut().for_each(|made| made.is_new = false);
    }

    /// Returns the saved state as of the last accepted step.
    pub(crate) fn checkpoint(&self) -> TangentCheckpoint {
        let at = |made: &TangentStates| if made.is_new { made.saved.clone() } else { made.now.clone() };
        let made = self.made.as_deref().filter(|_| self.saved.weights.is_some()).map(at);
        TangentCheckpoint { usage: self.saved, made }
    }

    /// Resumes from a saved state of this size. The tangent is computed again at its original state.
    pub(crate) fn restore(
        &mut self,
        eom: &dyn EquationsOfMotion,
        checkpoint: &TangentCheckpoint,
    ) -> Result<(), SolveFailure> {
        self.usage = checkpoint.usage;
        if let (Some(w), Some(s)) = (checkpoint.usage.weights, &checkpoint.made) {
            eom.tangent(s, w, &mut self.matrix);
            let made = self.factor.refactorise(&self.matrix, checkpoint.usage.factor);
            made.map_err(|_| SolveFailure::Singular)?;
            self.made.iter_mut().for_each(|made| made.now.copy_from(s));
        }
        self.save();
        Ok(())
    }

    /// Returns true if a saved state is valid for this tangent.
    pub(crate) fn accepts(
        &self,
        checkpoint: &TangentCheckpoint,
        coordinates: usize,
        multipliers: usize,
    ) -> bool {
        let TangentCheckpoint { usage, made } = checkpoint;
        let finite = |w: Weights| [w.q, w.v, w.a].iter().all(|x| x.is_finite());
        let is_reusable = |usage: &TangentUsage| usage.policy != TangentPolicy::Always;
        is_reusable(usage) == is_reusable(&self.usage)
            && usage.weights.is_some() == made.is_some()
            && usage.weights.is_none_or(finite)
            && made.as_ref().is_none_or(|s| is_reusable(usage) && s.is_valid(coordinates, multipliers))
            && usage.extra_iterations.max(usage.solutions).max(usage.rated) <= u32::MAX / 2
            && usage.pause.max(usage.last_pause) <= MAX_PAUSE
    }
}
