//! Observed orders of the schemes in the step h and of the element in its length l.
//!
//! Differences of the results at h, h/2, h/4 have the ratio 2ᵖ for the order p.

use ancf::Model;
use ancf::model::{self, ClampedGradients, Start};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{Energy, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

use crate::common::models::rod;
use crate::common::solutions::Run;
use crate::common::solutions::equilibrium;

/// Duffing oscillator with unit mass: q'' + q + q³ = 0.
struct Oscillator;

impl Term for Oscillator {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += at.a[0] + at.q[0] + at.q[0].powi(3);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * (at.a[0].abs() + at.q[0].abs() + at.q[0].abs().powi(3));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.a + w.q * (1.0 + 3.0 * at.q[0].powi(2)));
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let strain = 0.5 * at.q[0].powi(2) + 0.25 * at.q[0].powi(4);
        Energy { kinetic: 0.5 * at.v[0].powi(2), strain, potential: 0.0 }
    }
}

/// Position of the oscillator at t = 2 after release from q = 1.
fn released(scheme: SchemeCoefficients, steps: u32) -> f64 {
    let system = System::new(1, 0, vec![Box::new(Oscillator)]);
    let newton = Newton::new(system.matrix(), StopRule::Energy(1e-10), 20).unwrap();
    let start = State { q: vec![1.0], a: vec![-2.0], ..State::rest(1, 0) };
    let mut dynamics = TimeStepper::new(&system, scheme, newton, 0, start);
    for step in 1..=steps {
        dynamics.advance(2.0 * f64::from(step) / f64::from(steps)).unwrap();
    }
    dynamics.state().q[0]
}

/// Observed order: log₂ of the ratio of the differences.
fn order(results: [Vector3<f64>; 3]) -> f64 {
    let [coarse, middle, fine] = results;
    ((coarse - middle).norm() / (middle - fine).norm()).log2()
}

fn assert_order(name: &str, observed: f64, expected: f64) {
    assert!((observed - expected).abs() < 0.1, "{name}: order {observed}");
}

#[test]
fn schemes_without_constraints() {
    for (name, scheme, expected) in [
        ("ADAMS", SchemeCoefficients::ADAMS, 1.0),
        ("average acceleration", SchemeCoefficients::AVERAGE_ACCELERATION, 2.0),
        ("linear acceleration", SchemeCoefficients::LINEAR_ACCELERATION, 2.0),
    ] {
        let results = [200, 400, 800].map(|steps| Vector3::x() * released(scheme, steps));
        assert_order(name, order(results), expected);
    }
}

/// Tip of a soft pendulum of one element at t = 0.4 s.
fn swung(scheme: model::Scheme, steps: u32) -> Vector3<f64> {
    let mut model = rod::revolute(1);
    rod::material(&mut model).young /= 1e5;
    let settings = rod::settings(&mut model);
    (settings.scheme, settings.start) = (scheme, Start::Consistent);
    (settings.duration, settings.step) = (0.4, model::Step::Fixed(0.4 / f64::from(steps)));
    settings.stop = model::Stop::Energy { tolerance: 1e-10 };
    Run::of(&model).last_vector("tip.")
}

/// With constraints only β = 1/4 is stable among the schemes with γ = 1/2.
#[test]
fn schemes_with_constraints() {
    for (name, scheme, expected) in [
        ("ADAMS", model::Scheme::Adams, 1.0),
        ("average acceleration", model::Scheme::AverageAcceleration, 2.0),
    ] {
        let results = [800, 1600, 3200].map(|steps| swung(scheme, steps));
        assert_order(name, order(results), expected);
    }
}

/// Static tip deflection of Reissner's rod with k = 1 and ν = 0, by shooting (independent calculation).
const LIMIT: f64 = -2.041186330e-3;

fn static_tip(model: &Model) -> Vector3<f64> {
    let (assembly, state) = equilibrium(model, 1);
    assembly.probes[0].1.value(&state)
}

/// Tip deflections under own weight miss 1/(3n²) of their limit.
#[test]
fn static_tip_converges_at_order_two() {
    for fix in [ClampedGradients::All, ClampedGradients::Section] {
        let tips = [8, 16, 32].map(|elements| static_tip(&rod::clamped(elements, fix)));
        assert_order(&format!("{fix:?}"), order(tips), 2.0);
        let missing = 1.0 - tips[0].y / LIMIT;
        assert!((missing * 3.0 * 8.0_f64.powi(2) - 1.0).abs() < 0.01, "{fix:?}: {missing}");
    }
}
