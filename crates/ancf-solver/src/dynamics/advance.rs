use super::damping_work::PowerIntegral;
use super::integration_state::DividedStep;
use super::start::{Factors, Projected, accelerations, project};
use super::step_change::adapt;
use super::step_report::StepReport;
use super::time_stepper::TimeStepper;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::{Newton, SolveError};

/// Growth of an undamped step above which the scheme restarts.
const LARGEST_GROWTH: f64 = 4.0;

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
            let adapted = self.adapt_to(h);
            match adapted.and_then(|()| self.attempt(h, to - (left - 1) as f64 * h)) {
                Ok(done) => {
                    self.accept(&done, &mut report);
                    left -= 1;
                    self.motion.divided = (left > 0).then_some(DividedStep { to, h, left, halvings, report });
                    accepted(&self.motion.state);
                }
                Err(error) => {
                    self.restore_memory();
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
        let before = (self.motion.h > 0.0).then(|| self.motion.state.a.clone());
        self.restart_after(0.0, t)?;
        if before.is_some() {
            self.motion.before_jump = before;
        }
        Ok(())
    }

    /// Moves the state to a time at a distance that is too small for a step, and computes consistent accelerations and multipliers.
    ///
    /// A step h divides rounding errors of the positions by h². The positions and velocities of a Taylor series have no such error;
    /// they lack terms of the order h³ and h².
    ///
    /// # Errors
    /// As [`restart`](Self::restart).
    pub fn extrapolate(&mut self, to: f64) -> Result<(), SolveError> {
        let h = to - self.motion.state.t;
        let has_memory = self.motion.h > 0.0 && self.scheme.averaging.is_none();
        if has_memory { self.continue_after(h, to) } else { self.restart_after(h, to) }
    }

    /// Computes consistent accelerations and multipliers after a step in which rounding errors of the positions are large.
    ///
    /// # Errors
    /// As [`restart`](Self::restart).
    pub fn renew_accelerations(&mut self) -> Result<(), SolveError> {
        let t = self.motion.state.t;
        if self.motion.reference.is_none() { self.restart_after(0.0, t) } else { self.continue_after(0.0, t) }
    }

    /// Restarts at a time t after a Taylor series over the distance h.
    fn restart_after(&mut self, h: f64, t: f64) -> Result<(), SolveError> {
        self.revertible(|own| {
            let before = own.motion.energy;
            own.remove_velocity_error();
            own.move_by_series(h, t)?;
            let Newton { tangent, z, .. } = &mut own.newton;
            let (matrix, factor) = tangent.lend();
            let factors =
                project(&*own.eom, matrix, factor, &mut own.motion.state, Projected::Velocities, z)?;
            own.motion.energy = own.eom.energy(&own.motion.state);
            if h > 0.0 {
                own.motion.exchanged.work += own.motion.energy.total() - before.total();
            } else if own.motion.h > 0.0 || own.motion.at_start {
                // Work of the impulses of a jump, with the mean velocity.
                own.motion.exchanged.work += own.motion.energy.kinetic - before.kinetic;
            }
            accelerations(&*own.eom, matrix, factor, &mut own.motion.state, z, factors)?;
            own.motion.restart_scheme();
            own.set_exchange();
            Ok(())
        })
    }

    /// Computes consistent accelerations at a time t after a Taylor series over the distance h. The scheme continues.
    fn continue_after(&mut self, h: f64, t: f64) -> Result<(), SolveError> {
        self.revertible(|own| {
            let before = own.motion.energy;
            let pairs = own.attempted[0].iter_mut().zip(&own.motion.auxiliary).zip(&own.motion.state.a);
            pairs.for_each(|((lead, auxiliary), a)| *lead = auxiliary - a);
            own.move_by_series(h, t)?;
            own.motion.energy = own.eom.energy(&own.motion.state);
            own.motion.exchanged.work += own.motion.energy.total() - before.total();
            let Newton { tangent, z, .. } = &mut own.newton;
            let (matrix, factor) = tangent.lend();
            let state = &mut own.motion.state;
            accelerations(&*own.eom, matrix, factor, state, z, Factors::OfOtherState)?;
            let pairs = own.motion.auxiliary.iter_mut().zip(&own.attempted[0]).zip(&own.motion.state.a);
            pairs.for_each(|((auxiliary, lead), a)| *auxiliary = a + lead);
            let power = own.eom.exchange(&own.motion.state, &mut own.damping.force);
            own.motion.power.replace(power);
            own.motion.damping.replace(&own.damping.force);
            Ok(())
        })
    }

    /// Performs a change to consistent accelerations that reverts to the present state if it fails.
    fn revertible(
        &mut self,
        change: impl FnOnce(&mut Self) -> Result<(), SolveError>,
    ) -> Result<(), SolveError> {
        self.before.copy_from(&self.motion.state);
        let (energy, exchanged) = (self.motion.energy, self.motion.exchanged);
        let done = change(self);
        match done {
            Ok(()) => {
                self.motion.predictor.restart();
                self.motion.restart_errors(true);
                self.save_restart_point();
            }
            Err(_) => {
                self.revert();
                (self.motion.energy, self.motion.exchanged) = (energy, exchanged);
            }
        }
        done
    }

    /// Removes the error of the velocities along constraints at the end of a step. It remains if the iteration matrix is singular.
    fn remove_velocity_error(&mut self) {
        if self.motion.h > 0.0 {
            let part = Projected::SlowVelocities(self.scheme.weights(self.motion.h));
            let Newton { tangent, z, .. } = &mut self.newton;
            let (matrix, factor) = tangent.lend();
            let _ = project(&*self.eom, matrix, factor, &mut self.motion.state, part, z);
        }
    }

    /// Moves positions and velocities by a Taylor series over the distance h to the time t.
    fn move_by_series(&mut self, h: f64, t: f64) -> Result<(), SolveError> {
        let state = &mut self.motion.state;
        if h > 0.0 {
            for ((q, v), a) in state.q.iter_mut().zip(&mut state.v).zip(&state.a) {
                *q += h * (*v + 0.5 * h * a);
                *v += h * a;
            }
        }
        state.t = t;
        self.include_near_terms()
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

    /// Adapts the memory of the scheme to a step h of another size than the last one, until the step is accepted or
    /// [`restore_memory`](Self::restore_memory) is called.
    pub(crate) fn adapt_to(&mut self, h: f64) -> Result<(), SolveError> {
        if !self.motion.memory().changes_with(h, self.scheme) {
            return Ok(());
        }
        self.include_near_terms()?;
        let memory = self.motion.memory();
        if self.scheme.is_conservative() && h > LARGEST_GROWTH * *memory.h {
            // Errors of accelerations along constraints after short steps would remain.
            return self.restart(self.motion.state.t);
        }
        self.last_memory = Some(memory.save());
        adapt(&*self.eom, &mut self.newton, self.scheme, memory, h)
    }

    /// Restores the memory of the scheme if it was adapted to a step that was not accepted.
    pub(crate) fn restore_memory(&mut self) {
        if let Some(last) = self.last_memory.take() {
            self.motion.memory().restore(*last);
        }
    }

    /// Sets powers and damping forces of a start.
    fn set_exchange(&mut self) {
        let power = self.eom.exchange(&self.motion.state, &mut self.damping.force);
        self.motion.power = PowerIntegral::new(power);
        self.motion.damping.restart(&self.damping.force);
    }
}
