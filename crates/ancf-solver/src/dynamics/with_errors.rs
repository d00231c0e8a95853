use super::errors::MotionErrors;
use super::time_stepper::TimeStepper;
use crate::equations::EquationsOfMotion;

impl<E: EquationsOfMotion> TimeStepper<'_, E> {
    /// Estimates the errors of the motion from the current state on, which is exact. `has_mesh` includes the errors of the mesh.
    ///
    /// `sizes` has the size of each coordinate, such as a length for positions and 1 for directions and angles.
    /// The energy-momentum scheme has no estimate. The estimate does not change the motion.
    #[must_use]
    pub fn with_errors(mut self, sizes: Vec<f64>, has_mesh: bool) -> Self {
        if self.scheme.averaging.is_none() {
            self.motion.errors = Some(Box::new(MotionErrors::new(&self.motion.state, sizes, has_mesh)));
        }
        self
    }

    /// Returns the estimated errors of the current state, if they are computed.
    pub fn errors(&self) -> Option<&MotionErrors> {
        self.motion.errors.as_deref()
    }

    /// Sets the forces, over the coordinates, that cause the errors of the mesh in the current state. Returns their relative difference
    /// from the extrapolation of the last two sets, if there is one.
    ///
    /// Later steps extrapolate the last two sets linearly.
    pub fn set_mesh_forces(&mut self, forces: &[f64]) -> Option<f64> {
        let t = self.motion.state.t;
        self.motion.errors.as_mut()?.set_forces(t, forces)
    }
}
