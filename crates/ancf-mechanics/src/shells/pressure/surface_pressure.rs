use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::Matrix3;

use super::surface_patch::SurfacePatch;
use crate::functions::Function;

/// Pressure on an element that follows its normal: adds −s f(t) p ∫ N_a r_ξ × r_η dξ dη.
///
/// A positive pressure acts along r_ξ × r_η. The load has no potential at a free edge. Its derivative is not symmetric there; the
/// tangent contains the symmetric part. The work counts as supplied work.
#[derive(Clone, Debug)]
pub(super) struct SurfacePressure<const N: usize> {
    patch: SurfacePatch<N>,
    pressure: f64,
    function: Function,
}

impl<const N: usize> SurfacePressure<N> {
    pub(super) fn new(patch: SurfacePatch<N>, pressure: f64, function: &Function) -> Self {
        Self { patch, pressure, function: function.clone() }
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t) * self.pressure
    }

    /// Returns blocks ∂f_a/∂q_b of the force without its sign and factor.
    fn derivative(&self, q: &[f64]) -> Box<[[Matrix3<f64>; N]; N]> {
        let mut blocks = Box::new([[Matrix3::zeros(); N]; N]);
        self.patch.each(q, |[n, x, y], weight, [_, t, s]| {
            let (t, s) = (t.cross_matrix(), s.cross_matrix());
            for b in 0..N {
                let turned = t * y[b] - s * x[b];
                for a in 0..N {
                    blocks[a][b] += turned * (weight * n[a]);
                }
            }
        });
        blocks
    }
}

impl<const N: usize> Term for SurfacePressure<N> {
    fn coordinates(&self) -> &[usize] {
        self.patch.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let factor = -self.factor(at);
        self.patch.each(at.q, |[n, ..], weight, [_, t, s]| {
            let force = t.cross(&s) * (factor * weight);
            for (a, n) in n.iter().enumerate() {
                (0..3).for_each(|i| r[3 * a + i] += n * force[i]);
            }
        });
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let factor = 8.0 * f64::EPSILON * self.factor(at).abs();
        self.patch.each_size(at.q, |[n, ..], weight, [_, t, s]| {
            for (a, n) in n.iter().enumerate() {
                (0..3).for_each(|i| floor[3 * a + i] += n.abs() * t * s * factor * weight);
            }
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let factor = -0.5 * w.q * self.factor(at);
        if factor == 0.0 {
            return;
        }
        let blocks = self.derivative(at.q);
        for row in 0..3 * N {
            for column in 0..=row {
                let (a, i, b, j) = (row / 3, row % 3, column / 3, column % 3);
                k.add(row, column, factor * (blocks[a][b][(i, j)] + blocks[b][a][(j, i)]));
            }
        }
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let (factor, blocks) = (-0.5 * self.factor(at), self.derivative(at.q));
        if factor == 0.0 {
            return;
        }
        let largest = blocks.iter().flatten().map(|block| block.amax()).fold(0.0, f64::max);
        for row in 0..3 * N {
            for column in 0..row {
                let (a, i, b, j) = (row / 3, row % 3, column / 3, column % 3);
                let value = blocks[a][b][(i, j)] - blocks[b][a][(j, i)];
                if value.abs() > 1e-14 * largest {
                    visit(row, column, factor * value);
                }
            }
        }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
