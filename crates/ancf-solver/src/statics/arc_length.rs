use std::ops::ControlFlow;

use super::arc_metric::{Metric, PathTangent, PlaneUpdate};
use super::equilibrium::{Equilibrium, check_change};
use super::linear_response::{load_response, refined_load_response};
use super::path_point::{ArcLengthSteps, EndConditions, EndReason, LimitPoint, PathPoint};
use super::stability::unstable_directions;
use crate::equations::{Energy, EquationsOfMotion, State};
use crate::newton::{ActiveSet, EquilibriumError, FullUpdate, Newton, SolveError, SolveFailure};

/// Smallest cosine between the tangents at both ends of a step (60°), and between the chord and the first tangent
/// (30°).
const TURN: f64 = 0.5;
const CHORD: f64 = 0.866;
/// Relative step size at which a stability change without a limit point is accepted.
const CONFIRMED: f64 = 1e-3;
/// Relative error of the load factor at a limit point.
const LIMIT: f64 = 1e-10;
/// Relative difference of load factors that counts as rounding error.
const AT_TARGET: f64 = 1e-12;
/// Maximum number of iterations to locate a limit point or a load factor.
const MAX_LOCATE: u32 = 40;
/// Stagnation limit within a step.
const STAGNATION_LIMIT: u32 = 6;

/// Arc-length continuation of equilibria r(q, λ, s) = 0 through limit points, snap-through and snap-back.
///
/// A step predicts along the tangent (dq/dσ, dλ/dσ, ds/dσ). Newton's method corrects in the plane normal to it. The
/// path keeps its direction: the tangents of neighbouring points form an acute angle. Failed steps and steps with large
/// turns are halved. If ds/dσ changes sign within a step, the step ends at the limit point.
///
/// Loads must be linear in s. Moving parts must have mass, since the mass matrix defines the metric of the arc length.
///
/// Source: Keller (1977); Riks (1979); Crisfield (1981).
#[derive(Debug)]
pub struct ArcLength<'a, E: EquationsOfMotion + ?Sized> {
    eom: ActiveSet<'a, E>,
    newton: Newton,
    steps: ArcLengthSteps,
    metric: Metric,
    state: State,
    tangent: PathTangent,
    /// Trial point and its tangent.
    trial: State,
    trial_tangent: PathTangent,
    step: f64,
    length: f64,
    /// Number of unstable directions beyond the current point.
    unstable: Option<usize>,
    /// Step size at which an unconfirmed stability change was first found.
    unconfirmed_step: Option<f64>,
    /// Sign of the slope of the load factor beyond the current point.
    direction: f64,
}

/// End point of a step.
struct StepEnd {
    found: Equilibrium,
    length: f64,
    limit: Option<LimitPoint>,
    at_target: bool,
    /// Number of unstable directions beyond the end point.
    unstable: Option<usize>,
}

impl<'a, E: EquationsOfMotion> ArcLength<'a, E> {
    /// Starts from a state at or near equilibrium under its load factor, in the direction of increasing load.
    ///
    /// # Errors
    /// If there is no equilibrium nearby or its stiffness is singular.
    pub fn new(
        eom: &'a E,
        mut newton: Newton,
        steps: ArcLengthSteps,
        mut start: State,
    ) -> Result<Self, EquilibriumError> {
        start.v.fill(0.0);
        start.a.fill(0.0);
        newton.set_stagnation_limit(STAGNATION_LIMIT);
        let load = start.load;
        let mut eom = ActiveSet::new(eom);
        let mut begin = |newton: &mut Newton, start: &mut State| {
            loop {
                let found = Equilibrium::find(newton, &mut FullUpdate, &*eom, start)?;
                if !eom.include_active_terms(newton, start)? {
                    let responses = refined_load_response(newton, &*eom, start);
                    return responses.map_err(|failure| found.reject(failure, start));
                }
            }
        };
        let [response, refined] = begin(&mut newton, &mut start).map_err(|cause| EquilibriumError {
            reached: load,
            load,
            cause,
        })?;
        let metric = Metric::new(&*eom, &start, newton.tangent.matrix.clone(), [&response, &refined]);
        let tangent = metric.tangent(response, start.q.len());
        newton.record_energy(eom.energy(&start).largest());
        let (matrix, factor) = newton.tangent.lend();
        let unstable = unstable_directions(&*eom, &start, matrix, factor);
        let trial_tangent = PathTangent::zero(tangent.z.len());
        let (trial, step) = (start.clone(), steps.first);
        Ok(Self {
            eom,
            newton,
            steps,
            metric,
            state: start,
            tangent,
            trial,
            trial_tangent,
            step,
            length: 0.0,
            unstable,
            unconfirmed_step: None,
            direction: 1.0,
        })
    }

