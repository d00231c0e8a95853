//! Steps with error control resolve laws with kinks: a body that meets a stop or a rope rebounds elastically.

use std::f64::consts::PI;

use crate::common::models::parse;
use crate::common::solutions::Run;

const MASS: f64 = 2.0;
const STIFFNESS: f64 = 1e6;
const SPEED: f64 = 1.5;
const GAP: f64 = 0.1;
const DURATION: f64 = 0.5;
const TOLERANCE: f64 = 1e-4;
/// Five times the tolerance relative to the extent of the model, 4 m.
const ALLOWED: f64 = 5.0 * TOLERANCE * 4.0;

/// A block that moves along x, beside a body that determines the size of the model and moves freely.
fn block(joint: &str) -> Run {
    Run::of(&parse(&format!(
        "bodies = [
          {{ kind = \"rigid\", name = \"other\", center = [0, 3, 0], mass = 2, inertia = [1, 1, 1], motion = {{ velocity = [0, 12, 0] }} }},
          {{ kind = \"rigid\", name = \"block\", center = [0, 0, 0], mass = {MASS}, inertia = [1, 1, 1], motion = {{ velocity = [{SPEED}, 0, 0] }} }},
        ]
        joints = [{{ name = \"law\", a = {{ body = \"block\", at = \"center\" }}, {joint} }}]
        probes = [{{ name = \"block\", on = {{ body = \"block\", at = \"center\" }} }}]
        analysis = {{ kind = \"dynamics\", duration = {DURATION}, step = {{ tolerance = {TOLERANCE} }}, scheme = {{ spectral_radius = 0.8 }} }}"
    )))
}

/// Rebound from a linear spring that acts beyond the gap: the motion is reversed after half a period, π √(m/k).
fn assert_rebound(what: &str, run: &Run) {
    let free = DURATION - GAP / SPEED - PI * (MASS / STIFFNESS).sqrt();
    let (x, expected) = (run.last("block.x"), GAP - SPEED * free);
    assert!((x - expected).abs() < ALLOWED, "{what}: {x}, not {expected}, {} steps", run.summary.steps);
    assert!((run.last("block.vx") + SPEED).abs() < 0.02 * SPEED, "{what}: {}", run.last("block.vx"));
}

#[test]
fn ropes_rebound() {
    let rope = format!(
        "kind = \"spring\", b = {{ point = [-1, 0, 0] }}, length = {}, stiffness = {STIFFNESS}, tension_only = true",
        1.0 + GAP
    );
    assert_rebound("rope", &block(&rope));
}

#[test]
fn laws_by_formulas_rebound() {
    let tension = format!("if(length > {0}, {STIFFNESS}*(length - {0}), 0)", 1.0 + GAP);
    let law = format!(
        "kind = \"spring\", b = {{ point = [-1, 0, 0] }}, length = 1, tension = {{ kind = \"expression\", text = \"{tension}\" }}"
    );
    assert_rebound("formula", &block(&law));
    let force = format!("-{STIFFNESS}*max(x - {GAP}, 0)");
    let law = format!(
        "kind = \"prismatic\", axis = [1, 0, 0], force = {{ kind = \"expression\", text = \"{force}\" }}"
    );
    assert_rebound("force of a guide", &block(&law));
}

/// The contact law of stops is quadratic over the transition, 0.1 mm, in which the block spends less than 0.2 ms.
#[test]
fn stops_rebound() {
    let stops = format!(
        "kind = \"prismatic\", axis = [1, 0, 0], stops = {{ upper = {GAP}, stiffness = {STIFFNESS}, transition = 1e-4 }}"
    );
    assert_rebound("stop", &block(&stops));
}

/// Dry friction F stops the block after v²/(2 a), a = F/m.
#[test]
fn friction_stops_a_block() {
    let friction = "kind = \"prismatic\", axis = [1, 0, 0], friction = { force = 10, speed = 1e-4 }";
    let run = block(friction);
    let expected = SPEED * SPEED / (2.0 * 10.0 / MASS);
    let (x, steps) = (run.last("block.x"), run.summary.steps);
    assert!((x - expected).abs() < ALLOWED, "{x}, not {expected}, {steps} steps");
}
