//! Prescribed rotations of any size: the equilibrium is that of the path from the undeformed state.

use std::f64::consts::{PI, TAU};

use ancf::record::Series;
use ancf::{Model, simulate};

const YOUNG: f64 = 3e9;
const DIAMETER: f64 = 0.03;
const LENGTH: f64 = 1.5;

/// Second moment of area.
fn second() -> f64 {
    PI * DIAMETER.powi(4) / 64.0
}

/// A beam along x with the given joints, in equilibrium.
fn run(formulation: &str, elements: usize, joints: &str, settings: &str) -> Series {
    let text = format!(
        r#"
        materials.s = {{ density = 1000, young = {YOUNG} }}
        sections.c = {{ kind = "circle", diameter = {DIAMETER} }}
        bodies = [{{ kind = "beam", name = "arm", from = [0, 0, 0], to = [{LENGTH}, 0, 0], elements = {elements}, formulation = "{formulation}", section = "c", material = "s" }}]
        joints = [{joints}]
        probes = [
          {{ name = "tip", on = {{ body = "arm", at = "end" }} }},
          {{ name = "mid", on = {{ body = "arm", at = {mid} }}, record = ["motion", "section_forces"] }},
        ]
        analysis = {{ kind = "statics"{settings} }}
        "#,
        mid = 0.5 * LENGTH
    );
    let (model, mut series) = (Model::parse(&text).unwrap(), Series::new());
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{formulation}, {joints}: {:?}", summary.outcome);
    let other = |warning: &&String| !warning.contains("locking");
    assert_eq!(summary.warnings.iter().find(other), None, "{formulation}, {joints}");
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

const ROOT: &str = r#"{ kind = "clamp", name = "root", a = { body = "arm", at = "start" } }"#;

/// The torque of a twist is G J α/L, also beyond half a turn and beyond whole turns.
#[test]
fn twist_of_any_size_has_its_torque() {
    for (formulation, twist) in [("quadratic", 0.85 * PI), ("quadratic", TAU), ("quadratic", -1.5 * TAU)] {
        let motor = format!(
            r#"{{ kind = "drive", name = "motor", a = {{ body = "arm", at = "end" }}, axis = [1, 0, 0], angle = {twist}, time = 1 }}"#
        );
        // The twist shortens the fibres, so the rates are those of a thin section: κ² D² is small.
        let series = run(formulation, 12, &format!("{ROOT}, {motor}"), "");
        let torque = 0.5 * YOUNG * 2.0 * second() * twist / LENGTH;
        assert!(
            (last(&series, "mid.T") / torque - 1.0).abs() < 0.02,
            "{formulation} {twist}: {}",
            last(&series, "mid.T") / torque
        );
    }
}

/// A beam bent to a full circle by the rotation of its end: radius L/2π, energy ½ E I (2π/L)² L.
#[test]
fn beam_is_bent_to_a_full_circle() {
    let motor = format!(
        r#"{{ kind = "drive", name = "motor", a = {{ body = "arm", at = "end" }}, axis = [0, 0, 1], angle = {TAU}, displacement = [{}, 0, 0], time = 1 }}"#,
        -LENGTH
    );
    let series = run("quadratic", 12, &format!("{ROOT}, {motor}"), "");
    let energy = 0.5 * YOUNG * second() * TAU.powi(2) / LENGTH;
    assert!((last(&series, "mid.y") * PI / LENGTH - 1.0).abs() < 0.02, "{}", last(&series, "mid.y"));
    assert!((last(&series, "strain") / energy - 1.0).abs() < 0.05, "{}", last(&series, "strain") / energy);
}

/// An arm on a driven hinge, otherwise free to turn, follows the hinge without strain.
#[test]
fn free_arm_follows_its_hinge() {
    for (formulation, angle) in
        [("linked", 0.3 * PI), ("linked", 0.85 * PI), ("enhanced", -TAU), ("continuum", 20.0 * PI + 1.0)]
    {
        let hinge = format!(
            r#"{{ kind = "revolute", name = "hinge", a = {{ body = "arm", at = "start" }}, axis = [0, 0, 1], drive = {{ angle = {angle}, time = 1 }} }}"#
        );
        let series = run(formulation, 4, &hinge, "");
        let (x, y) = (last(&series, "tip.x"), last(&series, "tip.y"));
        let error = (x - LENGTH * angle.cos()).hypot(y - LENGTH * angle.sin());
        assert!(error < 1e-7, "{formulation} {angle}: {x}, {y}");
        assert!(last(&series, "strain") < 1e-9);
        assert!((last(&series, "hinge.angle") - angle).abs() < 1e-9);
    }
}

/// The key `largest` limits the increments.
#[test]
fn largest_increment_is_a_key() {
    let motor = r#"{ kind = "drive", name = "motor", a = { body = "arm", at = "end" }, axis = [1, 0, 0], angle = 0.1, time = 1 }"#;
    for (largest, rows) in [("1", 2), ("0.25", 5)] {
        let series = run("quadratic", 4, &format!("{ROOT}, {motor}"), &format!(", largest = {largest}"));
        assert_eq!(series.column("load").unwrap().len(), rows);
    }
}

/// A rigid body on a driven hinge has the driven rotation, whatever loads its joint carries and however they are applied. The loads do
/// no work, and the energy of an increment is zero however open the constraints are.
#[test]
fn driven_body_rotates_by_the_drive() {
    for (angle, first, unit) in [(0.87, 0.25, 1.0), (0.87, 0.25, 2.08), (-1.9, 0.1, 1e3), (0.3, 1.0, 1e-3)] {
        let (angle, hinge, reach): (f64, f64, f64) = (angle, 0.2 * unit, 0.35 * unit);
        let text = format!(
            r#"
            bodies = [{{ kind = "rigid", name = "arm", center = [{hinge}, 0, 0], mass = 1, inertia = [0.02, 0.03, 0.04] }}]
            joints = [{{ kind = "revolute", name = "hinge", a = {{ body = "arm", at = [{hinge}, 0, 0] }}, axis = [0, 0, 1], drive = {{ angle = {angle} }} }}]
            loads = [{{ kind = "force", on = {{ body = "arm", at = [{hinge}, 0, 0] }}, force = [48.7, 33.4, -66.6] }}]
            probes = [{{ name = "tip", on = {{ body = "arm", at = [{}, 0, 0] }} }}]
            analysis = {{ kind = "statics", first = {first} }}
            "#,
            hinge + reach
        );
        let (model, mut series) = (Model::parse(&text).unwrap(), Series::new());
        assert!(simulate(&model, &mut series).unwrap().outcome.is_finished());
        for (name, exact) in [("tip.x", hinge + reach * angle.cos()), ("tip.y", reach * angle.sin())] {
            let found = last(&series, name);
            assert!((found - exact).abs() < 1e-11 * unit, "{name}: {found} for {exact}, unit {unit}");
        }
    }
}
