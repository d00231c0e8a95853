use super::integration_state::{CheckpointMismatch, StepperCheckpoint};
use super::time_stepper::TimeStepper;
use crate::equations::EquationsOfMotion;

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Returns the saved state as of the last accepted step.
    pub fn checkpoint(&self) -> StepperCheckpoint {
        let active = self.active.clone().unwrap_or_else(|| self.eom.active_groups());
        StepperCheckpoint { motion: self.motion.clone(), active, newton: self.newton.checkpoint() }
    }

    /// Resumes from a saved state. Later steps are bit-identical.
    ///
    /// # Errors
    /// If the saved state does not belong to this integration. The integration is then in an undefined state.
    pub fn restore(&mut self, checkpoint: &StepperCheckpoint) -> Result<(), CheckpointMismatch> {
        let StepperCheckpoint { motion, active, newton } = checkpoint;
        let (n, m) = (self.eom.coordinates(), self.eom.multipliers());
        if !motion.is_valid(n, m, self.max_halvings) || !self.newton.accepts(newton, n, m) {
            return Err(CheckpointMismatch);
        }
        if *active != self.eom.active_groups() {
            let (eom, matrix) = self.eom.with_groups(active).ok_or(CheckpointMismatch)?;
            self.replace_equations(eom, matrix).map_err(|_| CheckpointMismatch)?;
        }
        self.motion = motion.clone();
        let mut residual = vec![0.0; n + m];
        self.eom.residual(&self.motion.state, &mut residual);
        let is_finite = residual.iter().all(|x| x.is_finite());
        let recalled = self.newton.restore(&*self.eom, newton);
        self.save_restart_point();
        if is_finite && recalled.is_ok() { Ok(()) } else { Err(CheckpointMismatch) }
    }
}
