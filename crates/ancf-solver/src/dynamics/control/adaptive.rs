use serde::{Deserialize, Serialize};

use super::contact_changes::ContactChanges;
use super::error_estimate::{ErrorEstimate, ErrorHistory};
use super::law_changes::law_accelerations;
use super::unseen_variation::{TimeFunctions, UnseenVariation, displacements};
use crate::dynamics::integration_state::CheckpointMismatch;
use crate::dynamics::step_report::StepReport;
use crate::dynamics::time_stepper::TimeStepper;
use crate::equations::EquationsOfMotion;
use crate::newton::{SolveError, SolveFailure};

/// Settings of the step size control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorControl {
    /// Tolerance of the global error: a mass-weighted root mean square displacement at the end, relative to `length`.
    pub tolerance: f64,
    /// Reference length of the model, such as the length of its longest body.
    pub length: f64,
    /// Total mass of the model.
    pub mass: f64,
    /// Duration over which errors accumulate.
    pub duration: f64,
    /// First step size. Computed from the first acceleration if absent.
    pub initial: Option<f64>,
    /// Largest permitted step size.
    pub largest: f64,
    /// Smallest permitted step size.
    pub smallest: f64,
}

impl ErrorControl {
    /// Default of the smallest step size, relative to the duration.
    pub const SMALLEST: f64 = 1e-9;
}

/// Step size control of [`TimeStepper`] for second-order schemes.
///
/// The error e of each step is estimated as a displacement. Errors accumulate, so each step receives a proportional
/// share of the tolerance: e/h ≤ tolerance × length / duration. The controller aims at a fraction of this share. The
/// errors of two steps determine the next step size. The step size changes smoothly, since each change disturbs the
/// multipliers:
///
/// hₙ₊₁ = hₙ (xₙ xₙ₋₁)^(1/bk) (hₙ/hₙ₋₁)^(−1/b),   x = target error / error,  k = 2,  b = 4.
///
/// The global error bound is proven for vibrations only. Unstable motions have larger errors.
///
/// The estimate is the error of a smooth motion. The errors of contacts that open or close, of laws with kinks, and of functions of
/// time that vary between the ends of the step, are added.
///
/// Source: Söderlind (2003), the digital filter H211b.
#[derive(Debug)]
pub struct AdaptiveStepper {
    control: ErrorControl,
    estimate: ErrorEstimate,
    sizes: StepSizes,
    functions: Option<Box<dyn TimeFunctions>>,
    /// Variations within the attempted step.
    unseen: Vec<UnseenVariation>,
    /// Displacement of the attempted step by velocities along constraints, relative to the tolerance.
    moved: f64,
    /// Coordinate with the largest displacement by a variation within the attempted step.
    varied: Option<usize>,
}

/// Step sizes of the controller.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
struct StepSizes {
    /// Next step size.
    next: f64,
    /// Error ratio x and step size h of the last accepted step.
    last: Option<(f64, f64)>,
}

/// Saved state of [`AdaptiveStepper`], on which later steps depend.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct AdaptiveCheckpoint {
    sizes: StepSizes,
    history: ErrorHistory,
}

/// Target of the error, relative to its share of the tolerance.
const TARGET: f64 = 0.4;
/// Exponents 1/bk and 1/b.
const FILTER: (f64, f64) = (0.125, 0.25);
/// Reduction factor after a failed iteration, and largest reduction after a rejected step.
const REDUCTION: f64 = 0.25;
/// Weight of the errors of contacts and laws that change and of functions that vary within a step. They are errors of velocities:
/// with a weight of 1, those of one step would displace the system by the whole tolerance at the end.
const VELOCITY_WEIGHT: f64 = 4.0;
/// Exponent of the growth of steps with constraints, below 1, so that errors along constraints decay; and its lower limit.
const GROWTH: f64 = 0.75;
/// Largest displacement by velocities along constraints, relative to the tolerance, up to which steps grow freely.
const MOVED: f64 = 0.25;
const LEAST_GROWTH: f64 = 1.05;
/// Relative rounding error of the division of an interval into steps.
const ROUNDING: f64 = 1e-9;

