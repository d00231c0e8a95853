//! The step loop allocates nothing: all storage is there before the first step.
#![cfg(test)]

use std::path::Path;

use ancf::Model;
use ancf::analysis::{Dynamics, Newton};
use ancf::model::Step;
use ancf::system::EquationsOfMotion;

/// Allocations in a hundred steps of a model, after a few that find what they need.
fn allocations(name: &str) -> u64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../models/{name}.toml"));
    let model = Model::read(&path).unwrap();
    let model = model.scaled(&model.scales().scales);
    let assembly = model.assemble().unwrap();
    let settings = model.analysis.dynamics().unwrap();
    let Step::Fixed(h) = settings.step else { panic!("{name}: steps of one size are asked for") };
    let newton =
        Newton::new(assembly.system.matrix(), settings.stop.into(), settings.max_iterations).unwrap();
    let start = assembly.start(&model);
    let mut dynamics = Dynamics::new(&assembly.system, settings.scheme.numbers(), newton, 5, start);
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
