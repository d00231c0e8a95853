use ancf_solver::equations::{EquationsOfMotion, State};
use nalgebra::DVector;

use crate::stepping::stepper::Stepper;

/// Displacement of finite differences, relative to the length of the model.
const DIFFERENCE: f64 = 1e-6;

impl Stepper {
    /// Residuals of the coordinates in a state.
    pub(super) fn forces_at(&self, s: &State) -> DVector<f64> {
        let mut r = vec![0.0; s.q.len() + s.lambda.len()];
        self.dynamics.equations().residual(s, &mut r);
        r.truncate(s.q.len());
        DVector::from_vec(r)
    }

    /// Step of finite differences along a direction.
    pub(super) fn difference(&self, direction: &DVector<f64>) -> f64 {
        DIFFERENCE * self.simulation.scaled.length() / direction.amax().max(f64::MIN_POSITIVE)
    }

    /// Central difference of a function along directions of positions and of velocities.
    pub(super) fn central(
        &self,
        s: &State,
        dq: &DVector<f64>,
        dv: Option<&DVector<f64>>,
        of: impl Fn(&State) -> DVector<f64>,
    ) -> DVector<f64> {
        let h = dv.map_or_else(|| self.difference(dq), |dv| self.difference(dq).min(self.difference(dv)));
        let moved = |h: f64| {
            let mut there = s.clone();
            there.q.iter_mut().zip(dq.iter()).for_each(|(q, dq)| *q += h * dq);
            if let Some(dv) = dv {
                there.v.iter_mut().zip(dv.iter()).for_each(|(v, dv)| *v += h * dv);
            }
            of(&there)
        };
        (moved(h) - moved(-h)) / (2.0 * h)
    }
}
