//! Results do not depend on the order in which a model names its bodies, joints, loads, contacts and probes.
//!
//! Another order numbers coordinates otherwise, hence sums are rounded otherwise: in the last digit of a step, which
//! the motion carries on, and by what an iteration leaves behind when it stops. Runs are short and iterate to rounding.

use std::path::Path;

use crate::common::solutions::Run;
use ancf::Model;
use ancf::model::{Analysis, Stop};

/// Columns that tell of the solver.
const SOLVER: [&str; 6] = ["iterations", "residual", "increment", "drift", "violation", "balance"];

/// A model of `models/`, with a shorter motion and a finer end of iterations.
fn model(name: &str, duration: f64, stop: Stop) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(name).with_extension("toml");
    let mut model = Model::read(&path).unwrap();
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

/// The group of a column, by whose largest value its errors are judged: components of one vector, and all energies.
fn group(column: &str) -> &str {
    match column.rsplit_once(['x', 'y', 'z']) {
        Some((vector, "")) if vector.contains('.') => vector,
        _ if ["kinetic", "strain", "potential", "work", "dissipated"].contains(&column) => "energy",
        _ => column,
    }
}

fn compare(name: &str, one: &Run, other: &Run, tolerance: f64) {
    let columns: Vec<_> = one.columns().filter(|(column, _)| !SOLVER.contains(column)).collect();
    assert_eq!(
        columns.len() + SOLVER.iter().filter(|c| one.columns().any(|(x, _)| x == **c)).count(),
        other.columns().count()
    );
    for (column, values) in &columns {
        let alike =
            columns.iter().filter(|(c, _)| group(c) == group(column)).flat_map(|(_, values)| values.iter());
        let size = alike.fold(0.0_f64, |most, x| most.max(x.abs()));
        let others = other.column(column);
        assert_eq!(values.len(), others.len(), "{name}: as many rows");
        for (a, b) in values.iter().zip(others) {
            let same = (a.is_nan() && b.is_nan()) || (a - b).abs() <= tolerance * size;
            assert!(same, "{name}, {column}: {a:e} and {b:e}, of {size:e}: {:.1e}", (a - b).abs() / size);
        }
    }
}

const FINE: Stop = Stop::Energy { tolerance: 1e-13 };

fn check(name: &str, duration: f64, stop: Stop) {
    let model = model(name, duration, stop);
    let one = Run::of(&model);
    compare(name, &one, &Run::of(&reversed(model.clone())), 1e-9);
    compare(name, &one, &Run::of(&rotated(model)), 1e-9);
}

#[test]
fn two_pendulums() {
    check("double_pendulum", 0.1, FINE);
}

#[test]
fn a_frame() {
    check("lees_frame", 0.0, FINE);
}

#[test]
fn bodies_of_all_kinds() {
    check("bow", 0.05, FINE);
}

/// With friction the tangent is not exact and iterations end slowly. An energy of 1e-26 is below their rounding, so that chance
/// decides when they give up and halve the step: then the error of the step is what differs.
#[test]
fn a_contact_on_a_rigid_body() {
    check("belt", 0.03, Stop::Increment { tolerance: 1e-12 });
}

#[test]
fn a_line_in_water() {
    check("mooring", 0.0, FINE);
}
