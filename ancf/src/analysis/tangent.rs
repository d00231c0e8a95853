use super::Failure;
use crate::system::{EquationsOfMotion, Factor, SparseMatrix, State, Weights};

/// The factorised tangent of Newton's method, and how long it is of use.
///
/// In steps of time it is used again, in further iterations and in further steps, as long as this is cheaper than a new
/// one. An iteration with an old tangent is a fixed-point iteration whose increments fall by a rate θ each; θ tells how
/// many iterations are left. A new tangent is made within a step if more than [`WORTH`] of them are, and before a step if those
/// since the last new tangent would have made up for one. Where tangents age within a step, as in fast rotations, a number of
/// steps begin with new ones before an old one is tried again, twice as many after each disappointment.
///
/// Source: Hairer & Wanner (1996), section IV.8; Deuflhard (2011), section 2.1, for the rate as a monitor.
#[derive(Debug)]
pub(super) struct Tangent {
    pub(super) matrix: SparseMatrix,
    pub(super) factor: Factor,
    policy: Policy,
    /// What it was made for; none if it is of no further use.
    weights: Option<Weights>,
    /// Since when it is there.
    age: Age,
    /// Whether an iteration of the present solution did without a new one.
    reused: bool,
    /// θ of the last iteration that had the same tangent as the one before.
    rate: Option<f64>,
    /// The fewest iterations of a solution since it was made, and those beyond in all solutions.
    fewest: u32,
    beyond: u32,
    /// So many solutions begin with a new one; so many did after the last disappointment.
    pause: u32,
    last_pause: u32,
}

/// When a new tangent is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Policy {
    /// In each iteration.
    Always,
    /// When the old one is no longer worth while.
    WhenDue,
    /// In each iteration of this solution, when due in others.
    AlwaysNow,
}

/// Since when a tangent is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Age {
    Iteration,
    Solution,
    Old,
}

/// A new factorised tangent costs about as much as so many iterations with an old one.
const WORTH: u32 = 3;
/// Weights of the tangent that differ by less than this part are alike.
const ALIKE: f64 = 1e-2;
/// The longest pause.
const LONGEST: u32 = 64;

impl Tangent {
    /// For tangents of the pattern of `matrix`, a new one in each iteration.
    pub(super) fn new(matrix: SparseMatrix) -> Result<Self, Failure> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| Failure::Memory)?;
        Ok(Self {
            matrix,
            factor,
            policy: Policy::Always,
            weights: None,
            age: Age::Iteration,
            reused: false,
            rate: None,
            fewest: u32::MAX,
            beyond: 0,
            pause: 0,
            last_pause: 0,
        })
    }

    /// Takes a matrix of another pattern in the place of its own.
    pub(super) fn adopt(&mut self, matrix: SparseMatrix) -> Result<(), Failure> {
        *self = Self {
            policy: self.policy,
            pause: self.pause,
            last_pause: self.last_pause,
            ..Self::new(matrix)?
        };
        Ok(())
    }

    /// Lets tangents be used again, unless there are redundant constraints: these agree along the exact tangent only.
    pub(super) fn reuse(&mut self) {
        if !self.matrix.pattern().is_sharing() {
            self.policy = Policy::WhenDue;
        }
    }

    /// Whether they may be.
    pub(super) fn is_reusable(&self) -> bool {
        self.policy != Policy::Always
    }

    /// The next iteration needs a new one.
    pub(super) fn renew(&mut self) {
        self.weights = None;
    }

    /// Whether a solution that failed may be found with newer tangents; the next one then has them.
    pub(super) fn improve(&mut self) -> bool {
        self.renew();
        match (self.reused, self.age) {
            (true, Age::Old) => self.regret(),
            (true, _) => self.policy = Policy::AlwaysNow,
            (false, _) => self.settle(),
        }
        self.reused
    }

    /// Matrix and factor for another use; the next iteration needs a new tangent.
    pub(super) fn lend(&mut self) -> (&mut SparseMatrix, &mut Factor) {
        self.renew();
        (&mut self.matrix, &mut self.factor)
    }

    /// To be told at the start of a solution.
    pub(super) fn begin(&mut self, w: Weights) {
        let alike = |own: f64, other: f64| (own - other).abs() <= ALIKE * other.abs();
        let fits = |own: Weights| alike(own.q, w.q) && alike(own.v, w.v) && alike(own.a, w.a);
        let due = self.beyond >= WORTH || self.pause > 0;
        self.pause = self.pause.saturating_sub(1);
        self.weights = self.weights.filter(|own| fits(*own) && !due);
        self.age = Age::Old;
        self.reused = false;
    }

    /// To be told at the end of a solution that was found.
    pub(super) fn end(&mut self, iterations: u32) {
        self.fewest = self.fewest.min(iterations);
        self.beyond += iterations - self.fewest;
        if self.age == Age::Old {
            self.last_pause /= 2;
        }
        self.settle();
    }

    /// What was for the present solution only is over.
    fn settle(&mut self) {
        if self.policy == Policy::AlwaysNow {
            self.policy = Policy::WhenDue;
        }
    }

    /// Makes a new one at a state, unless there is one that is of use.
    pub(super) fn prepare(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        w: Weights,
    ) -> Result<(), Failure> {
        if self.weights.is_some() {
            self.reused = true;
            self.age = if self.age == Age::Old { Age::Old } else { Age::Solution };
            return Ok(());
        }
        eom.tangent(s, w, &mut self.matrix);
        self.factor.factorise(&self.matrix).map_err(|_| Failure::Singular)?;
        self.weights = Some(w).filter(|_| self.policy == Policy::WhenDue);
        self.age = Age::Iteration;
        (self.rate, self.fewest, self.beyond) = (None, u32::MAX, 0);
        Ok(())
    }

    /// Takes note of the rate θ by which the last increment was smaller than the one before it in its solution.
    pub(super) fn note(&mut self, rate: Option<f64>) {
        if self.age != Age::Iteration {
            self.rate = rate.or(self.rate);
        }
    }

    /// What an increment of this size leaves: θ/(1 − θ) times it, nothing that counts if the tangent was new for it.
    pub(super) fn left(&self, size: f64) -> f64 {
        match self.rate {
            _ if self.age == Age::Iteration => 0.0,
            Some(rate) if rate < 1.0 => rate / (1.0 - rate) * size,
            _ => f64::INFINITY,
        }
    }

    /// Decides on the next iteration: what is left is to fall to a part of the last increment. Returns false if the
    /// present solution is better begun anew.
    pub(super) fn foresee(&mut self, part: f64) -> bool {
        let Some(rate) = self.rate else { return true };
        let left = (part * (1.0 - rate)).ln() / rate.ln();
        if rate < 1.0 && left <= f64::from(WORTH) {
            return true;
        }
        self.renew();
        if self.age != Age::Old {
            return true;
        }
        if rate < 1.0 {
            self.regret();
        }
        rate < 1.0
    }

    /// An old tangent was of no use.
    fn regret(&mut self) {
        self.last_pause = (2 * self.last_pause).clamp(1, LONGEST);
        self.pause = self.last_pause;
    }
}