/// Returns the largest growth of a step, for a displacement by velocities along constraints relative to the tolerance.
///
/// A scheme multiplies these velocities, which are errors, by a factor of magnitude ρ in each step. In steps that grow by r
/// their accelerations are scaled twice, and the factor is ρr. The displacement, proportional to ρr², must stay below a
/// limit, or the velocities must decay.
fn most_growth(decay: f64, moved: f64) -> f64 {
    if decay * moved == 0.0 {
        return f64::INFINITY;
    }
    let decaying = decay.powf(-GROWTH).max(LEAST_GROWTH);
    (MOVED / (decay * moved)).sqrt().max(decaying)
}

impl AdaptiveStepper {
    /// Creates the step size control of an integration.
    pub fn new<E: EquationsOfMotion>(dynamics: &TimeStepper<'_, E>, control: ErrorControl) -> Self {
        let mut estimate = ErrorEstimate::new(dynamics, control.mass);
        let a = estimate.norm(&dynamics.state().a);
        // During this step the acceleration moves the system by about a hundredth of the tolerance.
        let own = 0.1 * (control.tolerance * control.length / a).sqrt().min(control.duration);
        let next = control.initial.unwrap_or(own).max(control.smallest);
        let sizes = StepSizes { next, last: None };
        Self { control, estimate, sizes, functions: None, unseen: Vec::new(), moved: 0.0, varied: None }
    }

    /// Sets the functions of time, so that steps do not pass over their variations.
    #[must_use]
    pub fn with_functions(self, functions: Box<dyn TimeFunctions>) -> Self {
        Self { functions: Some(functions), ..self }
    }

    /// Returns the size of the next step.
    pub fn step_size(&self) -> f64 {
        self.sizes.next.min(self.control.largest)
    }

