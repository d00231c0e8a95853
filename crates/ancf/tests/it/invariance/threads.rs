//! Threads change how long a run takes and nothing else.

use crate::common::models::rod;
use ancf::analysis::{Dynamics, Newton, Scheme, Stop};
use ancf::system::State;

/// A rod of 1500 elements after some steps, by so many threads: three parts of batches, two branches of the elimination tree.
fn moved(threads: usize) -> State {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        let assembly = rod::cantilever(1500).assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-8), 50).unwrap();
        let mut dynamics = Dynamics::new(&assembly.system, Scheme::ADAMS, newton, 0, assembly.rest());
        dynamics.restart(0.0).unwrap();
        for step in 1..=5 {
            dynamics.advance(1e-3 * f64::from(step)).unwrap();
        }
        dynamics.state().clone()
    })
}

#[test]
fn same_to_the_last_digit() {
    let one = moved(1);
    assert!(one.q.iter().any(|q| q.abs() > 1e-6), "it moved");
    for threads in [2, 3, 4] {
        assert_eq!(moved(threads), one, "{threads} threads");
    }
}
