//! Sliding joints along beams, against closed forms.

use std::f64::consts::PI;

use ancf::Model;
use nalgebra::Vector3;

use crate::common::models::jointed_body::{DYNAMICS, STATICS};
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Mass of 1 kg on a stiff beam inclined by 30°, sliding across element boundaries.
fn incline(keys: &str) -> Model {
    let (sin, cos) = (PI / 6.0).sin_cos();
    parse(&format!(
        r#"
gravity = [0, 0, -10]
materials.stiff = {{ density = 10, young = 1e12 }}
sections.round = {{ kind = "circle", diameter = 0.1 }}
bodies = [
  {{ kind = "beam", name = "ramp", from = [0, 0, {z}], to = [{x}, 0, 0], elements = 4, formulation = "linked", section = "round", material = "stiff" }},
  {{ kind = "mass", name = "bead", center = [{bx}, 0, {bz}], mass = 1 }},
]
joints = [
  {{ kind = "clamp", name = "top", a = {{ body = "ramp", at = "start" }} }},
  {{ kind = "clamp", name = "foot", a = {{ body = "ramp", at = "end" }} }},
  {{ kind = "slide", name = "slide", a = {{ body = "bead", at = "center" }}, b = {{ body = "ramp", at = 0.2 }} {keys} }},
]
{DYNAMICS}"#,
        x = 4.0 * cos,
        z = 4.0 * sin,
        bx = 0.2 * cos,
        bz = 3.8 * sin,
    ))
}

/// s = s₀ + ½ g sin α t², with friction ½ (g sin α − F/m) t²; normal force m g cos α.
#[test]
fn bead_accelerates_uniformly_on_an_incline() {
    for (keys, acceleration) in [("", 5.0), (", friction = { force = 2, speed = 1e-4 }", 3.0)] {
        let run = Run::of(&incline(keys));
        for (k, t) in run.column("t").iter().enumerate().skip(50) {
            let (s, v) = (run.column("slide.position")[k], run.column("slide.speed")[k]);
            // Friction acts from the middle of the first step on.
            let late = if keys.is_empty() { 0.0 } else { 0.5 * 1e-3 * 2.0 };
            assert!((s - 0.2 - 0.5 * acceleration * t * t).abs() < 2e-4 + late * t, "{keys}: {s} at {t}");
            assert!((v - acceleration * t).abs() < 2e-4 + 1.2 * late, "{keys}: {v} at {t}");
            let force = Vector3::new(run.column("slide.fx")[k], 0.0, run.column("slide.fz")[k]);
            let normal = force.dot(&Vector3::new(0.5, 0.0, 0.75_f64.sqrt()));
            assert!((normal - 10.0 * 0.75_f64.sqrt()).abs() < 0.05, "{keys}: {normal} at {t}");
        }
        assert!(run.column("slide.position").last().unwrap() > &1.2, "element boundaries were crossed");
    }
}

/// The failure at the end of the beam names the joint.
#[test]
fn bead_at_the_end_of_the_beam_is_a_failure() {
    let mut falling = incline("");
    if let Some(dynamics) = falling.analysis.dynamics_mut() {
        dynamics.duration = 2.0;
    }
    let mut series = ancf::record::Series::new();
    let summary = ancf::simulate(&falling, &mut series).unwrap();
    let ancf::Outcome::Failed { time, reason, at, .. } = &summary.outcome else {
        panic!("{:?}", summary.outcome)
    };
    // ½ 5 t² = 3.8.
    assert!((time - 1.233).abs() < 0.01 && at.contains("slide"), "{time}, {at}");
    assert!(reason.starts_with("the solution is inadmissible: a slider leaves its beam ("), "{reason}");
}

/// r̈ = θ̇² r with θ = 2 t³, solved by a power series in t.
#[test]
fn bead_on_a_rotating_rod_moves_outwards() {
    let run = Run::of(&parse(&format!(
        r#"
materials.stiff = {{ density = 10, young = 1e13 }}
sections.round = {{ kind = "circle", diameter = 0.1 }}
bodies = [
  {{ kind = "beam", name = "rod", from = [0, 0, 0], to = [2, 0, 0], elements = 3, formulation = "linked", section = "round", material = "stiff" }},
  {{ kind = "mass", name = "bead", center = [0.4, 0, 0], mass = 1e-3 }},
]
joints = [
  {{ kind = "revolute", name = "motor", a = {{ body = "rod", at = "start" }}, axis = [0, 0, 1], drive = {{ angle = 2, time = {{ kind = "expression", text = "t^3" }} }} }},
  {{ kind = "slide", name = "slide", a = {{ body = "bead", at = "center" }}, b = {{ body = "rod", at = 0.4 }} }},
]
{DYNAMICS}"#
    )));
    for (k, t) in run.column("t").iter().enumerate() {
        // r = r₀ Σ cₙ t⁶ⁿ, cₙ₊₁ (6n + 6)(6n + 5) = 36 cₙ.
        let (mut sum, mut part) = (0.0, 0.4);
        for n in 0..10 {
            sum += part;
            part *= 36.0 * t.powi(6) / f64::from((6 * n + 6) * (6 * n + 5));
        }
        let r = run.column("slide.position")[k];
        assert!((r - sum).abs() < 1e-4, "{r} for {sum} at {t}");
    }
}