    /// Reverses the path, in the direction of decreasing load.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.tangent.scale(-1.0);
        self.direction = -self.direction;
        self
    }

    /// Returns the current point.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Returns the energies of the current point.
    pub fn energy(&self) -> Energy {
        self.eom.energy(&self.state)
    }

    /// Follows the path. `each` receives every point, including limit points, and may stop the analysis.
    ///
    /// # Errors
    /// If the smallest permitted step fails. The state is then the last point.
    pub fn follow(
        &mut self,
        until: &EndConditions,
        mut each: impl FnMut(&State, &PathPoint) -> ControlFlow<()>,
    ) -> Result<EndReason, EquilibriumError> {
        let end = self.length + until.length;
        for _ in 0..until.points {
            let left = end - self.length;
            let step_end = self.advance(until.load, left)?;
            let last = step_end.length >= left;
            let at_target = step_end.at_target;
            let point = self.accept_trial(step_end);
            if each(&self.state, &point).is_break() {
                return Ok(EndReason::Stopped);
            }
            if at_target {
                return Ok(EndReason::Load);
            }
            if last {
                return Ok(EndReason::Length);
            }
        }
        Ok(EndReason::Points)
    }

    /// Accepts the trial point as the current point.
    fn accept_trial(&mut self, step_end: StepEnd) -> PathPoint {
        self.newton.record_energy(step_end.found.energy.largest());
        self.state.copy_from(&self.trial);
        std::mem::swap(&mut self.tangent, &mut self.trial_tangent);
        self.length += step_end.length;
        self.unstable = step_end.unstable;
        if step_end.limit.is_some() {
            self.direction = -self.direction;
        }
        let (slope, limit) = (self.tangent.load, step_end.limit);
        PathPoint { equilibrium: step_end.found, length: self.length, slope, limit }
    }

    /// Computes the next point in the trial state by a step of at most `left`.
    fn advance(&mut self, target: Option<f64>, left: f64) -> Result<StepEnd, EquilibriumError> {
        let mut found = Equilibrium::default();
        loop {
            let step = self.step.min(self.steps.largest).min(left);
            match self.attempt_step(step, target) {
                Ok((step_end, iterations)) => {
                    let expected = f64::from(self.steps.iterations) / f64::from(iterations.max(1));
                    self.step = step * expected.sqrt().clamp(0.5, 2.0);
                    if step_end.unstable != self.unstable {
                        // The stability change is confirmed, so the path continues with the original step size.
                        self.step = self.unconfirmed_step.take().unwrap_or(self.step);
                    }
                    // Otherwise the path has turned away from the bifurcation.
                    self.unconfirmed_step = self.unconfirmed_step.filter(|first| step < *first);
                    return Ok(StepEnd { found: found.followed_by(step_end.found), ..step_end });
                }
                Err(cause) => {
                    found.failed(&cause);
                    if cause.failure == SolveFailure::Unstable {
                        self.unconfirmed_step.get_or_insert(step);
                    }
                    self.step = 0.5 * step;
                    if self.step < self.steps.smallest || cause.is_final() {
                        let (reached, load) = (self.state.load, self.trial.load);
                        return Err(EquilibriumError { reached, load, cause });
                    }
                }
            }
        }
    }

    /// Attempts a step and ends it at a limit point or at the target. Returns also the iterations of the whole step.
    fn attempt_step(&mut self, step: f64, target: Option<f64>) -> Result<(StepEnd, u32), SolveError> {
        let found = self.attempt(step)?;
        let (iterations, unstable) = (found.iterations, found.unstable);
        let mut step_end = StepEnd { found, length: step, limit: None, at_target: false, unstable };
        if self.hides_limits(step) {
            return Err(found.reject(SolveFailure::Turned, &self.trial));
        }
        let unconfirmed = self.unconfirmed_step.is_none_or(|first| step > CONFIRMED * first);
        if unconfirmed && self.hides_bifurcation(unstable) {
            return Err(found.reject(SolveFailure::Unstable, &self.trial));
        }
        if self.trial_tangent.load * self.direction < 0.0 {
            let start = self.direction * self.tangent.load.abs();
            let largest = self.state.load.abs().max(self.trial.load.abs());
            // The load falls short of its limit by slope²/2 |curvature|.
            self.locate(
                &mut step_end,
                start,
                |_, trial_tangent| trial_tangent.load,
                |slope, curvature| 0.5 * slope * slope <= LIMIT * largest * curvature.abs(),
            )?;
            step_end.limit =
                Some(if self.direction > 0.0 { LimitPoint::Maximum } else { LimitPoint::Minimum });
        }
        if let Some(target) = target {
            let (before, after) = (self.state.load - target, self.trial.load - target);
            let reached = after.abs() <= AT_TARGET * target.abs() && before != 0.0;
            if before * after < 0.0 || reached {
                let close = 1e-3 * (before - after).abs();
                let mut target_end = StepEnd { found: step_end.found, ..step_end };
                self.locate(&mut target_end, before, |s, _| s.load - target, |miss, _| miss.abs() <= close)?;
                self.solve_at_load(target, &mut target_end)?;
                let unstable = target_end.found.unstable;
                step_end = StepEnd { limit: None, at_target: true, unstable, ..target_end };
            }
        }
        Ok((step_end, iterations))
    }

    /// Returns true if the load factor may have two extrema within a step, which its end slopes do not show.
    ///
    /// A cubic with end slopes of equal sign is monotone if both are at most three times the mean slope (Fritsch &
    /// Carlson 1980).
    fn hides_limits(&self, step: f64) -> bool {
        let mean = (self.trial.load - self.state.load) / step * self.direction;
        let [before, after] =
            [self.tangent.load, self.trial_tangent.load].map(|slope| slope * self.direction);
        after > 0.0 && before.max(after) > 3.0 * mean
    }

    /// Returns true if the stability change does not match the limit points of the step.
    ///
    /// A bifurcation causes such a change. Sufficiently small steps follow the path of an imperfect structure around
    /// it.
    fn hides_bifurcation(&self, unstable: Option<usize>) -> bool {
        let limits = usize::from(self.trial_tangent.load * self.direction < 0.0);
        matches!((self.unstable, unstable), (Some(before), Some(after)) if before.abs_diff(after) != limits)
    }

    /// Solves for the equilibrium at a length σ beyond the current point, and for its tangent.
    fn attempt(&mut self, length: f64) -> Result<Equilibrium, SolveError> {
        self.eom.include_near_terms(&mut self.newton, &self.state)?;
        let mut found = Equilibrium::default();
        loop {
            self.trial.copy_from(&self.state);
            self.tangent.move_by(length, &mut self.trial);
            let Self { newton, eom, tangent, trial, .. } = self;
            found = found.repeated(Equilibrium::find(newton, &mut PlaneUpdate(tangent), &**eom, trial)?);
            if !eom.include_active_terms(newton, trial)? {
                return self.update_tangent(found);
            }
        }
    }

    /// Computes the tangent at the trial state.
    fn update_tangent(&mut self, mut found: Equilibrium) -> Result<Equilibrium, SolveError> {
        let response = load_response(&mut self.newton, &*self.eom, &self.trial)
            .map_err(|failure| found.reject(failure, &self.trial))?;
        let (matrix, factor) = self.newton.tangent.lend();
        found.unstable = unstable_directions(&*self.eom, &self.trial, matrix, factor);
        self.trial_tangent = self.metric.tangent(response, self.trial.q.len());
        if self.trial_tangent.product(&self.tangent) < 0.0 {
            self.trial_tangent.scale(-1.0);
        }
        let chord = self.metric.distance(&self.state, &self.trial);
        let along = self.tangent.length(&self.state, &self.trial);
        if self.trial_tangent.product(&self.tangent) < TURN || along < CHORD * chord {
            return Err(found.reject(SolveFailure::Turned, &self.trial));
        }
        check_change(&*self.eom, &found, &self.state, &self.trial)?;
        Ok(found)
    }

    /// Shortens a step to the root of `value`, which is `start` at the start and has the opposite sign at the end.
    ///
    /// The method is regula falsi in the Illinois form. `done` evaluates a value and its slope along the path.
    fn locate(
        &mut self,
        step_end: &mut StepEnd,
        start: f64,
        value: impl Fn(&State, &PathTangent) -> f64,
        done: impl Fn(f64, f64) -> bool,
    ) -> Result<(), SolveError> {
        let (mut a, mut at_a) = (0.0, start);
        let (mut b, mut at_b) = (step_end.length, value(&self.trial, &self.trial_tangent));
        for _ in 0..MAX_LOCATE {
            if done(at_b, (at_b - at_a) / (b - a)) {
                step_end.length = b;
                return Ok(());
            }
            let length = b - at_b * (b - a) / (at_b - at_a);
            step_end.found = step_end.found.followed_by(self.attempt(length)?);
            let at_length = value(&self.trial, &self.trial_tangent);
            if at_length * at_b < 0.0 {
                (a, at_a) = (b, at_b);
            } else {
                at_a *= 0.5;
            }
            (b, at_b) = (length, at_length);
        }
        Err(step_end.found.reject(SolveFailure::NotConverged, &self.trial))
    }

    /// Moves the trial state to a nearby load factor.
    fn solve_at_load(&mut self, target: f64, step_end: &mut StepEnd) -> Result<(), SolveError> {
        self.trial.load = target;
        let mut found = Equilibrium::find(&mut self.newton, &mut FullUpdate, &*self.eom, &mut self.trial)?;
        while self.eom.include_active_terms(&mut self.newton, &self.trial)? {
            found = found.repeated(Equilibrium::find(
                &mut self.newton,
                &mut FullUpdate,
                &*self.eom,
                &mut self.trial,
            )?);
        }
        step_end.found = step_end.found.followed_by(self.update_tangent(found)?);
        step_end.length = self.tangent.length(&self.state, &self.trial);
        Ok(())
    }
}
