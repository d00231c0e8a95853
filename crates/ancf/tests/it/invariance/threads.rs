//! Results do not depend on the number of threads.

use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::State;
use ancf::solver::newton::{Newton, StopRule};

use crate::common::models::rod;

/// State of a rod of 1500 elements after five steps: three groups of batches, two branches of the elimination tree.
fn final_state(threads: usize) -> State {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let assembly = rod::cantilever(1500).assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-8), 50).unwrap();
        let mut dynamics =
            TimeStepper::new(&assembly.system, SchemeCoefficients::ADAMS, newton, 0, assembly.rest());
        dynamics.restart(0.0).unwrap();
        for step in 1..=5 {
            dynamics.advance(1e-3 * f64::from(step)).unwrap();
        }
        dynamics.state().clone()
    })
}

#[test]
fn threads_do_not_change_a_bit() {
    let one = final_state(1);
    assert!(one.q.iter().any(|q| q.abs() > 1e-6), "the rod moves");
    for threads in [2, 3, 4] {
        assert_eq!(final_state(threads), one, "{threads} threads");
    }
}
