use serde::{Deserialize, Serialize};

use super::error::Failure;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Course, Factor};
use crate::sparse::SparseMatrix;

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
pub(crate) struct Tangent {
    pub(crate) matrix: SparseMatrix,
    pub(crate) factor: Factor,
    usage: Usage,
    /// As of the last step that was accepted.
    kept: Usage,
    /// If it may be used again.
    made: Option<Box<Made>>,
}

/// How a tangent was of use so far.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
struct Usage {
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
    /// What became of its factors until the last accepted step, if they are of further use.
    factor: Course,
}

/// The states at which tangents were made.
#[derive(Debug)]
struct Made {
    now: State,
    /// That of the last accepted step, if there is another now.
    kept: State,
    is_new: bool,
}

/// What the further use of a tangent depends on: factors are large, and made again.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct TangentMemory {
    usage: Usage,
    /// Where it was made, if it is of further use.
    made: Option<State>,
}

/// When a new tangent is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Policy {
    /// In each iteration.
    Always,
    /// When the old one is no longer worth while.
    WhenDue,
    /// In each iteration of this solution, when due in others.
    AlwaysNow,
}

/// Since when a tangent is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
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
    pub(crate) fn new(matrix: SparseMatrix) -> Result<Self, Failure> {
        let factor = Factor::new(matrix.pattern()).map_err(|_| Failure::Memory)?;
        let usage = Usage::new();
        Ok(Self { matrix, factor, usage, kept: usage, made: None })
    }

    /// Takes a matrix of another pattern in the place of its own.
    pub(crate) fn adopt(&mut self, matrix: SparseMatrix) -> Result<(), Failure> {
        let Usage { policy, pause, last_pause, .. } = self.usage;
        let Self { matrix, factor, usage, .. } = Self::new(matrix)?;
        (self.matrix, self.factor) = (matrix, factor);
        self.usage = Usage { policy, pause, last_pause, ..usage };
        Ok(())
    }

    /// Lets tangents be used again, unless there are redundant constraints: these agree along the exact tangent only.
    pub(crate) fn reuse(&mut self, s: &State) {
        if !self.matrix.pattern().is_sharing() {
            self.usage.policy = Policy::WhenDue;
            self.made = Some(Box::new(Made { now: s.clone(), kept: s.clone(), is_new: false }));
        }
    }

    /// Whether they may be.
    pub(crate) fn is_reusable(&self) -> bool {
        self.usage.policy != Policy::Always
    }

    /// The next iteration needs a new one.
    pub(crate) fn renew(&mut self) {
        self.usage.weights = None;
    }

    /// Whether a solution that failed may be found with newer tangents; the next one then has them.
    pub(crate) fn improve(&mut self) -> bool {
        self.renew();
        match (self.usage.reused, self.usage.age) {
            (true, Age::Old) => self.regret(),
            (true, _) => self.usage.policy = Policy::AlwaysNow,
            (false, _) => self.settle(),
        }
        self.usage.reused
    }

    /// Matrix and factor for another use; the next iteration needs a new tangent.
    pub(crate) fn lend(&mut self) -> (&mut SparseMatrix, &mut Factor) {
        self.renew();
        (&mut self.matrix, &mut self.factor)
    }

    /// To be told at the start of a solution.
    pub(crate) fn begin(&mut self, w: Weights) {
        let alike = |own: f64, other: f64| (own - other).abs() <= ALIKE * other.abs();
        let fits = |own: Weights| alike(own.q, w.q) && alike(own.v, w.v) && alike(own.a, w.a);
        let due = self.usage.beyond >= WORTH || self.usage.pause > 0;
        self.usage.pause = self.usage.pause.saturating_sub(1);
        self.usage.weights = self.usage.weights.filter(|own| fits(*own) && !due);
        self.usage.age = Age::Old;
        self.usage.reused = false;
    }

    /// To be told at the end of a solution that was found.
    pub(crate) fn end(&mut self, iterations: u32) {
        self.usage.fewest = self.usage.fewest.min(iterations);
        self.usage.beyond += iterations - self.usage.fewest;
        if self.usage.age == Age::Old {
            self.usage.last_pause /= 2;
        }
        self.settle();
    }

    /// What was for the present solution only is over.
    fn settle(&mut self) {
        if self.usage.policy == Policy::AlwaysNow {
            self.usage.policy = Policy::WhenDue;
        }
    }

    /// Makes a new one at a state, unless there is one that is of use.
    pub(crate) fn prepare(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        w: Weights,
    ) -> Result<(), Failure> {
        if self.usage.weights.is_some() {
            self.usage.reused = true;
            self.usage.age = if self.usage.age == Age::Old { Age::Old } else { Age::Solution };
            return Ok(());
        }
        eom.tangent(s, w, &mut self.matrix);
        self.made.iter_mut().for_each(|made| made.note(s));
        self.factor.factorise(&self.matrix).map_err(|_| Failure::Singular)?;
        self.usage.weights = Some(w).filter(|_| self.usage.policy == Policy::WhenDue);
        self.usage.age = Age::Iteration;
        (self.usage.rate, self.usage.fewest, self.usage.beyond) = (None, u32::MAX, 0);
        Ok(())
    }

    /// Takes note of the rate θ by which the last increment was smaller than the one before it in its solution.
    pub(crate) fn note(&mut self, rate: Option<f64>) {
        if self.usage.age != Age::Iteration {
            self.usage.rate = rate.or(self.usage.rate);
        }
    }

    /// What an increment of this size leaves: θ/(1 − θ) times it, nothing that counts if the tangent was new for it.
    pub(crate) fn left(&self, size: f64) -> f64 {
        match self.usage.rate {
            _ if self.usage.age == Age::Iteration => 0.0,
            Some(rate) if rate < 1.0 => rate / (1.0 - rate) * size,
            _ => f64::INFINITY,
        }
    }

    /// Decides on the next iteration: what is left is to fall to a part of the last increment. Returns false if the
    /// present solution is better begun anew.
    pub(crate) fn foresee(&mut self, part: f64) -> bool {
        let Some(rate) = self.usage.rate else { return true };
        let left = (part * (1.0 - rate)).ln() / rate.ln();
        if rate < 1.0 && left <= f64::from(WORTH) {
            return true;
        }
        self.renew();
        if self.usage.age != Age::Old {
            return true;
        }
        if rate < 1.0 {
            self.regret();
        }
        rate < 1.0
    }

    /// An old tangent was of no use.
    fn regret(&mut self) {
        self.usage.last_pause = (2 * self.usage.last_pause).clamp(1, LONGEST);
        self.usage.pause = self.usage.last_pause;
    }
}

