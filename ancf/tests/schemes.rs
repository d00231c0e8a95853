//! Schemes of time integration: order in positions, velocities and multipliers, from the first step on.
#![cfg(test)]

#[path = "common/pendulum.rs"]
mod pendulum;
#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/rod.rs"]
mod rod;

use ancf::analysis::Scheme;
use ancf::system::State;

/// Errors of q, v and λ.
type Errors = [f64; 3];

fn distance(a: &State, b: &State) -> Errors {
    let norm = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    [norm(&a.q, &b.q), norm(&a.v, &b.v), norm(&a.lambda, &b.lambda)]
}

/// The largest errors of the pendulum over all steps, and those at the end.
fn errors(scheme: Scheme, haul: f64, steps: usize) -> [Errors; 2] {
    let exact = pendulum::exact(haul, 2.0, steps);
    let system = pendulum::system(haul);
    let mut dynamics = pendulum::dynamics(&system, scheme, haul);
    let (mut largest, mut last) = ([0.0; 3], [0.0; 3]);
    for exact in &exact[1..] {
        dynamics.advance(exact.t).unwrap();
        last = distance(dynamics.state(), exact);
        largest = std::array::from_fn(|i| f64::max(largest[i], last[i]));
    }
    [largest, last]
}

#[test]
fn explore() {
    for (name, scheme) in [
        ("adams", Scheme::ADAMS),
        ("average", Scheme::AVERAGE_ACCELERATION),
        ("rho 0", Scheme::generalized_alpha(0.0)),
        ("rho .5", Scheme::generalized_alpha(0.5)),
        ("rho .8", Scheme::generalized_alpha(0.8)),
        ("rho 1", Scheme::generalized_alpha(1.0)),
        ("hht .1", Scheme::hht(-0.1)),
        ("hht .3", Scheme::hht(-0.3)),
    ] {
        for haul in [0.0, 0.3] {
            let runs = [200, 400, 800].map(|n| errors(scheme, haul, n));
            for (k, what) in ["largest", "last"].iter().enumerate() {
                let order = |i: usize| {
                    [(runs[0][k][i] / runs[1][k][i]).log2(), (runs[1][k][i] / runs[2][k][i]).log2()]
                };
                println!(
                    "{name:8} {haul} {what:8} q {:.2?} v {:.2?} lambda {:.2?}  {:?}",
                    order(0), order(1), order(2), runs[2][k].map(|x| format!("{x:.0e}"))
                );
            }
        }
    }
}
