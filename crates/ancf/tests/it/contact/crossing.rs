//! Bodies do not pass through obstacles and through each other between two states.

use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};

fn run(text: &str) -> (Summary, Series) {
    let (model, mut series) = (Model::parse(text).unwrap(), Series::new());
    (simulate(&model, &mut series).unwrap(), series)
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// A rope between two points above a cylinder, soft enough to sag far below it.
fn rope(obstacle: &str, points: &str, analysis: &str) -> String {
    format!(
        r#"
        gravity = [0, 0, -9]
        materials.s = {{ density = 1200, young = 1e5 }}
        sections.c = {{ kind = "circle", diameter = 0.03 }}
        bodies = [{{ kind = "cable", name = "rope", from = [-1, 0, 0.6], to = [1, 0, 0.6], elements = 16, section = "c", material = "s" }}]
        joints = [
          {{ kind = "spherical", name = "l", a = {{ body = "rope", at = "start" }} }},
          {{ kind = "spherical", name = "r", a = {{ body = "rope", at = "end" }} }},
        ]
        contacts = [{{ with = {{ {obstacle} }}, stiffness = 1e6{points} }}]
        probes = [{{ name = "mid", on = {{ body = "rope", at = 1 }} }}]
        analysis = {{ {analysis} }}
        "#
    )
}

const STATICS: &str = r#"kind = "statics""#;
const CYLINDER: &str = r#"kind = "cylinder", point = [0, 0, 0.4], axis = [0, 1, 0], radius = 0.06"#;

/// The rope comes to rest on the cylinder and on a sphere, whatever the increments.
#[test]
fn rope_rests_on_its_obstacle() {
    let sphere = r#"kind = "sphere", center = [0, 0, 0.4], radius = 0.06"#;
    for obstacle in [CYLINDER, sphere] {
        let (summary, series) = run(&rope(obstacle, "", STATICS));
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        let top = 0.4 + 0.06 + 0.015;
        assert!((last(&series, "mid.z") - top).abs() < 2e-3, "{obstacle}: {}", last(&series, "mid.z"));
    }
}

/// A cable clamped at one end sinks over a cylinder and lies on it: the result of small increments.
#[test]
fn cable_lies_over_a_cylinder() {
    let model = |first: &str| {
        format!(
            r#"
            gravity = [0, 0, -9]
            materials.s = {{ density = 1200, young = 1e7 }}
            sections.c = {{ kind = "circle", diameter = 0.02 }}
            bodies = [{{ kind = "cable", name = "rope", from = [-1, 0, 0.5], to = [1, 0, 0.5], elements = 16, section = "c", material = "s" }}]
            joints = [{{ kind = "clamp", name = "l", a = {{ body = "rope", at = "start" }} }}]
            contacts = [{{ with = {{ kind = "cylinder", point = [0, 0, 0], axis = [0, 1, 0], radius = 0.3 }}, stiffness = 1e6 }}]
            probes = [{{ name = "tip", on = {{ body = "rope", at = "end" }} }}]
            analysis = {{ kind = "statics"{first} }}
            "#
        )
    };
    let [one, small] = ["", ", first = 0.01, largest = 0.05"].map(|first| {
        let (summary, series) = run(&model(first));
        assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
        [last(&series, "tip.x"), last(&series, "tip.z")]
    });
    assert!((one[0] - small[0]).abs() < 1e-6 && (one[1] - small[1]).abs() < 1e-6, "{one:?} and {small:?}");
    assert!(one[1] > -0.6, "{one:?}");
}

/// A thin bar between two contact points of the rope: the run fails and states that the rope passes through it.
#[test]
fn obstacle_between_two_points_is_not_passed_silently() {
    let bar = r#"kind = "cylinder", point = [0.001, 0, 0.4], axis = [0, 1, 0], radius = 0.002"#;
    let (summary, _) = run(&rope(bar, ", radius = 0.002, points = 1", STATICS));
    let Outcome::Failed { reason, .. } = &summary.outcome else { panic!("{:?}", summary.outcome) };
    assert!(reason.contains("passes through its contact partner"), "{reason}");
}

/// In dynamics a step that passes through an obstacle is divided.
#[test]
fn falling_rope_does_not_pass_a_bar_within_a_step() {
    let analysis = r#"kind = "dynamics", duration = 0.4, step = 0.1"#;
    let (summary, series) = run(&rope(CYLINDER, ", damping = 1", analysis));
    if summary.outcome.is_finished() {
        assert!(last(&series, "mid.z") > 0.4, "{}", last(&series, "mid.z"));
    }
}

/// A falling rope comes to rest on a crossing beam, which is thinner than the way of the rope within an increment.
#[test]
fn rope_rests_on_a_crossing_beam() {
    let text = r#"
        materials.s = { density = 1200, young = 1e5 }
        materials.steel = { density = 7800, young = 2e11 }
        sections.c = { kind = "circle", diameter = 0.03 }
        gravity = [0, 0, -9]
        bodies = [
          { kind = "cable", name = "rope", from = [-1, 0, 0.6], to = [1, 0, 0.6], elements = 16, section = "c", material = "s" },
          { kind = "beam", name = "bar", from = [0.01, -0.3, 0.45], to = [0.01, 0.3, 0.45], elements = 2, formulation = "linked", section = "c", material = "steel" },
        ]
        joints = [
          { kind = "spherical", name = "l", a = { body = "rope", at = "start" } },
          { kind = "spherical", name = "r", a = { body = "rope", at = "end" } },
          { kind = "clamp", name = "b0", a = { body = "bar", at = "start" } },
          { kind = "clamp", name = "b1", a = { body = "bar", at = "end" } },
        ]
        contacts = [{ with = { kind = "bodies" }, stiffness = 1e6 }]
        probes = [{ name = "mid", on = { body = "rope", at = 1.01 } }]
        analysis = { kind = "statics" }
    "#;
    let (summary, series) = run(text);
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    assert!((last(&series, "mid.z") - 0.48).abs() < 3e-3, "{}", last(&series, "mid.z"));
}
