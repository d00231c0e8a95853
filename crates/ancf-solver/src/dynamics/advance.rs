use super::damping_work::PowerIntegral;
use super::integration_state::DividedStep;
use super::start::{Projected, accelerations, project};
use super::step_report::StepReport;
use super::time_stepper::TimeStepper;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::{Newton, SolveError};

/// Relative difference of step sizes up to which they count as equal.
const SAME: f64 = 0.01;
/// Smallest ratio of step sizes up to which velocities are scaled.
const NEAR: f64 = 0.25;

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Advances to the time `to`, in one step or in 2, 4, 8, ... equal substeps if Newton's method fails.
    ///
    /// Afterwards the step size doubles with each step up to its full size.
    ///
    /// # Errors
    /// If the smallest permitted step fails. The state is then that of the last converged substep. A repeated call
    /// resumes the step there.
    pub fn advance(&mut self, to: f64) -> Result<StepReport, SolveError> {
        self.advance_with(to, |_| ())
    }

    /// Advances as [`advance`](Self::advance); `accepted` receives the state after each accepted substep.
    ///
    /// # Errors
    /// As [`advance`](Self::advance).
    pub fn advance_with(
        &mut self,
        to: f64,
        mut accepted: impl FnMut(&State),
    ) -> Result<StepReport, SolveError> {
        let divided = self.motion.divided.filter(|divided| divided.to == to);
        let DividedStep { mut h, mut left, mut halvings, mut report, .. } = divided.unwrap_or_else(|| {
            let halvings = self.motion.halvings.min(self.max_halvings);
            let h = (to - self.motion.state.t) / f64::from(halvings).exp2();
            DividedStep { to, h, left: 1_u64 << halvings, halvings, report: StepReport::default() }
        });
        while left > 0 {
            let adapted = self.adapt_velocities(h);
            match adapted.and_then(|()| self.attempt(h, to - (left - 1) as f64 * h)) {
                Ok(done) => {
                    self.accept(&done, &mut report);
                    left -= 1;
                    self.motion.divided = (left > 0).then_some(DividedStep { to, h, left, halvings, report });
                    accepted(&self.motion.state);
                }
                Err(error) => {
                    report.iterations += error.iterations;
                    if halvings == self.max_halvings || error.is_final() {
                        return Err(error);
                    }
                    (h, left, halvings) = (0.5 * h, 2 * left, halvings + 1);
                }
            }
        }
        self.motion.halvings = halvings.saturating_sub(1);
        Ok(report)
    }

    /// Returns the end time of a divided step that is not complete.
    pub fn pending_time(&self) -> Option<f64> {
        self.motion.divided.map(|divided| divided.to)
    }

    /// Restarts at a time t with the current q and v: at the start, and at jumps of loads or prescribed motions.
    ///
    /// Velocities are projected onto Φ_q v + Φ_t = 0. Accelerations and multipliers follow from the equations of
    /// motion, and the scheme computes its start values. The last step before a jump must end at `t.next_down()`, where
    /// the loads have not jumped.
    ///
    /// # Errors
    /// If the mass matrix with the constraints is singular. The state is then unchanged.
    pub fn restart(&mut self, t: f64) -> Result<(), SolveError> {
        self.restart_after(0.0, t)
    }

    /// Moves the state to a time at a distance that is too small for a step, and restarts there.
    ///
    /// A step h divides rounding errors of the positions by h². The positions and velocities of a Taylor series have no such error;
    /// they lack terms of the order h³ and h².
    ///
    /// # Errors
    /// As [`restart`](Self::restart).
    pub fn extrapolate(&mut self, to: f64) -> Result<(), SolveError> {
        self.restart_after(to - self.motion.state.t, to)
    }

    /// Restarts at a time t after a Taylor series over the distance h.
    fn restart_after(&mut self, h: f64, t: f64) -> Result<(), SolveError> {
        self.before.copy_from(&self.motion.state);
        let (energy, exchanged) = (self.motion.energy, self.motion.exchanged);
        let done = self.start_after(h, t);
        match done {
            Ok(()) => self.save_restart_point(),
            Err(_) => {
                self.revert();
                (self.motion.energy, self.motion.exchanged) = (energy, exchanged);
            }
        }
        done
    }

    fn start_after(&mut self, h: f64, t: f64) -> Result<(), SolveError> {
        let state = &mut self.motion.state;
        if h > 0.0 {
            for ((q, v), a) in state.q.iter_mut().zip(&mut state.v).zip(&state.a) {
                *q += h * (*v + 0.5 * h * a);
                *v += h * a;
            }
        }
        state.t = t;
        self.include_near_terms()?;
        let Newton { tangent, z, .. } = &mut self.newton;
        let (matrix, factor) = tangent.lend();
        let before = self.motion.energy;
        let state = &mut self.motion.state;
        let factors = project(&*self.eom, matrix, factor, state, Projected::Velocities, z)?;
        self.motion.energy = self.eom.energy(&self.motion.state);
        if h > 0.0 {
            self.motion.exchanged.work += self.motion.energy.total() - before.total();
        } else if self.motion.h > 0.0 || self.motion.at_start {
            // Work of the impulses of a jump, with the mean velocity.
            self.motion.exchanged.work += self.motion.energy.kinetic - before.kinetic;
        }
        accelerations(&*self.eom, matrix, factor, &mut self.motion.state, z, factors)?;
        self.motion.auxiliary.copy_from_slice(&self.motion.state.a);
        self.set_exchange();
        (self.motion.h, self.motion.h_of_velocities) = (0.0, 0.0);
        self.motion.at_start = true;
        self.motion.predictor.restart();
        self.motion.restart_errors(true);
        Ok(())
    }

    /// Projects velocities onto Φ_q v + Φ_t = 0. Accelerations and multipliers remain unchanged.
    ///
    /// # Errors
    /// If the mass matrix with the constraints is singular.
    pub fn project_velocities(&mut self) -> Result<(), SolveError> {
        let Newton { tangent, z, .. } = &mut self.newton;
        let (matrix, factor) = tangent.lend();
        project(&*self.eom, matrix, factor, &mut self.motion.state, Projected::Velocities, z)?;
        self.motion.energy = self.eom.energy(&self.motion.state);
        self.set_exchange();
        // The accelerations are not those of the damping forces.
        self.motion.damping.clear();
        self.motion.restart_errors(false);
        self.save_restart_point();
        Ok(())
    }

    /// Adapts the velocities along constraints to a step h of another size than the last one, or restarts.
    ///
    /// Positions satisfy the constraints after each step, velocities only up to an error of the order h². In steps of one size this
    /// error has a smooth limit, and accelerations are of second order. After a step H it would change the accelerations of a
    /// step h by (H² − h²)/(β h), and an alternation of both sizes would be unstable. The error is therefore scaled by
    /// (h/H)². Over large ratios, errors of other kinds would be scaled as well.
    ///
    /// The change of the kinetic energy is part of the energy that the next step makes or loses.
    pub(crate) fn adapt_velocities(&mut self, h: f64) -> Result<(), SolveError> {
        let last = self.motion.h_of_velocities;
        let is_constrained = !self.motion.state.lambda.is_empty() && self.scheme.averaging.is_none();
        if last == 0.0 || !is_constrained || (h / last - 1.0).abs() <= SAME {
            return Ok(());
        }
        let ratio = h / last;
        if !(NEAR..=1.0 / NEAR).contains(&ratio) {
            return self.restart(self.motion.state.t);
        }
        let Newton { tangent, z, .. } = &mut self.newton;
        let (matrix, factor) = tangent.lend();
        z.fill(0.0);
        project(&*self.eom, matrix, factor, &mut self.motion.state, Projected::Velocities, z)?;
        let velocities = self.motion.state.v.iter_mut();
        velocities.zip(z.iter()).for_each(|(v, change)| *v -= ratio * ratio * change);
        self.motion.h_of_velocities = h;
        Ok(())
    }

    /// Sets powers and damping forces of a start.
    fn set_exchange(&mut self) {
        let power = self.eom.exchange(&self.motion.state, &mut self.damping.force);
        self.motion.power = PowerIntegral::new(power);
        self.motion.damping.restart(&self.damping.force);
    }
}