impl Usage {
    const fn new() -> Self {
        Self {
            policy: Policy::Always,
            weights: None,
            age: Age::Iteration,
            reused: false,
            rate: None,
            fewest: u32::MAX,
            beyond: 0,
            pause: 0,
            last_pause: 0,
            factor: Course::NEW,
        }
    }
}

impl Made {
    fn note(&mut self, s: &State) {
        if !self.is_new {
            std::mem::swap(&mut self.now, &mut self.kept);
        }
        self.is_new = true;
        self.now.copy_from(s);
    }
}

impl Tangent {
    /// To be told after each accepted step: to this a run returns that breaks off in the next.
    pub(crate) fn keep(&mut self) {
        let factor = self.usage.weights.map_or(Course::NEW, |_| self.factor.course());
        self.kept = Usage { factor, ..self.usage };
        self.made.iter_mut().for_each(|made| made.is_new = false);
    }

    /// As of the last accepted step.
    pub(crate) fn memory(&self) -> TangentMemory {
        let at = |made: &Made| if made.is_new { made.kept.clone() } else { made.now.clone() };
        let made = self.made.as_deref().filter(|_| self.kept.weights.is_some()).map(at);
        TangentMemory { usage: self.kept, made }
    }

    /// Goes on from a memory of this size: the tangent is made again where it was made.
    pub(crate) fn recall(
        &mut self,
        eom: &dyn EquationsOfMotion,
        memory: &TangentMemory,
    ) -> Result<(), Failure> {
        self.usage = memory.usage;
        if let (Some(w), Some(s)) = (memory.usage.weights, &memory.made) {
            eom.tangent(s, w, &mut self.matrix);
            let made = self.factor.factorise_again(&self.matrix, memory.usage.factor);
            made.map_err(|_| Failure::Singular)?;
            self.made.iter_mut().for_each(|made| made.now.copy_from(s));
        }
        self.keep();
        Ok(())
    }

    /// Whether a memory is one of such a tangent.
    pub(crate) fn knows(&self, memory: &TangentMemory, coordinates: usize, multipliers: usize) -> bool {
        let TangentMemory { usage, made } = memory;
        let finite = |w: Weights| [w.q, w.v, w.a].iter().all(|x| x.is_finite());
        let is_reusable = |usage: &Usage| usage.policy != Policy::Always;
        is_reusable(usage) == is_reusable(&self.usage)
            && usage.weights.is_some() == made.is_some()
            && usage.weights.is_none_or(finite)
            && made.as_ref().is_none_or(|s| is_reusable(usage) && s.is_sound(coordinates, multipliers))
            && usage.beyond <= u32::MAX / 2
            && usage.pause.max(usage.last_pause) <= LONGEST
    }
}
