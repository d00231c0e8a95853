//! The step loop of dynamics allocates no memory.
//!
//! A program of its own: `allocation_counter` installs a global allocator, which would count in every test.
// For Clippy, which permits `unwrap` in the helper functions of test code only.
#![cfg(test)]

use std::path::Path;

use ancf::Model;
use ancf::model::Step;
use ancf::solver::dynamics::TimeStepper;
use ancf::solver::equations::EquationsOfMotion;
use ancf::solver::newton::Newton;

/// Returns the number of allocations in 100 steps of a model, after 5 initial steps.
fn allocations(name: &str) -> u64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../models/{name}.toml"));
    let model = Model::read(&path).unwrap();
    let model = model.scaled(&model.scales().scales);
    let assembly = model.assemble().unwrap();
    let settings = model.analysis.dynamics().unwrap();
    let Step::Fixed(h) = settings.step else { panic!("{name} has fixed steps") };
    let newton =
        Newton::new(assembly.system.matrix(), settings.stop.into(), settings.max_iterations).unwrap();
    let start = assembly.start(&model);
    let mut dynamics = TimeStepper::new(&assembly.system, settings.scheme.numbers(), newton, 5, start);
    dynamics.restart(0.0).unwrap();
    let mut advance = |steps: std::ops::Range<u32>| {
        for i in steps {
            dynamics.advance(h * f64::from(i + 1)).unwrap();
        }
    };
    advance(0..5);
    assert!(assembly.system.coordinates() > 0);
    allocation_counter::measure(|| advance(5..105)).count_total
}

#[test]
fn steps_allocate_nothing() {
    for name in [
        "cantilever",
        "revolute_pendulum",
        "spherical_pendulum",
        "double_pendulum",
        "four_bar",
        "slider_crank",
    ] {
        assert_eq!(allocations(name), 0, "{name}");
    }
}
