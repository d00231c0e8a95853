//! A point mass on a massless rod as two terms, and its motion by the differential equation of its angle.

use std::ops::Range;

use ancf::analysis::{Dynamics, Newton, Scheme, Stop};
use ancf::system::{Energy, Local, LocalMatrix, State, System, Term, Weights};

/// Mass.
pub(crate) const MASS: f64 = 2.0;
/// Length of the rod.
pub(crate) const ROD: f64 = 1.5;
/// Gravity along −y.
pub(crate) const GRAVITY: f64 = 9.81;

/// The mass and its weight; coordinates are its place.
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

/// ½ (x² + y² − ρ(t)²) = 0, ρ² = ROD² (1 + haul × sin t): a rod, or a rope that is hauled.
struct Rod {
    haul: f64,
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
        let square = ROD.powi(2) * (1.0 + self.haul * at.t.sin());
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
        rates[0] -= 0.5 * ROD.powi(2) * self.haul * t.cos();
        accelerations[0] += 0.5 * ROD.powi(2) * self.haul * t.sin();
    }
}

/// The equations of motion; with `haul` the rod changes its length.
pub(crate) fn system(haul: f64) -> System {
    system_with(haul, Vec::new())
}

/// The same with further terms.
pub(crate) fn system_with(haul: f64, mut terms: Vec<Box<dyn Term>>) -> System {
    terms.extend([Box::new(Mass) as Box<dyn Term>, Box::new(Rod { haul })]);
    System::new(2, 1, terms)
}

/// Exact place, velocity and multiplier at angle φ from the x-axis, rod length ρ and their rates.
fn state(t: f64, [phi, omega]: [f64; 2], haul: f64) -> State {
    let rho = ROD * (1.0 + haul * t.sin()).sqrt();
    let rate = 0.5 * ROD.powi(2) * haul * t.cos() / rho;
    let (sin, cos) = phi.sin_cos();
    let (q, v) =
        (vec![rho * cos, rho * sin], vec![rate * cos - rho * omega * sin, rate * sin + rho * omega * cos]);
    // r·r̈ + v·v + c̈ = 0 with m r̈ + m g + λ r = 0.
    let bend = v[0].powi(2) + v[1].powi(2) + 0.5 * ROD.powi(2) * haul * t.sin();
    let lambda = vec![MASS * (bend - GRAVITY * q[1]) / rho.powi(2)];
    let a = vec![-lambda[0] * q[0] / MASS, -GRAVITY - lambda[0] * q[1] / MASS];
    State { t, q, v, a, lambda, load: 1.0 }
}

/// The exact motion from φ = −0.5, φ̇ = 1.3: states at so many equal steps, by Runge-Kutta steps of 10⁻⁴.
pub(crate) fn exact(haul: f64, duration: f64, steps: usize) -> Vec<State> {
    let fine = (duration / 1e-4 / steps as f64).ceil() as usize;
    let h = duration / (steps * fine) as f64;
    let rate = |t: f64, [phi, omega]: [f64; 2]| {
        let rho = ROD * (1.0 + haul * t.sin()).sqrt();
        let stretch = 0.5 * ROD.powi(2) * haul * t.cos() / rho.powi(2);
        [omega, -GRAVITY * phi.cos() / rho - 2.0 * stretch * omega]
    };
    let plus = |x: [f64; 2], f: f64, y: [f64; 2]| [x[0] + f * y[0], x[1] + f * y[1]];
    let (mut y, mut t, mut states) = ([-0.5, 1.3], 0.0, vec![state(0.0, [-0.5, 1.3], haul)]);
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
            states.push(state(t, y, haul));
        }
    }
    states
}

/// The dynamics from the same start.
pub(crate) fn dynamics(system: &System, scheme: Scheme, haul: f64) -> Dynamics<'_, System> {
    let newton = Newton::new(system.matrix(), Stop::Energy(1e-13), 20).unwrap();
    let mut dynamics = Dynamics::new(system, scheme, newton, 0, state(0.0, [-0.5, 1.3], haul));
    dynamics.restart(0.0).unwrap();
    dynamics
}