    /// Performs one step within the tolerance towards the time `to`. The last step ends exactly there.
    ///
    /// # Errors
    /// If the smallest step fails or exceeds the tolerance. The state is then that of the last accepted step.
    pub fn step<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut TimeStepper<'_, E>,
        to: f64,
    ) -> Result<StepReport, SolveError> {
        let mut report = StepReport::default();
        let from = dynamics.state().t;
        let (mut size, mut failed) = (self.sizes.next, false);
        loop {
            // Equal parts of the remaining interval avoid a tiny last step.
            let parts = ((to - from) / size.min(self.control.largest) * (1.0 - ROUNDING)).ceil().max(1.0);
            let h = (to - from) / parts;
            let end = if parts == 1.0 { to } else { from + h };
            let attempted = self.attempt(dynamics, h, end, &mut report);
            dynamics.restore_memory();
            let failure = match attempted {
                Ok(x) if x >= TARGET => {
                    let most = most_growth(dynamics.scheme.constrained_decay(), self.moved);
                    self.plan_next(x, h, (size, failed), most);
                    return Ok(report);
                }
                Ok(x) => {
                    size = h * x.sqrt().max(REDUCTION);
                    SolveError {
                        worst: self.varied.or_else(|| self.estimate.worst()),
                        ..SolveError::at(end, SolveFailure::StepTooSmall)
                    }
                }
                Err(error) if error.is_final() => return Err(error),
                Err(error) => {
                    report.iterations += error.iterations;
                    size = REDUCTION * h;
                    error
                }
            };
            if h <= self.control.smallest * (1.0 + 2.0 * ROUNDING) {
                return Err(failure);
            }
            size = size.max(self.control.smallest);
            failed = true;
        }
    }

    /// Attempts a step and returns x = target error / estimated error. The step is accepted for x ≥ [`TARGET`].
    fn attempt<E: EquationsOfMotion>(
        &mut self,
        dynamics: &mut TimeStepper<'_, E>,
        h: f64,
        end: f64,
        report: &mut StepReport,
    ) -> Result<f64, SolveError> {
        // The error estimate needs the current iteration matrix as a filter.
        dynamics.newton.tangent.renew();
        dynamics.adapt_to(h)?;
        if dynamics.motion.at_start {
            self.sizes.last = None;
            self.estimate.restart();
        }
        let done = dynamics.attempt(h, end)?;
        let error = self.estimate.error(dynamics, &done, h);
        let mut error = error.inspect_err(|_| dynamics.revert())?;
        let share = self.control.tolerance * self.control.length * h / self.control.duration;
        self.varied = None;
        if error <= share {
            error += self.hidden_error(dynamics, h).inspect_err(|_| dynamics.revert())?;
        }
        // Velocities along constraints must not move the system by more than the tolerance within a step.
        let tolerance = self.control.tolerance * self.control.length;
        let velocity_error = self.estimate.velocity_error(dynamics).inspect_err(|_| dynamics.revert())?;
        self.moved = h * velocity_error / tolerance;
        if self.moved > 1.0 {
            error = error.max(self.moved * share);
        }
        let x = TARGET * share / error.max(f64::MIN_POSITIVE);
        if x >= TARGET {
            dynamics.accept(&done, report);
            self.estimate.accept(h);
        } else {
            dynamics.revert();
            report.iterations += done.iterations;
            report.rejected += 1;
        }
        Ok(x)
    }

    /// Estimates the errors of an attempted step h that a smooth motion does not have.
    fn hidden_error<E: EquationsOfMotion>(
        &mut self,
        dynamics: &TimeStepper<'_, E>,
        h: f64,
    ) -> Result<f64, SolveError> {
        let (eom, ends) = (&*dynamics.eom, [&dynamics.before, &dynamics.motion.state]);
        let mut error = 0.0_f64;
        if let Some(mut changes) = ContactChanges::new(eom, ends[0], ends[1])? {
            changes.accelerations(eom, ends, dynamics.scheme.weights(h), |x| {
                error = error.max(0.5 * h * h * self.estimate.norm(x));
            })?;
        }
        let (w, matrix) = (dynamics.scheme.weights(h), &dynamics.newton.tangent.matrix);
        law_accelerations(eom, ends, w, matrix, |x| {
            error = error.max(0.5 * h * h * self.estimate.norm(x));
        })?;
        self.unseen.clear();
        if let Some(functions) = &self.functions {
            functions.unseen(ends[0].t, ends[1].t, &mut self.unseen);
        }
        for &variation in &self.unseen {
            let weights = dynamics.scheme.weights(variation.width.min(h));
            let mut matrix = dynamics.newton.tangent.matrix.clone();
            let parts = displacements(eom, ends, weights, variation, &mut matrix)?;
            error += parts.iter().map(|x| self.estimate.norm(x)).sum::<f64>();
            let moved = |i: &usize| parts.iter().map(|x| x[*i].abs()).sum::<f64>();
            self.varied = (0..parts[0].len()).max_by(|a, b| moved(a).total_cmp(&moved(b)));
        }
        Ok(VELOCITY_WEIGHT * error)
    }

    /// Computes the next step size after an accepted step h, given the proposed size and whether other sizes failed.
    fn plan_next(&mut self, x: f64, h: f64, (size, failed): (f64, bool), most: f64) {
        let (x_before, h_before) = self.sizes.last.unwrap_or((x, h));
        let factor = (x * x_before).powf(FILTER.0) * (h / h_before).powf(-FILTER.1);
        let smooth = (1.0 + (factor - 1.0).atan()).min(most); // at most 2.6
        let next = h * if failed { smooth.min(1.0) } else { smooth };
        // A step shortened to end at a given time does not limit the next step size.
        let cut = h < 0.9 * size && next >= h && !failed;
        let next = next.max(if cut { size } else { self.control.smallest });
        self.sizes = StepSizes { next, last: Some((x, h)) };
    }

    /// Returns the saved state as of the last accepted step.
    pub fn checkpoint(&self) -> AdaptiveCheckpoint {
        AdaptiveCheckpoint { sizes: self.sizes, history: self.estimate.history.clone() }
    }

    /// Resumes from a saved state.
    ///
    /// # Errors
    /// If the saved state does not belong to this control.
    pub fn restore(&mut self, checkpoint: &AdaptiveCheckpoint) -> Result<(), CheckpointMismatch> {
        let AdaptiveCheckpoint { sizes: StepSizes { next, last }, history } = checkpoint;
        let is_size = |h: f64| h >= self.control.smallest && h.is_finite();
        // An error of zero makes x infinite.
        let were_sizes = last.is_none_or(|(x, h)| x > 0.0 && h > 0.0 && h.is_finite());
        if !is_size(*next) || !were_sizes || !history.is_valid(self.estimate.history.size()) {
            return Err(CheckpointMismatch);
        }
        self.sizes = checkpoint.sizes;
        self.estimate.restore(history);
        Ok(())
    }
}
