use ancf_solver::equations::{LOCAL, Local, LocalMatrix, State, Term, Weights};

use crate::constraints::{BilinearMeasure, Wrench};

/// Dry friction of given magnitude against the rate of a measure: f = −F tanh(ġ/ε) ∂g/∂q.
///
/// Below the rate ε the friction is viscous, so sticking is approximated by creep. Above, it dissipates F |ġ|. The
/// tangent contains the symmetric part of the derivative.
///
/// Units: F is energy per unit of the measure, ε the measure per time.
#[derive(Clone, Debug)]
pub struct Friction {
    global: BilinearMeasure,
    measure: BilinearMeasure,
    force: f64,
    creep: f64,
    coordinates: Vec<usize>,
}

impl Friction {
    /// Creates friction of a given magnitude, fully developed above the rate `creep`.
    pub fn new(measure: BilinearMeasure, force: f64, creep: f64) -> Self {
        let coordinates = measure.coordinates();
        let local = measure.within(&coordinates);
        Self { global: measure, measure: local, force, creep, coordinates }
    }

    /// Returns the force and moment on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        self.global.wrench(s, -self.force * (self.global.rate(s) / self.creep).tanh())
    }
}

impl Term for Friction {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let rate = self.measure.slope(at.q, at.v);
        self.measure.add_gradient(at.q, self.force * (rate / self.creep).tanh(), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let n = at.q.len();
        let (mut gradient, mut errors) = ([0.0; LOCAL], [0.0; LOCAL]);
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..n]);
        self.measure.add_rounding(at.q, 1.0, &mut errors[..n]);
        let of_rate: f64 =
            (0..n).map(|i| (errors[i] + f64::EPSILON * gradient[i].abs()) * at.v[i].abs()).sum();
        let ratio = self.measure.slope(at.q, at.v) / self.creep;
        let slope = self.force / self.creep / ratio.cosh().powi(2);
        for i in 0..n {
            floor[i] += 2.0 * self.force * errors[i] + 2.0 * slope * of_rate * gradient[i].abs();
            floor[i] += f64::EPSILON * self.force * gradient[i].abs();
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        let (mut gradient, mut turned) = ([0.0; LOCAL], [0.0; LOCAL]);
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..n]);
        self.measure.add_gradient_slope(at.q, at.v, 1.0, &mut turned[..n]);
        let ratio = self.measure.slope(at.q, at.v) / self.creep;
        let slope = self.force / self.creep / ratio.cosh().powi(2);
        crate::constraints::add_outer(&gradient, &gradient, w.v * slope, n, k);
        crate::constraints::add_outer(&gradient, &turned, w.q * slope, n, k);
        self.measure.add_curvature(at.q, w.q * self.force * ratio.tanh(), k);
    }
}
