//! Time integration schemes: order in positions, velocities and multipliers, damping, constraint levels, drift.

use ancf::model::Section;
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper, consistent_velocities};
use ancf::solver::equations::{EquationsOfMotion, Level, State, System};
use ancf::solver::newton::{Newton, StopRule};

use super::pendulum;
use crate::common::models::rod;

/// Errors of q, v and λ.
type Errors = [f64; 3];

fn distance(a: &State, b: &State) -> Errors {
    let norm = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    [norm(&a.q, &b.q), norm(&a.v, &b.v), norm(&a.lambda, &b.lambda)]
}

/// Largest errors of the pendulum over all steps, and errors at the end.
fn errors(scheme: SchemeCoefficients, stretch: f64, steps: usize) -> [Errors; 2] {
    let exact = pendulum::exact(stretch, 2.0, steps);
    let system = pendulum::system(stretch);
    let mut dynamics = pendulum::dynamics(&system, scheme, stretch);
    let (mut largest, mut last) = ([0.0; 3], [0.0; 3]);
    for exact in &exact[1..] {
        dynamics.advance(exact.t).unwrap();
        last = distance(dynamics.state(), exact);
        largest = std::array::from_fn(|i| f64::max(largest[i], last[i]));
    }
    [largest, last]
}

/// Schemes of second order in q, v and λ.
fn second_order() -> [(&'static str, SchemeCoefficients); 6] {
    [
        ("spectral radius 0", SchemeCoefficients::generalized_alpha(0.0)),
        ("spectral radius 0.5", SchemeCoefficients::generalized_alpha(0.5)),
        ("spectral radius 0.8", SchemeCoefficients::generalized_alpha(0.8)),
        ("spectral radius 1", SchemeCoefficients::generalized_alpha(1.0)),
        ("HHT -0.1", SchemeCoefficients::hht(-0.1)),
        ("HHT -0.3", SchemeCoefficients::hht(-0.3)),
    ]
}

fn assert_order(name: &str, coarse: Errors, fine: Errors) {
    for (i, what) in ["q", "v", "λ"].iter().enumerate() {
        let order = (coarse[i] / fine[i]).log2();
        assert!((order - 2.0).abs() < 0.1, "{name}: order {order} in {what}");
    }
}

/// Positions, velocities and multipliers from the first step on, with constant and prescribed length of the rod.
#[test]
fn pendulum_converges_at_order_two() {
    for (name, scheme) in second_order() {
        for stretch in [0.0, 0.3] {
            let [coarse, fine] = [400, 800].map(|steps| errors(scheme, stretch, steps)[0]);
            assert_order(&format!("{name}, stretch {stretch}"), coarse, fine);
        }
    }
}

/// The initial error of λ, O(h), decays with numerical damping and stays without.
#[test]
fn newmark_schemes_have_their_orders() {
    let end = |scheme, steps| errors(scheme, 0.0, steps)[1];
    for (i, what) in ["q", "v", "λ"].iter().enumerate() {
        let order = (end(SchemeCoefficients::ADAMS, 400)[i] / end(SchemeCoefficients::ADAMS, 800)[i]).log2();
        assert!((order - 1.0).abs() < 0.1, "ADAMS: order {order} in {what}");
    }
    let [coarse, fine] = [400, 800].map(|steps| end(SchemeCoefficients::AVERAGE_ACCELERATION, steps));
    assert!(((coarse[0] / fine[0]).log2() - 2.0).abs() < 0.1, "q");
    assert!((coarse[2] / fine[2]).log2().abs() < 0.1, "λ alternates");
}

/// States of a soft hinged rod at ten instants of 0.2 s. It is thick, so that vibrations of its section are resolved.
fn swung(scheme: SchemeCoefficients, steps: usize) -> Vec<State> {
    let mut model = rod::revolute(1);
    rod::material(&mut model).young /= 1e6;
    model.sections.insert("circle".into(), Section::circle(0.2));
    let assembly = model.assemble().unwrap();
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-11), 50).unwrap();
    let mut dynamics = TimeStepper::new(&assembly.system, scheme, newton, 0, assembly.rest());
    dynamics.restart(0.0).unwrap();
    let states = (1..=steps).map(|step| {
        dynamics.advance(0.2 * step as f64 / steps as f64).unwrap();
        dynamics.state().clone()
    });
    states.skip(steps / 10 - 1).step_by(steps / 10).collect()
}

