//! The reference length of models without flexible bodies, and with it the steps of error control, depends neither on units nor on the
//! order of bodies.

use ancf::Model;
use ancf::units::Scales;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

const ANALYSIS: &str = "analysis = { kind = \"dynamics\", duration = 2, step = { tolerance = 1e-4 } }\n";

/// A point mass under a force that varies: there is no length besides the distance that it moves.
fn driven_mass() -> Model {
    parse(&format!(
        "gravity = [0, 0, -9.81]
        bodies = [{{ kind = \"mass\", name = \"ball\", mass = 2, center = [0.3, 0, 0] }}]
        loads = [{{ kind = \"force\", on = {{ body = \"ball\", at = \"center\" }}, force = [30, 0, 0], time = {{ kind = \"sine\", frequency = 3 }} }}]
        probes = [{{ name = \"ball\", on = {{ body = \"ball\", at = \"center\" }} }}]
        {ANALYSIS}"
    ))
}

/// Two rods that hang on a hinge and on each other.
fn double_pendulum() -> Model {
    let rod = |name: &str, x: f64, mass: f64| {
        format!(
            "{{ kind = \"rigid\", name = \"{name}\", mass = {mass}, center = [{x}, 0, 0], inertia = [0.01, 0.2, 0.2] }}"
        )
    };
    parse(&format!(
        "gravity = [0, 0, -9.81]
        bodies = [{}, {}]
        joints = [
            {{ kind = \"revolute\", name = \"top\", a = {{ body = \"one\", at = \"center\", offset = [-0.5, 0, 0] }}, axis = [0, 1, 0] }},
            {{ kind = \"revolute\", name = \"middle\", a = {{ body = \"two\", at = \"center\", offset = [-0.2, 0, 0] }}, b = {{ body = \"one\", at = \"center\", offset = [0.5, 0, 0] }}, axis = [0, 1, 0] }},
        ]
        probes = [{{ name = \"tip\", on = {{ body = \"two\", at = \"center\" }} }}]
        {ANALYSIS}",
        rod("one", 0.5, 1.0),
        rod("two", 1.2, 0.4)
    ))
}

#[test]
fn units_do_not_change_the_steps() {
    for model in [driven_mass(), double_pendulum()] {
        for scales in
            [Scales { length: 1e-3, time: 1.0, force: 1.0 }, Scales { length: 250.0, time: 0.2, force: 7.0 }]
        {
            let other = model.scaled(&scales);
            assert_relative("length", other.length() * scales.length, model.length(), 1e-14);
            let [one, other] = [&model, &other].map(Run::of);
            assert!(one.summary.steps > 20);
            assert_eq!(one.summary.steps, other.summary.steps);
        }
    }
}

#[test]
fn the_order_of_rigid_bodies_does_not_change_the_steps() {
    let model = double_pendulum();
    let mut reversed = model.clone();
    reversed.bodies.reverse();
    reversed.joints.reverse();
    assert_relative("length", reversed.length(), model.length(), 1e-14);
    assert_eq!(Run::of(&model).summary.steps, Run::of(&reversed).summary.steps);
}
