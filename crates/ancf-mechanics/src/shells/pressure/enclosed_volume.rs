use std::ops::Range;

use ancf_solver::equations::{LOCAL, Level, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::Vector3;

use super::surface_patch::SurfacePatch;

/// Change of a volume V that surfaces enclose, as one constraint with the multiplier λ: part of one element.
///
/// Φ = Σ_e [V_e(q) − V_e(0)] − v, V_e = ± ⅓ ∫ r · (r_ξ × r_η) dξ dη, with r relative to a fixed origin. [`GasPressure`](super::GasPressure) has the massless
/// coordinate v. All elements share the multiplier, which is minus the pressure in excess of that outside. The forces λ ∂V/∂q are those
/// of this pressure on a closed surface. A surface with an opening is closed by the lines from its edge to the origin, and the edge
/// carries the share of the pressure on these lines.
///
/// Units: volume; λ is a pressure.
#[derive(Clone, Debug)]
pub struct EnclosedVolume<const N: usize> {
    patch: SurfacePatch<N>,
    /// 1 if r_ξ × r_η points out of the volume, otherwise −1.
    sign: f64,
    multiplier: usize,
    /// V_e in the reference state.
    reference: f64,
}

impl<const N: usize> EnclosedVolume<N> {
    /// Creates the part of an element whose normal r_ξ × r_η points out of the volume or, if `reversed`, into it.
    pub fn new(patch: SurfacePatch<N>, reversed: bool, multiplier: usize) -> Self {
        let sign = if reversed { -1.0 } else { 1.0 };
        let part = Self { patch, sign, multiplier, reference: 0.0 };
        let reference = part.volume(&[0.0; LOCAL]);
        Self { reference, ..part }
    }

    /// Returns V_e in the reference state.
    pub const fn reference_volume(&self) -> f64 {
        self.reference
    }

    fn volume(&self, q: &[f64]) -> f64 {
        let mut sum = 0.0;
        self.patch.each(q, |_, weight, [r, t, s]| sum += weight * r.dot(&t.cross(&s)));
        self.sign * sum / 3.0
    }

    /// Adds a multiple of ∂V_e/∂q.
    fn add_gradient(&self, q: &[f64], factor: f64, r: &mut [f64]) {
        let factor = self.sign * factor / 3.0;
        self.patch.each(q, |[n, x, y], weight, [p, t, s]| {
            let [of_n, of_x, of_y] = [t.cross(&s), s.cross(&p), p.cross(&t)].map(|v| v * (factor * weight));
            for a in 0..N {
                let force = of_n * n[a] + of_x * x[a] + of_y * y[a];
                (0..3).for_each(|i| r[3 * a + i] += force[i]);
            }
        });
    }

    /// Calls `visit` with the vector w of each block ∂²V_e/∂q_a∂q_b = [w]×, a > b. The other blocks follow by symmetry.
    fn each_block(&self, q: &[f64], mut visit: impl FnMut(usize, usize, Vector3<f64>)) {
        let mut sums = [[Vector3::zeros(); N]; N];
        let factor = self.sign / 3.0;
        self.patch.each(q, |[n, x, y], weight, surface| {
            let [p, t, s] = surface.map(|v| v * (factor * weight));
            let of: [[Vector3<f64>; 3]; N] =
                std::array::from_fn(|b| [t * y[b] - s * x[b], s * n[b] - p * y[b], p * x[b] - t * n[b]]);
            for (a, row) in sums.iter_mut().enumerate() {
                for (sum, [of_n, of_x, of_y]) in row[..a].iter_mut().zip(&of) {
                    *sum += of_n * n[a] + of_x * x[a] + of_y * y[a];
                }
            }
        });
        for a in 0..N {
            (0..a).for_each(|b| visit(a, b, sums[a][b]));
        }
    }
}

impl<const N: usize> Term for EnclosedVolume<N> {
    fn coordinates(&self) -> &[usize] {
        self.patch.coordinates()
    }

    fn multipliers(&self) -> Range<usize> {
        self.multiplier..self.multiplier + 1
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, _: usize) -> String {
        "volume".into()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.add_gradient(at.q, at.lambda[0], r);
        r[3 * N] += self.volume(at.q) - self.reference;
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (unit, lambda) = (8.0 * f64::EPSILON / 3.0, at.lambda[0].abs());
        self.patch.each_size(at.q, |[n, x, y], weight, [p, t, s]| {
            let unit = unit * weight;
            for a in 0..N {
                let force = unit * lambda * (n[a].abs() * t * s + x[a].abs() * s * p + y[a].abs() * p * t);
                (0..3).for_each(|i| floor[3 * a + i] += force);
            }
            floor[3 * N] += unit * p * t * s;
        });
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let mut gradient = [0.0; LOCAL];
        self.add_gradient(at.q, 1.0, &mut gradient);
        gradient[..3 * N].iter().enumerate().for_each(|(i, x)| k.add(3 * N, i, *x));
        let factor = w.q * at.lambda[0];
        if factor == 0.0 {
            return;
        }
        self.each_block(at.q, |a, b, turn| {
            let [x, y, z] = (turn * factor).into();
            let entries = [(0, 1, -z), (0, 2, y), (1, 0, z), (1, 2, -x), (2, 0, -y), (2, 1, x)];
            entries.into_iter().for_each(|(i, j, entry)| k.add(3 * a + i, 3 * b + j, entry));
        });
    }

    /// Simpson's rule along the step is exact for the quadratic gradient: the forces do the work −λ ΔV and have no resultant on a closed
    /// surface. Their moment is an error of the second order of the step.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let lambda = step.middle.lambda[0];
        for (at, share) in [(&step.from, 1.0), (&step.middle, 4.0), (&step.to, 1.0)] {
            self.add_gradient(at.q, lambda * share / 6.0, r);
        }
        r[3 * N] += self.volume(step.to.q) - self.reference;
    }

    fn constraints(&self, at: &Local<'_>, level: Level, phi: &mut [f64]) {
        match level {
            Level::Position => phi[0] += self.volume(at.q) - self.reference,
            Level::Velocity => {
                let mut gradient = [0.0; LOCAL];
                self.add_gradient(at.q, 1.0, &mut gradient);
                phi[0] += gradient.iter().zip(at.v).map(|(g, v)| g * v).sum::<f64>();
            }
            Level::Acceleration => {
                let mut sum = 0.0;
                self.patch.each_with(at.q, at.v, |weight, [r, t, s], [dr, dt, ds]| {
                    let turning = dt.cross(&s) + t.cross(&ds);
                    sum += weight * 2.0 * (dr.dot(&turning) + r.dot(&dt.cross(&ds)));
                });
                phi[0] += self.sign * sum / 3.0;
            }
        }
    }
}
