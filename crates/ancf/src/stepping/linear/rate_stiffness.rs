use ancf_solver::equations::State;
use nalgebra::{DMatrix, DVector};

use crate::stepping::stepper::Stepper;

/// Relative deviation of a product up to which the assembled stiffness is complete: the error of the finite differences.
const COMPLETE: f64 = 1e-8;

impl Stepper {
    /// Completes the stiffness ∂f/∂q in a moving state by the derivatives of the forces g(q, v) = f(q, v) − f(q, 0) of velocities.
    ///
    /// Tangents of viscous forces lack the derivatives of their directions and of the strain rates by q, which are not symmetric:
    /// Newton's method does not need them. `assembled` is ∂f/∂q with the velocities of `s`, and `at_rest` that without velocities. If
    /// a product with their difference deviates from the finite difference of g, columns of finite differences replace the
    /// difference. Forces of stiff bodies at rest, whose rounding errors are large, are not differentiated.
    pub(super) fn complete_rate_stiffness(
        &self,
        s: &State,
        assembled: DMatrix<f64>,
        at_rest: &DMatrix<f64>,
    ) -> DMatrix<f64> {
        let n = s.q.len();
        let forces = |moved: &State| {
            let mut still = moved.clone();
            still.v.fill(0.0);
            self.forces_at(moved) - self.forces_at(&still)
        };
        let derivative = |direction: DVector<f64>| self.central(s, &direction, None, forces);
        // No entry of the direction is zero.
        let test = DVector::from_fn(n, |i, _| 1.0 + (i as f64 + 1.0).sin().abs());
        let (found, expected) = (derivative(test.clone()), (&assembled - at_rest) * &test);
        let size = ((&assembled - at_rest).abs() * &test).amax().max(found.amax());
        if (found - expected).amax() <= COMPLETE * size {
            return assembled;
        }
        let mut stiffness = at_rest.clone();
        for j in 0..n {
            let unit = DVector::from_fn(n, |i, _| if i == j { 1.0 } else { 0.0 });
            let mut column = stiffness.column_mut(j);
            column += derivative(unit);
        }
        stiffness
    }
}
