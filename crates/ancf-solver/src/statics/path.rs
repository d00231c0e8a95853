use std::ops::ControlFlow;

use super::arc::{Metric, Plane, Tangent, response};
use super::equilibrium::Equilibrium;
use super::waypoint::{ArcSteps, Left, Limit, PathPoint, Until};
use crate::equations::{Energy, EquationsOfMotion, State};
use crate::newton::{Current, EquilibriumError, Failure, Newton, SolveError, Whole};
use crate::sparse::SparseMatrix;

/// Smallest cosine between the tangents at both ends of a step (60°), and between the chord and the first tangent
/// (30°).
const TURN: f64 = 0.5;
const BEND: f64 = 0.866;
/// Relative step size at which a stability change without a limit point is accepted.
const BELIEVED: f64 = 1e-3;
/// Relative error of the load factor at a limit point.
const LIMIT: f64 = 1e-10;
/// Maximum number of iterations to locate a limit point or a load factor.
const LOCATE: u32 = 40;
/// Stagnation limit within a step.
const PATIENCE: u32 = 6;

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
pub struct Path<'a, E: EquationsOfMotion + ?Sized> {
    eom: Current<'a, E>,
    newton: Newton,
    steps: ArcSteps,
    metric: Metric,
    state: State,
    tangent: Tangent,
    /// Trial point and its tangent.
    trial: State,
    ahead: Tangent,
    step: f64,
    length: f64,
    /// Number of unstable directions beyond the current point.
    unstable: Option<usize>,
    /// Step size at which an unconfirmed stability change was first found.
    doubt: Option<f64>,
    /// Sign of the slope of the load factor beyond the current point.
    heading: f64,
}

/// End point of a step.
struct Arrival {
    found: Equilibrium,
    length: f64,
    limit: Option<Limit>,
    landed: bool,
    /// Number of unstable directions beyond the end point.
    unstable: Option<usize>,
}

impl<'a, E: EquationsOfMotion> Path<'a, E> {
    /// Starts from a state at or near equilibrium under its load factor, in the direction of increasing load.
    ///
    /// # Errors
    /// If there is no equilibrium nearby or its stiffness is singular.
    pub fn new(
        eom: &'a E,
        mut newton: Newton,
        steps: ArcSteps,
        mut start: State,
    ) -> Result<Self, EquilibriumError> {
        start.v.fill(0.0);
        start.a.fill(0.0);
        newton.bear(PATIENCE);
        let load = start.load;
        let mut eom = Current::new(eom);
        let mut begin = |newton: &mut Newton, start: &mut State| {
            loop {
                let found = Equilibrium::find(newton, &mut Whole, &*eom, start)?;
                let Some((complete, matrix)) = eom.completed(start) else {
                    return response(newton, &*eom, start).map_err(|failure| found.refuse(failure, start));
                };
                eom.replace(complete);
                newton.adopt(matrix)?;
            }
        };
        let response = begin(&mut newton, &mut start).map_err(|cause| EquilibriumError {
            reached: load,
            load,
            cause,
        })?;
        let metric = Metric::new(&*eom, &start, newton.tangent.matrix.clone(), &response);
        let tangent = metric.tangent(response, start.q.len());
        newton.met(eom.energy(&start).largest());
        let unstable = newton.unstable(&*eom);
        let ahead = Tangent::zero(tangent.z.len());
        let (trial, step) = (start.clone(), steps.first);
        Ok(Self {
            eom,
            newton,
            steps,
            metric,
            state: start,
            tangent,
            trial,
            ahead,
            step,
            length: 0.0,
            unstable,
            doubt: None,
            heading: 1.0,
        })
    }

    /// Reverses the path, in the direction of decreasing load.
    #[must_use]
    pub fn reversed(mut self) -> Self {
        self.tangent.scale(-1.0);
        self.heading = -self.heading;
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
        until: &Until,
        mut each: impl FnMut(&State, &PathPoint) -> ControlFlow<()>,
    ) -> Result<Left, EquilibriumError> {
        let end = self.length + until.length;
        for _ in 0..until.points {
            let left = end - self.length;
            let arrival = self.advance(until.load, left)?;
            let last = arrival.length >= left;
            let landed = arrival.landed;
            let point = self.arrive(arrival);
            if each(&self.state, &point).is_break() {
                return Ok(Left::Broken);
            }
            if landed {
                return Ok(Left::Load);
            }
            if last {
                return Ok(Left::Length);
            }
        }
        Ok(Left::Points)
    }

