use ancf_solver::equations::{LOCAL, Local, LocalMatrix, State, Term, Weights};

use crate::constraints::{BilinearMeasure, Wrench};
use crate::laws::FrictionCurve;

/// Dry friction of given magnitude against the rate of a measure: f = −F c(ġ) ∂g/∂q with a [`FrictionCurve`] c.
///
/// At low rates the friction is viscous, so sticking is approximated by creep. Above, it dissipates F |ġ| c. The tangent contains the
/// symmetric part of the derivative.
///
/// Units: F is energy per unit of the measure, rates of the curve are the measure per time.
#[derive(Clone, Debug)]
pub struct Friction {
    global: BilinearMeasure,
    measure: BilinearMeasure,
    force: f64,
    curve: FrictionCurve,
    coordinates: Vec<usize>,
}

impl Friction {
    /// Creates friction of a given magnitude at high rates.
    pub fn new(measure: BilinearMeasure, force: f64, curve: FrictionCurve) -> Self {
        let coordinates = measure.coordinates();
        let local = measure.within(&coordinates);
        Self { global: measure, measure: local, force, curve, coordinates }
    }

    /// Returns the force and moment on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        self.global.wrench(s, -self.force * self.curve.at(self.global.rate(s)))
    }
}

impl Term for Friction {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn has_kinks(&self) -> bool {
        true
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let rate = self.measure.slope(at.q, at.v);
        self.measure.add_gradient(at.q, self.force * self.curve.at(rate), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let n = at.q.len();
        let (mut gradient, mut errors) = ([0.0; LOCAL], [0.0; LOCAL]);
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..n]);
        self.measure.add_rounding(at.q, 1.0, &mut errors[..n]);
        let of_rate: f64 =
            (0..n).map(|i| (errors[i] + f64::EPSILON * gradient[i].abs()) * at.v[i].abs()).sum();
        let slope = self.force * self.curve.slope(self.measure.slope(at.q, at.v)).abs();
        let force = self.force * self.curve.peak;
        for i in 0..n {
            floor[i] += 2.0 * force * errors[i] + 2.0 * slope * of_rate * gradient[i].abs();
            floor[i] += f64::EPSILON * force * gradient[i].abs();
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let n = at.q.len();
        let (mut gradient, mut turned) = ([0.0; LOCAL], [0.0; LOCAL]);
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..n]);
        self.measure.add_gradient_slope(at.q, at.v, 1.0, &mut turned[..n]);
        let rate = self.measure.slope(at.q, at.v);
        let slope = self.force * self.curve.slope(rate);
        crate::constraints::add_outer(&gradient, &gradient, w.v * slope, n, k);
        crate::constraints::add_outer(&gradient, &turned, w.q * slope, n, k);
        self.measure.add_curvature(at.q, w.q * self.force * self.curve.at(rate), k);
    }
}
