//! Results do not depend on the order of bodies, joints, loads, contacts and probes in a model.
//!
//! Another order changes the numbering of coordinates and hence the rounding of sums. Runs are short and iterate to
//! rounding, so that these differences stay small.

use ancf::Model;
use ancf::model::{Analysis, Stop};

use crate::common::models::files;
use crate::common::solutions::Run;

/// Columns that depend on the solution procedure.
const EXCLUDED: [&str; 6] = ["iterations", "residual", "increment", "drift", "violation", "balance"];

/// Reads `models/{name}.toml` with a shorter duration and a tighter stopping rule.
fn shortened(name: &str, duration: f64, stop: Stop) -> Model {
    let mut model = files::model(name);
    match &mut model.analysis {
        Analysis::Dynamics(dynamics) => (dynamics.duration, dynamics.stop) = (duration, stop),
        Analysis::Statics(statics) => statics.stop = stop,
        _ => {}
    }
    model
}

fn reversed(mut model: Model) -> Model {
    model.bodies.reverse();
    model.joints.reverse();
    model.loads.reverse();
    model.contacts.reverse();
    model.couplings.reverse();
    model.probes.reverse();
    model
}

fn rotated(mut model: Model) -> Model {
    rotate(&mut model.bodies);
    rotate(&mut model.joints);
    rotate(&mut model.loads);
    rotate(&mut model.probes);
    model
}

fn rotate<T>(list: &mut [T]) {
    if !list.is_empty() {
        list.rotate_left(1);
    }
}

/// Group of columns with a common magnitude: components of a vector, or all energies.
fn group(column: &str) -> &str {
    match column.rsplit_once(['x', 'y', 'z']) {
        Some((vector, "")) if vector.contains('.') => vector,
        _ if ["kinetic", "strain", "potential", "work", "dissipated"].contains(&column) => "energy",
        _ => column,
    }
}

/// Asserts that two runs agree relative to the largest magnitude of the group of each column.
fn compare(name: &str, one: &Run, other: &Run, tolerance: f64) {
    let columns: Vec<_> = one.columns().filter(|(column, _)| !EXCLUDED.contains(column)).collect();
    assert_eq!(
        columns.len() + EXCLUDED.iter().filter(|c| one.columns().any(|(x, _)| x == **c)).count(),
        other.columns().count()
    );
    for (column, values) in &columns {
        let group_values =
            columns.iter().filter(|(c, _)| group(c) == group(column)).flat_map(|(_, values)| values.iter());
        let size = group_values.fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let others = other.column(column);
        assert_eq!(values.len(), others.len(), "{name}: number of rows");
        for (a, b) in values.iter().zip(others) {
            let same = (a.is_nan() && b.is_nan()) || (a - b).abs() <= tolerance * size;
            assert!(same, "{name}, {column}: {a:e} and {b:e}, of {size:e}: {:.1e}", (a - b).abs() / size);
        }
    }
}

/// Iterations to rounding.
const FINE: Stop = Stop::Energy { tolerance: 1e-13 };

/// Asserts that reversed and cyclically permuted models have equal results.
fn assert_order_independent(name: &str, duration: f64, stop: Stop) {
    let model = shortened(name, duration, stop);
    let one = Run::of(&model);
    compare(name, &one, &Run::of(&reversed(model.clone())), 1e-9);
    compare(name, &one, &Run::of(&rotated(model)), 1e-9);
}

#[test]
fn order_does_not_change_a_double_pendulum() {
    assert_order_independent("double_pendulum", 0.1, FINE);
}

#[test]
fn order_does_not_change_a_frame() {
    assert_order_independent("lees_frame", 0.0, FINE);
}

#[test]
fn order_does_not_change_mixed_bodies() {
    assert_order_independent("bow", 0.05, FINE);
}

/// Friction: the tangent is incomplete and convergence is linear. The energy rule would demand less than the rounding error
/// and divide steps at random, hence the increment rule.
#[test]
fn order_does_not_change_contact_on_a_rigid_body() {
    assert_order_independent("belt", 0.03, Stop::Increment { tolerance: 1e-12 });
}

#[test]
fn order_does_not_change_a_mooring_line() {
    assert_order_independent("mooring", 0.0, FINE);
}
