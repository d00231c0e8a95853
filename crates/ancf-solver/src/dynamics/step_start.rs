use super::time_stepper::TimeStepper;
use crate::equations::{EquationsOfMotion, State};

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Returns the start of the last step of the energy-momentum scheme, with the accelerations and multipliers of its middle, as the
    /// current state has them. `None` at a start and for other schemes, whose accelerations and multipliers belong to the end.
    pub fn step_start(&self) -> Option<State> {
        let has_step = self.scheme.averaging.is_some() && !self.motion.at_start && self.motion.h > 0.0;
        has_step.then(|| self.motion.state.start_of_step(self.motion.h))
    }
}
