use super::integration_state::IntegrationState;
use super::scheme::SchemeCoefficients;
use super::time_stepper::TimeStepper;
use crate::equations::{EquationsOfMotion, State};
use crate::newton::{ActiveSet, Newton, SolveError};

impl<E: EquationsOfMotion> TimeStepper<'static, E> {
    /// Starts from a state as [`new`](Self::new), with equations of its own.
    pub fn owning(
        eom: E,
        scheme: SchemeCoefficients,
        newton: Newton,
        max_halvings: u32,
        start: State,
    ) -> Self {
        Self::with_equations(ActiveSet::owned(eom), scheme, newton, max_halvings, start)
    }
}

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Returns the present equations, with the terms that are active or near.
    pub fn equations(&self) -> &E {
        &self.eom
    }

    /// Continues from another state at its time, as at a start: velocities are projected onto the constraints, accelerations and
    /// multipliers are computed, and the energy balance begins anew. The positions must satisfy the constraints.
    ///
    /// # Errors
    /// If the mass matrix with the constraints is singular. The integration is then unchanged.
    pub fn set_state(&mut self, s: &State) -> Result<(), SolveError> {
        let errors = self.motion.errors.clone();
        let new = IntegrationState { errors, ..IntegrationState::new(s.clone(), &*self.eom) };
        let former = std::mem::replace(&mut self.motion, new);
        let set = self.restart(s.t);
        if set.is_err() {
            self.motion = former;
        }
        set
    }
}
