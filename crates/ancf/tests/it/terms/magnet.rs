//! Load with a stiffness.

use ancf::solver::equations::{Local, LocalMatrix, Term, Weights};

/// Load proportional to the displacement of its point, in parallel with a spring.
pub(super) struct Magnet;

impl Term for Magnet {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += (5.0 - 3.0 * at.load) * at.q[0];
    }

    fn rounding(&self, _: &Local<'_>, _: &mut [f64]) {}

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.q * (5.0 - 3.0 * at.load));
    }
}