/// Adaptive steps across element boundaries of a swinging soft cable agree with small fixed steps.
#[test]
fn adaptive_steps_cross_element_boundaries() {
    let soft = |step: &str, young: &str| {
        let text = format!(
            r#"
gravity = [0, 0, -10]
materials.soft = {{ density = 1000, young = {young}, damping = {{ strain = 1e-3 }} }}
sections.round = {{ kind = "circle", diameter = 0.05 }}
bodies = [
  {{ kind = "cable", name = "line", from = [0, 0, 0], to = [2, 0, 0], elements = 8, section = "round", material = "soft" }},
  {{ kind = "mass", name = "bead", center = [0.3, 0, 0], mass = 0.5 }},
]
joints = [
  {{ kind = "spherical", name = "left", a = {{ body = "line", at = "start" }} }},
  {{ kind = "spherical", name = "right", a = {{ body = "line", at = "end" }} }},
  {{ kind = "slide", name = "slide", a = {{ body = "bead", at = "center" }}, b = {{ body = "line", at = 0.3 }} }},
]
[analysis]
kind = "dynamics"
duration = 1
step = {step}
scheme = {{ spectral_radius = 0.8 }}
"#
        );
        Run::of(&parse(&text))
    };
    let (fine, adaptive) = (soft("2.5e-4", "2e6"), soft("{ tolerance = 1e-4 }", "2e6"));
    let [s, t] = [&fine, &adaptive].map(|run| run.last("slide.position"));
    assert!((s - t).abs() < 2e-3, "{s} and {t}");
    assert!(s > 0.6, "element boundaries were crossed: {s}");
    let (balance, size) = (fine.largest("balance"), fine.largest("kinetic"));
    assert!(balance < 1e-2 * size, "{balance} of {size}");
}

/// Deflection P a³/(3 E I) under a weight, after a prescribed displacement along the beam across element boundaries.
#[test]
fn weight_moved_along_a_cantilever_has_its_static_deflection() {
    let at = |place: f64, displacement: f64| {
        parse(&format!(
            r#"
gravity = [0, 0, -10]
materials.stiff = {{ density = 1e-6, young = 2e11 }}
sections.round = {{ kind = "circle", diameter = 0.05 }}
bodies = [
  {{ kind = "beam", name = "arm", from = [0, 0, 0], to = [2, 0, 0], elements = 5, formulation = "linked", section = "round", material = "stiff" }},
  {{ kind = "mass", name = "weight", center = [{place}, 0, 0], mass = 10 }},
]
joints = [
  {{ kind = "clamp", name = "root", a = {{ body = "arm", at = "start" }} }},
  {{ kind = "slide", name = "trolley", a = {{ body = "weight", at = "center" }}, b = {{ body = "arm", at = {place} }}, drive = {{ displacement = {displacement} }} }},
]
probes = [{{ name = "weight", on = {{ body = "weight", at = "center" }} }}]
{STATICS}"#
        ))
    };
    let bending = 2e11 * PI * 0.05_f64.powi(4) / 64.0;
    for (place, displacement) in [(1.6, 0.0), (0.5, 0.7), (1.1, 0.6), (1.9, -0.8)] {
        let run = Run::of(&at(place, displacement));
        let end = place + displacement;
        let deflection = -100.0 * end.powi(3) / (3.0 * bending);
        assert!(
            (run.last("trolley.position") - end).abs() < 1e-9,
            "{place}: {}",
            run.last("trolley.position")
        );
        assert!(
            (run.last("weight.z") - deflection).abs() < 2e-2 * deflection.abs(),
            "{place}: {} {deflection}",
            run.last("weight.z")
        );
        assert!((run.last("trolley.fz") - 100.0).abs() < 1e-6, "{place}: {}", run.last("trolley.fz"));
        assert!((run.last("root.my") + 100.0 * end).abs() < 0.1, "{place}: {}", run.last("root.my"));
    }
}
