//! Mathematical pendulum of two terms, and its exact motion by the differential equation of its angle.

use std::ops::Range;

use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{Energy, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::newton::{Newton, StopRule};

/// Mass.
pub(super) const MASS: f64 = 2.0;
/// Length of the rod.
pub(super) const ROD: f64 = 1.5;
/// Gravity along −y.
pub(super) const GRAVITY: f64 = 9.81;

/// Point mass with its weight; the coordinates are its position.
struct Mass;

impl Term for Mass {
    fn coordinates(&self) -> &[usize] {
        &[0, 1]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += MASS * at.a[0];
        r[1] += MASS * (at.a[1] + GRAVITY * at.load);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * MASS * at.a[0].abs();
        floor[1] += f64::EPSILON * MASS * (at.a[1].abs() + GRAVITY);
    }

    fn tangent(&self, _: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.a * MASS);
        k.add(1, 1, w.a * MASS);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let kinetic = 0.5 * MASS * (at.v[0].powi(2) + at.v[1].powi(2));
        Energy { kinetic, strain: 0.0, potential: MASS * GRAVITY * at.q[1] }
    }
}

/// Constraint ½ (x² + y² − ρ(t)²) = 0 with ρ² = ROD² (1 + stretch × sin t): rod of constant or prescribed length.
struct Rod {
    stretch: f64,
}

impl Term for Rod {
    fn coordinates(&self) -> &[usize] {
        &[0, 1]
    }

    fn multipliers(&self) -> Range<usize> {
        0..1
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += at.lambda[0] * at.q[0];
        r[1] += at.lambda[0] * at.q[1];
        let square = ROD.powi(2) * (1.0 + self.stretch * at.t.sin());
        r[2] += 0.5 * (at.q[0].powi(2) + at.q[1].powi(2) - square);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * (at.lambda[0] * at.q[0]).abs();
        floor[1] += f64::EPSILON * (at.lambda[0] * at.q[1]).abs();
        floor[2] += f64::EPSILON * (at.q[0].powi(2) + at.q[1].powi(2) + ROD.powi(2));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        for i in 0..2 {
            k.add(i, i, w.q * at.lambda[0]);
            k.add(2, i, at.q[i]);
        }
    }

    fn drive(&self, t: f64, rates: &mut [f64], accelerations: &mut [f64]) {
        rates[0] -= 0.5 * ROD.powi(2) * self.stretch * t.cos();
        accelerations[0] += 0.5 * ROD.powi(2) * self.stretch * t.sin();
    }
}

/// Equations of motion. The length of the rod varies by the factor `stretch`.
pub(super) fn system(stretch: f64) -> System {
    system_with(stretch, Vec::new())
}

/// Equations of motion with additional terms.
pub(super) fn system_with(stretch: f64, mut terms: Vec<Box<dyn Term>>) -> System {
    terms.extend([Box::new(Mass) as Box<dyn Term>, Box::new(Rod { stretch })]);
    System::new(2, 1, terms)
}

/// Exact state at the angle φ from the x-axis and its rate.
fn state(t: f64, [phi, omega]: [f64; 2], stretch: f64) -> State {
    let rho = ROD * (1.0 + stretch * t.sin()).sqrt();
    let rate = 0.5 * ROD.powi(2) * stretch * t.cos() / rho;
    let (sin, cos) = phi.sin_cos();
    let (q, v) =
        (vec![rho * cos, rho * sin], vec![rate * cos - rho * omega * sin, rate * sin + rho * omega * cos]);
    // r·r̈ + v·v + c̈ = 0 with m r̈ + m g + λ r = 0.
    let curvature = v[0].powi(2) + v[1].powi(2) + 0.5 * ROD.powi(2) * stretch * t.sin();
    let lambda = vec![MASS * (curvature - GRAVITY * q[1]) / rho.powi(2)];
    let a = vec![-lambda[0] * q[0] / MASS, -GRAVITY - lambda[0] * q[1] / MASS];
    State { t, q, v, a, lambda, load: 1.0 }
}

/// Exact motion from φ = −0.5, φ̇ = 1.3 at equal steps, by the Runge-Kutta method with steps of 10⁻⁴.
pub(super) fn exact(stretch: f64, duration: f64, steps: usize) -> Vec<State> {
    let fine = (duration / 1e-4 / steps as f64).ceil() as usize;
    let h = duration / (steps * fine) as f64;
    let rate = |t: f64, [phi, omega]: [f64; 2]| {
        let rho = ROD * (1.0 + stretch * t.sin()).sqrt();
        let growth = 0.5 * ROD.powi(2) * stretch * t.cos() / rho.powi(2);
        [omega, -GRAVITY * phi.cos() / rho - 2.0 * growth * omega]
    };
    let plus = |x: [f64; 2], f: f64, y: [f64; 2]| [x[0] + f * y[0], x[1] + f * y[1]];
    let (mut y, mut t, mut states) = ([-0.5, 1.3], 0.0, vec![state(0.0, [-0.5, 1.3], stretch)]);
    for step in 1..=steps * fine {
        let k1 = rate(t, y);
        let k2 = rate(t + 0.5 * h, plus(y, 0.5 * h, k1));
        let k3 = rate(t + 0.5 * h, plus(y, 0.5 * h, k2));
        let k4 = rate(t + h, plus(y, h, k3));
        for (k, f) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
            y = plus(y, f * h / 6.0, k);
        }
        t = step as f64 * h;
        if step % fine == 0 {
            states.push(state(t, y, stretch));
        }
    }
    states
}

/// Time integration from the initial state of [`exact`].
pub(super) fn dynamics(system: &System, scheme: SchemeCoefficients, stretch: f64) -> TimeStepper<'_, System> {
    let newton = Newton::new(system.matrix(), StopRule::Energy(1e-13), 20).unwrap();
    let mut dynamics = TimeStepper::new(system, scheme, newton, 0, state(0.0, [-0.5, 1.3], stretch));
    dynamics.restart(0.0).unwrap();
    dynamics
}
