//! Error-controlled steps approach contacts and resolve impacts.

use std::f64::consts::PI;

use ancf::record::Series;
use ancf::{Model, Outcome, Summary, simulate};

fn run(text: &str) -> (Summary, Series) {
    let (model, mut series) = (Model::parse(text).unwrap(), Series::new());
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    (summary, series)
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

fn step(tolerance: f64) -> String {
    format!("{{ tolerance = {tolerance} }}")
}

const PLANE: &str = r#"{ kind = "plane", point = [0, 0, 0], normal = [0, 0, 1] }"#;

/// A body with a surface at a height of 1 that moves down with a speed of 6.
fn thrown(body: &str, contacts: &str, duration: f64, step: &str) -> String {
    format!(
        r#"
        bodies = [{{ name = "b", center = [0, 0, 1], mass = 3, motion = {{ velocity = [0, 0, -6] }}, {body} }}]
        contacts = [{contacts}]
        probes = [{{ name = "b", on = {{ body = "b", at = "center" }} }}]
        analysis = {{ kind = "dynamics", duration = {duration}, step = {step}, scheme = {{ spectral_radius = 0.8 }} }}
        "#
    )
}

const BALL: &str = r#"kind = "mass", surface = { radius = 0.1 }"#;
const TRANSITION: f64 = 2e-4;

/// Duration of an impact of a speed v on a spring: half a period π/ω, and δ/v for the transition of the stiffness.
fn impact_time(stiffness: f64, v: f64) -> f64 {
    PI / (stiffness / 3.0).sqrt() + TRANSITION / v
}

/// Heights after one impact: errors are below the tolerance and fall with it. The motion is that of a half sine.
#[test]
fn bounce_of_a_ball_is_within_the_tolerance() {
    let rigid = r#"kind = "rigid", inertia = [0.02, 0.02, 0.02], surface = { radius = 0.1 }"#;
    for (body, length) in [(BALL, 1.0), (rigid, 0.1414)] {
        let errors = [1e-2, 1e-3, 1e-4].map(|tolerance| {
            // The stiffness acts over the diameter of 0.2.
            let contact = format!("{{ with = {PLANE}, stiffness = 5e5, transition = {TRANSITION} }}");
            let (_, series) = run(&thrown(body, &contact, 0.5, &step(tolerance)));
            let z = 0.1 + 6.0 * (0.5 - 0.15 - impact_time(1e5, 6.0));
            let energy = 0.5 * 3.0 * 36.0;
            assert!((last(&series, "kinetic") / energy - 1.0).abs() < 2.0 * tolerance, "{tolerance}");
            (last(&series, "b.z") - z).abs() / length / tolerance
        });
        assert!(errors.iter().all(|error| *error < 1.0), "{body}: {errors:?} of the tolerances");
    }
}

/// A ball between two planes bounces nine times.
#[test]
fn ball_between_two_planes_keeps_its_period() {
    let above = r#"{ kind = "plane", point = [0, 0, 1.7], normal = [0, 0, -1] }"#;
    let contact = |with: &str| format!("{{ with = {with}, stiffness = 4e6, transition = {TRANSITION} }}");
    let contacts = format!("{}, {}", contact(PLANE), contact(above));
    let (summary, series) = run(&thrown(BALL, &contacts, 2.45, &step(1e-3)));
    // From the first touch at t = 0.15, flights of 1.5 and impacts alternate.
    let (flight, impact) = (1.5 / 6.0, impact_time(8e5, 6.0));
    let left = (2.45 - 0.15) % (2.0 * (flight + impact));
    let z = if left < impact {
        panic!("the comparison is in flight")
    } else if left < impact + flight {
        0.1 + 6.0 * (left - impact)
    } else {
        1.6 - 6.0 * (left - 2.0 * impact - flight)
    };
    assert!(
        (last(&series, "b.z") - z).abs() < 1e-3,
        "{} not {z}, {} steps",
        last(&series, "b.z"),
        summary.steps
    );
    assert!((last(&series, "kinetic") / 54.0 - 1.0).abs() < 1e-3);
}

/// Thrown along the horizontal past a ball and a bar: a graze between the ends of a long step deflects the body.
#[test]
fn grazing_contact_is_not_passed_over() {
    let obstacles = [
        r#"{ kind = "sphere", center = [0, 0, -4], radius = 0.5 }"#,
        r#"{ kind = "cylinder", point = [0, 0, -4], axis = [0, 1, 0], radius = 0.5 }"#,
    ];
    for obstacle in obstacles {
        // Offset of 0.58 from the axis: a depth of 0.02 of the sum of the radii, 0.6.
        let text = |tolerance: f64| {
            let contact = format!("{{ with = {obstacle}, stiffness = 5e5, transition = {TRANSITION} }}");
            let text = thrown(BALL, &contact, 1.5, &step(tolerance));
            text.replace("center = [0, 0, 1], mass", "center = [0.58, 0, 1], mass")
        };
        let [coarse, fine] = [1e-2, 1e-4].map(|tolerance| {
            let (_, series) = run(&text(tolerance));
            [last(&series, "b.vx"), last(&series, "b.vz"), last(&series, "b.x")]
        });
        assert!(fine[0] > 1.0, "{obstacle}: {fine:?}");
        assert!((fine[0].hypot(fine[1]) - 6.0).abs() < 1e-3, "{obstacle}: {fine:?}");
        assert!((coarse[0] - fine[0]).abs() < 0.05, "{obstacle}: {coarse:?}, {fine:?}");
        assert!((coarse[2] - fine[2]).abs() < 2e-2, "{obstacle}: {coarse:?}, {fine:?}");
    }
}

/// A stick that falls flat on a plane keeps its energy and its momentum.
#[test]
fn stick_keeps_its_energy() {
    let heights = [1e-2, 1e-3].map(|tolerance| {
        let text = format!(
            r#"
            materials.s = {{ density = 800, young = 4e6 }}
            sections.c = {{ kind = "circle", diameter = 0.03 }}
            bodies = [{{ kind = "cable", name = "stick", from = [-0.15, 0, 0.5], to = [0.15, 0, 0.5], elements = 3, section = "c", material = "s", motion = {{ velocity = [0, 0, -8] }} }}]
            probes = [{{ name = "mid", on = {{ body = "stick", at = 0.15 }} }}]
            contacts = [{{ with = {PLANE}, stiffness = 4e5 }}]
            analysis = {{ kind = "dynamics", duration = 0.12, step = {{ tolerance = {tolerance} }}, scheme = {{ spectral_radius = 0.8 }} }}
            "#
        );
        let (_, series) = run(&text);
        let energy = last(&series, "kinetic") + last(&series, "strain");
        let before = 0.5 * 800.0 * PI * 0.015_f64.powi(2) * 0.3 * 64.0;
        assert!((energy / before - 1.0).abs() < 2.0 * tolerance, "{tolerance}: {energy} of {before}");
        last(&series, "mid.z")
    });
    assert!((heights[0] - heights[1]).abs() < 1e-2 * 0.3, "{heights:?}");
}

/// Two parallel rods with a high relative speed exchange their velocities.
#[test]
fn fast_rods_exchange_their_velocities() {
    let text = r#"
        materials.s = { density = 1000, young = 1e9 }
        sections.c = { kind = "circle", diameter = 0.02 }
        bodies = [
          { kind = "cable", name = "still", from = [0, 0, 0], to = [0.1, 0, 0], elements = 2, section = "c", material = "s" },
          { kind = "cable", name = "fast", from = [0, 1, 0], to = [0.1, 1, 0], elements = 2, section = "c", material = "s", motion = { velocity = [0, -25, 0] } },
        ]
        probes = [{ name = "s", on = { body = "still", at = 0.05 } }, { name = "f", on = { body = "fast", at = 0.05 } }]
        contacts = [{ with = { kind = "bodies" }, stiffness = 2e7 }]
        analysis = { kind = "dynamics", duration = 0.08, step = { tolerance = 1e-2 }, scheme = { spectral_radius = 0.8 } }
    "#;
    let (summary, series) = run(text);
    let energy = 0.5 * 1000.0 * PI * 1e-4 * 0.1 * 625.0;
    let now = last(&series, "kinetic") + last(&series, "strain");
    assert!((now / energy - 1.0).abs() < 2e-2, "{now} of {energy}, {} steps", summary.steps);
    // The impact takes half a period of the reduced mass.
    let gone = 0.08 - 0.98 / 25.0 - PI / (2.0_f64 * 2e7 / (1000.0 * PI * 1e-4)).sqrt();
    let (still, fast) = (last(&series, "s.y"), last(&series, "f.y"));
    assert!((still + 25.0 * gone).abs() < 0.02, "{still} not {}", -25.0 * gone);
    assert!((fast - 0.02).abs() < 0.02, "{fast}");
}

/// A cable that falls on a cylinder: the same motion as with small steps.
#[test]
fn falling_cable_lands_on_a_cylinder() {
    let heights = ["{ tolerance = 1e-3 }", "5e-5"].map(|step| {
        let text = format!(
            r#"
            gravity = [0, 0, -9.81]
            materials.s = {{ density = 1200, young = 1e6, damping = {{ strain = 1e-3 }} }}
            sections.c = {{ kind = "circle", diameter = 0.02 }}
            bodies = [{{ kind = "cable", name = "rope", from = [-0.3, 0, 0.5], to = [0.3, 0, 0.5], elements = 6, section = "c", material = "s" }}]
            contacts = [{{ with = {{ kind = "cylinder", point = [0, 0, 0], axis = [0, 1, 0], radius = 0.2 }}, stiffness = 1e5, damping = 1 }}]
            probes = [{{ name = "mid", on = {{ body = "rope", at = 0.3 }} }}, {{ name = "end", on = {{ body = "rope", at = "end" }} }}]
            analysis = {{ kind = "dynamics", duration = 0.35, step = {step}, scheme = {{ spectral_radius = 0.8 }} }}
            "#
        );
        let (_, series) = run(&text);
        [last(&series, "mid.z"), last(&series, "end.z")]
    });
    let [own, small] = heights;
    assert!((own[0] - small[0]).abs() < 1e-3 && (own[1] - small[1]).abs() < 2e-3, "{heights:?}");
    assert!(own[0] > 0.2, "{own:?}");
}

/// Joints that contradict each other after the start end the run with a message, not with steps of rounding size.
#[test]
fn smallest_step_ends_the_run() {
    for duration in [0.1194, 0.3, 0.7, 1.1] {
        let text = format!(
            r#"
            bodies = [{{ kind = "rigid", name = "b", center = [0.2, 0, 0], mass = 1, inertia = [1, 1, 1] }}]
            joints = [
              {{ kind = "clamp", name = "j", a = {{ body = "b", at = "center" }} }},
              {{ kind = "distance", name = "d", a = {{ body = "b", at = "center" }}, b = {{ point = [0.6, 0.1, 0.3] }}, change = 0.1, time = {{ kind = "expression", text = "t^2" }} }},
            ]
            analysis = {{ kind = "dynamics", duration = {duration}, step = {{ tolerance = 1e-3 }}, scheme = {{ spectral_radius = 0.8 }} }}
            "#
        );
        let summary = simulate(&Model::parse(&text).unwrap(), &mut Series::new()).unwrap();
        let Outcome::Failed { reason, .. } = &summary.outcome else { panic!("{:?}", summary.outcome) };
        assert!(reason.contains("contradict"), "{reason}");
    }
}
