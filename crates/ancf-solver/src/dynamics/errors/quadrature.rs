use nalgebra::{Matrix4, Vector4};
use serde::{Deserialize, Serialize};

use crate::equations::State;

/// Number of accelerations of an integral.
const NODES: usize = 4;
/// Ratio of the acceleration of a coordinate at a start or jump to that at the end of the first step above which it is that of a fast
/// motion that decays within the step.
const FAST: f64 = 10.0;

/// Integration of the accelerations of the last steps by a polynomial through them, of higher order than that of the scheme.
///
/// At the start and after a jump there are fewer accelerations. The order is then lower.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Quadrature {
    /// Times and accelerations before the last step, the latest first, and their number.
    times: [f64; NODES - 2],
    earlier: [Vec<f64>; NODES - 2],
    count: usize,
    /// True if the acceleration at the start of the next step satisfies the equations of motion.
    is_consistent: bool,
}

/// Difference between the integral of the accelerations and a step of the scheme.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Defect {
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
}

impl Quadrature {
    pub(super) fn new(coordinates: usize) -> Self {
        let zeros = || vec![0.0; coordinates];
        Self { times: [0.0; NODES - 2], earlier: [zeros(), zeros()], count: 0, is_consistent: true }
    }

    /// Clears the history at a jump, or at a start whose accelerations need not satisfy the equations of motion.
    pub(super) fn restart(&mut self, is_consistent: bool) {
        (self.count, self.is_consistent) = (0, is_consistent);
    }

    /// Computes the defect of a step between two states and adds the start of the step to the history.
    ///
    /// D_v = ∫ v̇ dt − (v₁ − v₀),  D_q = h v₀ + ∫∫ v̇ dt − (q₁ − q₀).
    pub(super) fn defect(&mut self, before: &State, now: &State, defect: &mut Defect) {
        let h = now.t - before.t;
        let mut places = [1.0; NODES];
        places[1] = 0.0;
        for (place, t) in places[2..].iter_mut().zip(self.times) {
            *place = (t - before.t) / h;
        }
        let count = if self.is_consistent { 2 + self.count } else { 1 };
        let [single, double] = weights(&places[..count]);
        let is_first = self.is_consistent && self.count == 0;
        let accelerations = [&now.a, &before.a, &self.earlier[0], &self.earlier[1]];
        for i in 0..defect.q.len() {
            let [mut once, mut twice] = [0.0; 2];
            for (a, (single, double)) in accelerations.iter().zip(single.iter().zip(&double)) {
                once += single * a[i];
                twice += double * a[i];
            }
            if is_first && before.a[i].abs() > FAST * now.a[i].abs() {
                (once, twice) = (now.a[i], 0.5 * now.a[i]);
            }
            defect.v[i] = h * once - (now.v[i] - before.v[i]);
            defect.q[i] = h * (before.v[i] + h * twice) - (now.q[i] - before.q[i]);
        }
        self.count = if self.is_consistent { (self.count + 1).min(NODES - 2) } else { 0 };
        self.is_consistent = true;
        self.earlier.swap(0, 1);
        self.earlier[0].copy_from_slice(&before.a);
        self.times = [before.t, self.times[0]];
    }

    pub(super) fn is_valid(&self, coordinates: usize) -> bool {
        self.count <= NODES - 2
            && self.times.iter().all(|t| t.is_finite())
            && self.earlier.iter().all(|a| a.len() == coordinates && a.iter().all(|x| x.is_finite()))
    }
}

/// Weights w of the integral Σ w f(x) ≈ ∫ f dx over [0, 1] for nodes x, and those of ∫ (1 − x) f dx. The weights of missing nodes
/// are zero.
fn weights(nodes: &[f64]) -> [Vector4<f64>; 2] {
    let mut powers = Matrix4::identity();
    let (mut single, mut double) = (Vector4::zeros(), Vector4::zeros());
    for row in 0..nodes.len() {
        for (column, x) in nodes.iter().enumerate() {
            powers[(row, column)] = x.powi(row as i32);
        }
        single[row] = 1.0 / (row + 1) as f64;
        double[row] = 1.0 / ((row + 1) * (row + 2)) as f64;
    }
    powers.try_inverse().map_or([Vector4::zeros(); 2], |inverse| [inverse * single, inverse * double])
}

impl Defect {
    pub(super) fn new(coordinates: usize) -> Self {
        Self { q: vec![0.0; coordinates], v: vec![0.0; coordinates] }
    }

    pub(super) fn is_valid(&self, coordinates: usize) -> bool {
        [&self.q, &self.v].iter().all(|x| x.len() == coordinates && x.iter().all(|x| x.is_finite()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_integrate_polynomials_exactly() {
        let nodes = [1.0, 0.0, -0.7, -2.1];
        for count in 1..=NODES {
            let [single, double] = weights(&nodes[..count]);
            for power in 0..count as i32 {
                let sum = |w: &Vector4<f64>| -> f64 { (0..count).map(|k| w[k] * nodes[k].powi(power)).sum() };
                let p = f64::from(power);
                assert!((sum(&single) - 1.0 / (p + 1.0)).abs() < 1e-14);
                assert!((sum(&double) - 1.0 / ((p + 1.0) * (p + 2.0))).abs() < 1e-14);
            }
        }
    }

    /// The defect of the trapezoidal rule on cubic accelerations is its exact error.
    #[test]
    fn the_defect_is_the_error_of_a_step() {
        let at = |t: f64| {
            let mut s = State::rest(1, 0);
            let a = |t: f64| 1.0 + 2.0 * t - t * t + 0.5 * t * t * t;
            (s.t, s.a[0]) = (t, a(t));
            s.v[0] = t + t * t - t.powi(3) / 3.0 + 0.125 * t.powi(4);
            s.q[0] = 0.5 * t * t + t.powi(3) / 3.0 - t.powi(4) / 12.0 + 0.025 * t.powi(5);
            s
        };
        let mut quadrature = Quadrature::new(1);
        let mut defect = Defect::new(1);
        let times = [0.0, 0.1, 0.25, 0.3];
        for pair in times.windows(2) {
            quadrature.defect(&at(pair[0]), &at(pair[1]), &mut defect);
        }
        assert!(defect.q[0].abs() < 1e-15 && defect.v[0].abs() < 1e-15);
        let (from, mut to) = (at(0.3), at(0.35));
        let h = to.t - from.t;
        let (exact_q, exact_v) = (to.q[0], to.v[0]);
        to.v[0] = from.v[0] + 0.5 * h * (from.a[0] + to.a[0]);
        to.q[0] = from.q[0] + h * from.v[0] + 0.25 * h * h * (from.a[0] + to.a[0]);
        quadrature.defect(&from, &to, &mut defect);
        assert!((defect.v[0] - (exact_v - to.v[0])).abs() < 1e-15);
        assert!((defect.q[0] - (exact_q - to.q[0])).abs() < 1e-15);
        assert!(defect.v[0].abs() > 1e-7);
    }
}