    /// Accepts the trial point as the current point.
    fn arrive(&mut self, arrival: Arrival) -> PathPoint {
        self.newton.met(arrival.found.energy.largest());
        self.state.copy_from(&self.trial);
        std::mem::swap(&mut self.tangent, &mut self.ahead);
        self.length += arrival.length;
        self.unstable = arrival.unstable;
        if arrival.limit.is_some() {
            self.heading = -self.heading;
        }
        let (slope, limit) = (self.tangent.load, arrival.limit);
        PathPoint { equilibrium: arrival.found, length: self.length, slope, limit }
    }

    /// Computes the next point in the trial state by a step of at most `left`.
    fn advance(&mut self, target: Option<f64>, left: f64) -> Result<Arrival, EquilibriumError> {
        let mut found = Equilibrium::default();
        loop {
            let step = self.step.min(self.steps.largest).min(left);
            match self.reach(step, target) {
                Ok((arrival, iterations)) => {
                    let wanted = f64::from(self.steps.iterations) / f64::from(iterations.max(1));
                    self.step = step * wanted.sqrt().clamp(0.5, 2.0);
                    if arrival.unstable != self.unstable {
                        // The stability change is confirmed, so the path continues with the original step size.
                        self.step = self.doubt.take().unwrap_or(self.step);
                    }
                    // Otherwise the path has turned away from the bifurcation.
                    self.doubt = self.doubt.filter(|first| step < *first);
                    return Ok(Arrival { found: found.after(arrival.found), ..arrival });
                }
                Err(cause) => {
                    found.failed(&cause);
                    if cause.failure == Failure::Unstable {
                        self.doubt.get_or_insert(step);
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
    fn reach(&mut self, step: f64, target: Option<f64>) -> Result<(Arrival, u32), SolveError> {
        let found = self.attempt(step)?;
        let (iterations, unstable) = (found.iterations, found.unstable);
        let mut arrival = Arrival { found, length: step, limit: None, landed: false, unstable };
        if self.hides_limits(step) {
            return Err(found.refuse(Failure::Turned, &self.trial));
        }
        let doubtful = self.doubt.is_none_or(|first| step > BELIEVED * first);
        if doubtful && self.hides_bifurcation(unstable) {
            return Err(found.refuse(Failure::Unstable, &self.trial));
        }
        if self.ahead.load * self.heading < 0.0 {
            let start = self.heading * self.tangent.load.abs();
            let largest = self.state.load.abs().max(self.trial.load.abs());
            // The load falls short of its limit by slope²/2 |curvature|.
            self.locate(
                &mut arrival,
                start,
                |_, ahead| ahead.load,
                |slope, curvature| 0.5 * slope * slope <= LIMIT * largest * curvature.abs(),
            )?;
            arrival.limit = Some(if self.heading > 0.0 { Limit::Maximum } else { Limit::Minimum });
        }
        if let Some(target) = target {
            let (before, after) = (self.state.load - target, self.trial.load - target);
            if before * after < 0.0 || (after == 0.0 && before != 0.0) {
                let close = 1e-3 * (before - after).abs();
                let mut landing = Arrival { found: arrival.found, ..arrival };
                self.locate(&mut landing, before, |s, _| s.load - target, |miss, _| miss.abs() <= close)?;
                self.land(target, &mut landing)?;
                let unstable = landing.found.unstable;
                arrival = Arrival { limit: None, landed: true, unstable, ..landing };
            }
        }
        Ok((arrival, iterations))
    }

    /// Returns true if the load factor may have two extrema within a step, which its end slopes do not show.
    ///
    /// A cubic with end slopes of equal sign is monotone if both are at most three times the mean slope (Fritsch &
    /// Carlson 1980).
    fn hides_limits(&self, step: f64) -> bool {
        let mean = (self.trial.load - self.state.load) / step * self.heading;
        let [before, after] = [self.tangent.load, self.ahead.load].map(|slope| slope * self.heading);
        after > 0.0 && before.max(after) > 3.0 * mean
    }

    /// Returns true if the stability change does not match the limit points of the step.
    ///
    /// A bifurcation causes such a change. Sufficiently small steps follow the path of an imperfect structure around
    /// it.
    fn hides_bifurcation(&self, unstable: Option<usize>) -> bool {
        let limits = usize::from(self.ahead.load * self.heading < 0.0);
        matches!((self.unstable, unstable), (Some(before), Some(after)) if before.abs_diff(after) != limits)
    }

    /// Solves for the equilibrium at a length σ beyond the current point, and for its tangent.
    fn attempt(&mut self, length: f64) -> Result<Equilibrium, SolveError> {
        if let Some((eom, matrix)) = self.eom.ahead(&self.state) {
            self.renew(eom, matrix)?;
        }
        let mut found = Equilibrium::default();
        loop {
            self.trial.copy_from(&self.state);
            self.tangent.move_by(length, &mut self.trial);
            let Self { newton, eom, tangent, trial, .. } = self;
            found = found.again(Equilibrium::find(newton, &mut Plane(tangent), &**eom, trial)?);
            let Some((eom, matrix)) = eom.completed(trial) else { return self.look_ahead(found) };
            // A term that is active there was not included.
            self.renew(eom, matrix)?;
        }
    }

    fn renew(&mut self, eom: E, matrix: SparseMatrix) -> Result<(), SolveError> {
        self.eom.replace(eom);
        self.newton.adopt(matrix)
    }

    /// Computes the tangent at the trial state.
    fn look_ahead(&mut self, mut found: Equilibrium) -> Result<Equilibrium, SolveError> {
        let response = response(&mut self.newton, &*self.eom, &mut self.trial)
            .map_err(|failure| found.refuse(failure, &self.trial))?;
        found.unstable = self.newton.unstable(&*self.eom);
        self.ahead = self.metric.tangent(response, self.trial.q.len());
        if self.ahead.product(&self.tangent) < 0.0 {
            self.ahead.scale(-1.0);
        }
        let chord = self.metric.distance(&self.state, &self.trial);
        let along = self.tangent.length(&self.state, &self.trial);
        if self.ahead.product(&self.tangent) < TURN || along < BEND * chord {
            return Err(found.refuse(Failure::Turned, &self.trial));
        }
        Ok(found)
    }

    /// Shortens a step to the root of `value`, which is `start` at the start and has the opposite sign at the end.
    ///
    /// The method is regula falsi in the Illinois form. `done` evaluates a value and its slope along the path.
    fn locate(
        &mut self,
        arrival: &mut Arrival,
        start: f64,
        value: impl Fn(&State, &Tangent) -> f64,
        done: impl Fn(f64, f64) -> bool,
    ) -> Result<(), SolveError> {
        let (mut a, mut at_a) = (0.0, start);
        let (mut b, mut at_b) = (arrival.length, value(&self.trial, &self.ahead));
        for _ in 0..LOCATE {
            if done(at_b, (at_b - at_a) / (b - a)) {
                arrival.length = b;
                return Ok(());
            }
            let length = b - at_b * (b - a) / (at_b - at_a);
            arrival.found = arrival.found.after(self.attempt(length)?);
            let at_length = value(&self.trial, &self.ahead);
            if at_length * at_b < 0.0 {
                (a, at_a) = (b, at_b);
            } else {
                at_a *= 0.5;
            }
            (b, at_b) = (length, at_length);
        }
        Err(arrival.found.refuse(Failure::NotConverged, &self.trial))
    }

    /// Moves the trial state to a nearby load factor.
    fn land(&mut self, target: f64, arrival: &mut Arrival) -> Result<(), SolveError> {
        self.trial.load = target;
        let mut found = Equilibrium::find(&mut self.newton, &mut Whole, &*self.eom, &mut self.trial)?;
        while let Some((eom, matrix)) = self.eom.completed(&self.trial) {
            self.renew(eom, matrix)?;
            found =
                found.again(Equilibrium::find(&mut self.newton, &mut Whole, &*self.eom, &mut self.trial)?);
        }
        arrival.found = arrival.found.after(self.look_ahead(found)?);
        arrival.length = self.tangent.length(&self.state, &self.trial);
        Ok(())
    }
}