#[test]
fn rod_converges_at_order_two() {
    for (name, scheme) in second_order() {
        let runs = [400, 800, 1600].map(|steps| swung(scheme, steps));
        let difference = |a: &[State], b: &[State]| {
            let all = a.iter().zip(b).map(|(a, b)| distance(a, b));
            all.fold([0.0; 3], |largest, d| std::array::from_fn(|i| f64::max(largest[i], d[i])))
        };
        assert_order(name, difference(&runs[0], &runs[1]), difference(&runs[1], &runs[2]));
    }
}

/// Cantilever of the paper under its own weight: amplitude of twice the static deflection, 2 × 2.0145 mm with five elements.
#[test]
fn amplitude_does_not_grow_with_the_step() {
    let lowest = |step: f64| {
        let assembly = rod::cantilever(5).assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-8), 50).unwrap();
        let mut dynamics =
            TimeStepper::new(&assembly.system, SchemeCoefficients::hht(-0.3), newton, 0, assembly.rest());
        dynamics.restart(0.0).unwrap();
        let tips = (1..=(0.5 / step) as usize).map(|i| {
            dynamics.advance(step * i as f64).unwrap();
            assembly.probes[0].1.value(dynamics.state()).y
        });
        tips.fold(0.0, f64::min)
    };
    let fine = lowest(1e-4);
    assert!((fine / (2.0 * -2.0145e-3) - 1.0).abs() < 0.03, "{fine:e}");
    for step in [1e-3, 5e-3, 1e-2, 2e-2] {
        let amplitude = lowest(step) / fine;
        assert!(amplitude < 1.001 && amplitude > 0.9, "{amplitude} at a step of {step}");
    }
}

fn constraints(system: &System, s: &State, level: Level) -> f64 {
    let mut phi = [0.0];
    system.constraints(s, level, &mut phi);
    phi[0]
}

/// Levels of a constraint that is quadratic in q and depends on t, along an exact motion.
#[test]
fn constraint_levels_vanish_along_exact_motions() {
    let (system, exact) = (pendulum::system(0.3), pendulum::exact(0.3, 1.0, 4));
    for s in &exact {
        for level in [Level::Position, Level::Velocity] {
            assert!(constraints(&system, s, level).abs() < 1e-13, "{level:?}");
        }
        let along = s.q.iter().zip(&s.a).map(|(q, a)| q * a).sum::<f64>(); // Φ_q a
        assert!((constraints(&system, s, Level::Acceleration) + along).abs() < 1e-12);
    }
}

/// Inconsistent velocities lose their component along the rod only.
#[test]
fn inconsistent_velocities_are_projected() {
    let (system, exact) = (pendulum::system(0.3), pendulum::exact(0.3, 1.0, 1).pop().unwrap());
    let mut s = exact.clone();
    (0..2).for_each(|i| s.v[i] += 0.1 * exact.q[i]);
    consistent_velocities(&system, &mut system.matrix(), &mut s).unwrap();
    assert!(distance(&s, &exact)[1] < 1e-14, "{:?} for {:?}", s.v, exact.v);
}

/// Violation of the velocity constraints: second order, constant in the long term.
#[test]
fn drift_is_bounded_and_of_second_order() {
    let system = pendulum::system(0.3);
    let drift = |steps: u32| {
        let mut dynamics = pendulum::dynamics(&system, SchemeCoefficients::generalized_alpha(0.8), 0.3);
        let drifts =
            (1..=steps).map(|i| dynamics.advance(20.0 * f64::from(i) / f64::from(steps)).unwrap().drift);
        let drifts: Vec<f64> = drifts.collect();
        drifts
            .chunks(drifts.len() / 2)
            .map(|half| half.iter().copied().fold(0.0, f64::max))
            .collect::<Vec<f64>>()
    };
    let (coarse, fine) = (drift(4000), drift(8000));
    let order = (coarse[1] / fine[1]).log2();
    assert!((order - 2.0).abs() < 0.1, "order {order}");
    assert!(fine[1] < 1.2 * fine[0], "{fine:?}");
}
