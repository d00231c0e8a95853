//! Friction of ball joints, crosses, sleeves, lines and planes.

use ancf::record::Series;
use ancf::{Model, Simulation};

use crate::common::models::parse;
use crate::runs::given_states::States;

const MU: f64 = 0.2;
const MASS: f64 = 5.0;
const INERTIA: f64 = 0.1;
const WEIGHT: f64 = MASS * 9.81;

/// Units of the equations.
const SCALES: [&str; 2] = ["", "scales = { kind = \"given\", length = 0.03, force = 7, time = 0.2 }\n"];

fn run(text: &str) -> Series {
    let mut states = States::default();
    let summary = Simulation::new(&parse(text)).unwrap().run(&mut states).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    states.series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// Body of equal moments of inertia at a joint, under its weight along −z.
fn body(motion: &str, joint: &str) -> String {
    format!(
        "gravity = [0, 0, -9.81]\n\
         bodies = [{{ kind = \"rigid\", name = \"w\", center = [0, 0, 0], mass = {MASS}, inertia = [{INERTIA}, {INERTIA}, {INERTIA}], motion = {{ {motion} }} }}]\n\
         joints = [{{ name = \"j\", a = {{ body = \"w\", at = \"center\" }}, {joint} }}]\n\
         analysis = {{ kind = \"dynamics\", duration = 0.4, step = 1e-3, scheme = {{ spectral_radius = 0.8 }} }}\n"
    )
}

/// Motion in own units and in others, which agree.
fn moved(text: &str) -> Series {
    let [own, other] = SCALES.map(|scales| run(&format!("{scales}{text}")));
    for column in ["kinetic", "dissipated"] {
        let [a, b] = [&own, &other].map(|series| last(series, column));
        assert!((a - b).abs() < 1e-8 * (1.0 + a.abs()), "{column}: {a} and {b}");
    }
    assert!(
        last(&own, "balance").abs() < 1e-3 * (1.0 + last(&own, "dissipated")),
        "{}",
        last(&own, "balance")
    );
    own
}

/// Angular velocity of the body by its kinetic energy.
fn spin(series: &Series) -> f64 {
    (2.0 * last(series, "kinetic") / INERTIA).sqrt()
}

/// A ball of radius r slows a spin about any axis down by the moment M + μ r m g.
#[test]
fn balls_slow_spins_down() {
    for spin_at_start in ["[0, 0, 13]", "[3, 4, 12]", "[-12, 3, 4]"] {
        let friction = |keys: &str| {
            let joint = format!("kind = \"spherical\", friction = {{ rate = 1e-4, {keys} }}");
            13.0 - spin(&moved(&body(&format!("spin = {spin_at_start}"), &joint)))
        };
        let unit = MU * 0.03 * WEIGHT / INERTIA * 0.4;
        let found = friction(&format!("coefficient = {MU}, radius = 0.03"));
        assert!((found - unit).abs() < 1e-3 * unit, "{spin_at_start}: {found} and {unit}");
        let sealed = friction(&format!("coefficient = {MU}, radius = 0.03, moment = 0.05"));
        let expected = unit + 0.05 / INERTIA * 0.4;
        assert!((sealed - expected).abs() < 1e-3 * expected, "{spin_at_start}: {sealed} and {expected}");
        let constant = friction("moment = 0.05");
        assert!((constant - (expected - unit)).abs() < 1e-3 * expected, "{spin_at_start}: {constant}");
    }
}

/// A pendulum at rest to one side stays there if the friction of its ball exceeds the moment of the weight.
#[test]
fn balls_hold_pendulums() {
    let held = |coefficient: f64| {
        let text = body("", &format!("kind = \"spherical\", friction = {{ coefficient = {coefficient}, radius = 0.05, rate = 1e-6 }}"))
            .replace("at = \"center\" }", "at = [0.01, 0, 0] }");
        last(
            &run(&format!("probes = [{{ name = \"c\", on = {{ body = \"w\", at = \"center\" }} }}]\n{text}")),
            "c.z",
        )
    };
    // The lever arm is 0.01, and that of the friction μ 0.05.
    // In the first step, before friction acts, it falls by about g h².
    assert!(held(0.25).abs() < 1e-7, "{}", held(0.25));
    // The rest of the moment accelerates it.
    let fall = -0.01 * (0.5 * 0.16 * (0.01 - 0.15 * 0.05) * WEIGHT / (INERTIA + MASS * 1e-4));
    assert!((held(0.15) / fall - 1.0).abs() < 0.02, "{} and {fall}", held(0.15));
}

/// Each arm of a cross has the friction of its own pins: μ r times the force across it, or 2 M/L of the moment on two bearings.
#[test]
fn arms_of_a_cross_have_own_friction() {
    let unit = MU * 0.03 * WEIGHT / INERTIA * 0.4;
    for (arms, spin_at_start, expected) in [
        // The weight is across both arms.
        ("axis_a = [1, 0, 0], axis_b = [0, 1, 0]", "[9, 0, 0]", unit),
        ("axis_a = [1, 0, 0], axis_b = [0, 1, 0]", "[0, 9, 0]", unit),
        // The weight is along the arm.
        ("axis_a = [0, 0, 1], axis_b = [0, 1, 0]", "[0, 0, 9]", 0.0),
        ("axis_a = [0, 1, 0], axis_b = [0, 0, 1]", "[0, 0, 9]", 0.0),
        ("axis_a = [0, 0, 1], axis_b = [1, 0, 0]", "[0, 0, 9]", 0.0),
    ] {
        let joint = format!(
            "kind = \"universal\", {arms}, friction = {{ coefficient = {MU}, radius = 0.03, rate = 1e-4 }}"
        );
        let found = 9.0 - spin(&moved(&body(&format!("spin = {spin_at_start}"), &joint)));
        assert!((found - expected).abs() < 1e-3 * unit, "{arms}, {spin_at_start}: {found} and {expected}");
    }
    // A weight at 0.4 along the arm of the body, about which nothing turns: the moment m g 0.4 is carried by two bearings.
    let joint = format!(
        "kind = \"universal\", axis_a = [1, 0, 0], axis_b = [0, 0, 1], friction = {{ coefficient = {MU}, radius = 0.03, span = 0.1, rate = 1e-4 }}"
    );
    let text = body("spin = [20, 0, 0]", &joint).replace("at = \"center\" }", "at = [-0.4, 0, 0] }");
    let found = 20.0 - spin(&run(&text));
    let expected = unit * (2.0 * 0.4 / 0.1);
    assert!((found - expected).abs() < 2e-3 * expected, "{found} and {expected}");
}

/// The friction of a cross with skew arms dissipates M(|α| + |α′|), with the rates of both arms.
#[test]
fn skew_arms_dissipate_by_their_rates() {
    let drive = "kind = \"universal\", axis_a = [0.8, 0.6, 0], axis_b = [1, 0, 0], friction = { moment = 0.05, rate = 1e-3 }";
    // ω = 5 e − 2 e′.
    let series = moved(&body("spin = [2, 3, 0]", drive).replace("duration = 0.4", "duration = 1e-3"));
    let power = last(&series, "dissipated") / 1e-3;
    assert!((power - 0.05 * 7.0).abs() < 1e-2 * 0.35, "{power}");
}

/// A shaft of radius r with the axial moment of inertia m r² keeps the direction of its slip: |s| decreases by μ g t.
#[test]
fn shafts_turn_and_slide_in_one_friction() {
    let radius = (INERTIA / MASS).sqrt();
    for [speed, rim] in [[3.0, 4.0], [5.0, 0.0], [0.0, 5.0], [-4.0, 3.0]] {
        let motion = format!("velocity = [{speed}, 0, 0], spin = [{}, 0, 0]", rim / radius);
        let joint = format!(
            "kind = \"cylindrical\", axis = [1, 0, 0], friction = {{ coefficient = {MU}, radius = {radius}, speed = 1e-4 }}"
        );
        let series = moved(&body(&motion, &joint));
        let ratio = 1.0 - MU * 9.81 * 0.4 / 5.0;
        let found = [last(&series, "j.speed"), last(&series, "j.rate") * radius];
        for (found, start) in found.into_iter().zip([speed, rim]) {
            assert!((found - start * ratio).abs() < 5e-3, "{speed}, {rim}: {found} and {}", start * ratio);
        }
    }
    // A turning shaft does not hold a force along it: it creeps with the direction of the slip.
    let motion = format!("spin = [{}, 0, 0]", 5.0 / radius);
    let joint = format!(
        "kind = \"cylindrical\", axis = [1, 0, 0], drive = {{ rate = {} }}, force = {{ kind = \"expression\", text = \"1\" }}, friction = {{ force = 20, radius = {radius}, speed = 1e-4 }}",
        5.0 / radius
    );
    let series = moved(&body(&motion, &joint).replace("duration = 0.4", "duration = 16"));
    // F v/√(v² + (rω)²) = 1.
    let expected = 5.0 / (400.0_f64 - 1.0).sqrt();
    assert!((last(&series, "j.speed") - expected).abs() < 1e-3 * expected, "{}", last(&series, "j.speed"));
}

/// A puck on a plane and a bead on a wire have the accelerations of Coulomb's friction.
#[test]
fn pucks_and_beads_slide() {
    let probe = "probes = [{ name = \"c\", on = { body = \"w\", at = \"center\" } }]\n";
    let friction = format!("friction = {{ coefficient = {MU}, speed = 1e-4 }}");
    let puck = body("velocity = [3, 4, 0]", &format!("kind = \"planar\", normal = [0, 0, 1], {friction}"));
    let series = moved(&format!("{probe}{puck}"));
    let ratio = 1.0 - MU * 9.81 * 0.4 / 5.0;
    for (column, start) in [("c.vx", 3.0), ("c.vy", 4.0)] {
        let found = last(&series, column);
        assert!((found - start * ratio).abs() < 1e-5, "{column}: {found}");
    }
    let bead = body(
        "velocity = [0.8, 0, -0.6]",
        &format!("kind = \"point_on_line\", axis = [0.8, 0, -0.6], {friction}"),
    );
    let expected = 1.0 + 0.4 * 9.81 * (0.6 - MU * 0.8);
    let found = last(&moved(&bead), "j.speed");
    assert!((found - expected).abs() < 1e-5, "{found} and {expected}");
}

/// Friction of a ball between two beams: the moment on the end of the second one bends it, and the energy is balanced.
#[test]
fn balls_between_beams_balance_the_energy() {
    for scheme in ["{ spectral_radius = 0.8 }", "\"energy\""] {
        let series = run(&format!(
            "gravity = [0, 0, -9.81]\n\
             materials.m = {{ density = 1000, young = 1e8, damping = {{ strain = 1e-3 }} }}\nsections.s = {{ kind = \"circle\", diameter = 0.05 }}\n\
             bodies = [{{ kind = \"beam\", name = \"a\", from = [0, 0, 0], to = [0.5, 0, 0], elements = 2, section = \"s\", material = \"m\" }},\n\
             {{ kind = \"beam\", name = \"b\", from = [0.5, 0, 0], to = [1, 0.2, 0], elements = 2, section = \"s\", material = \"m\" }}]\n\
             joints = [{{ kind = \"clamp\", name = \"c\", a = {{ body = \"a\", at = \"start\" }} }},\n\
             {{ kind = \"spherical\", name = \"j\", a = {{ body = \"b\", at = \"start\" }}, b = {{ body = \"a\", at = \"end\" }}, friction = {{ coefficient = 0.3, radius = 0.1, rate = 0.1, moment = 0.1 }} }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.6, step = 1e-3, scheme = {scheme} }}\n"
        ));
        let (dissipated, balance) = (last(&series, "dissipated"), last(&series, "balance"));
        assert!(
            dissipated > 0.05 && balance.abs() < 2e-3 * dissipated,
            "{scheme}: {dissipated} and {balance}"
        );
    }
}

/// Two pins on one axis share the reaction in a way that the constraints do not determine: a warning of the run and of its check.
#[test]
fn undetermined_friction_is_reported() {
    let pin = |name: &str, z: f64, friction: &str| {
        format!(
            "{{ kind = \"revolute\", name = \"{name}\", a = {{ body = \"w\", at = [0, 0, {z}] }}, axis = [0, 0, 1], {friction} }}"
        )
    };
    let door = |friction: &str, second: &str| {
        format!(
            "gravity = [0, 0, -9.81]\n\
             bodies = [{{ kind = \"rigid\", name = \"w\", center = [0.5, 0, 0], mass = {MASS}, inertia = [1, 1, 1] }}]\n\
             joints = [{}{second}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.01, step = 1e-3 }}\n",
            pin("low", -0.5, friction)
        )
    };
    let by_reaction = "friction = { coefficient = 0.1, radius = 0.01, rate = 1e-3 }";
    let other = format!(", {}", pin("high", 0.5, "spring = { stiffness = 1 }"));
    let warnings = |text: &str| {
        let model = parse(text);
        let summary = Simulation::new(&model).unwrap().run(&mut States::default()).unwrap();
        let of = |warnings: &[String]| warnings.iter().filter(|text| text.contains("`low`")).count();
        [
            of(&summary.warnings),
            model.diagnose().unwrap().warnings.iter().filter(|w| w.contains("friction")).count(),
        ]
    };
    assert_eq!(warnings(&door(by_reaction, &other)), [1, 1]);
    assert_eq!(warnings(&door(by_reaction, "")), [0, 0]);
    assert_eq!(warnings(&door("friction = { moment = 1, rate = 1e-3 }", &other)), [0, 0]);
}

#[test]
fn errors_of_friction_have_their_places() {
    let message = |joint: &str| Model::parse(&body("", joint)).unwrap_err().to_string();
    for (joint, expected) in [
        (
            "kind = \"spherical\", friction = { coefficient = 0.1, rate = 1 }",
            "joints[0].friction.radius: found no radius",
        ),
        (
            "kind = \"spherical\", friction = { moment = 1, rate = 1, span = 0.1 }",
            "joints[0].friction.span: found 0.1",
        ),
        (
            "kind = \"universal\", axis_a = [1, 0, 0], axis_b = [0, 1, 0], friction = { moment = 1, rate = 1, collar = 0.1 }",
            "joints[0].friction.collar: found 0.1",
        ),
        (
            "kind = \"planar\", normal = [1, 0, 0], friction = { force = 1, speed = 1, radius = 0.1 }",
            "joints[0].friction.radius: found 0.1",
        ),
        (
            "kind = \"prismatic\", axis = [1, 0, 0], friction = { force = 1, speed = 1, radius = 0.1 }",
            "joints[0].friction.radius: found 0.1",
        ),
        (
            "kind = \"cylindrical\", axis = [1, 0, 0], friction = { force = 1, speed = 1 }",
            "joints[0].friction.radius: found no radius",
        ),
    ] {
        let found = message(joint);
        assert!(found.contains(expected), "{joint}: {found}");
    }
    // One error for one missing key.
    let sleeve =
        message("kind = \"cylindrical\", axis = [1, 0, 0], friction = { coefficient = 0.1, speed = 1 }");
    assert_eq!(sleeve.lines().count(), 1, "{sleeve}");
    let mass = body("", "kind = \"spherical\", friction = { moment = 1, rate = 1 }")
        .replace("kind = \"rigid\"", "kind = \"mass\"")
        .replace(", inertia = [0.1, 0.1, 0.1]", "");
    let found = Model::parse(&mass).unwrap_err().to_string();
    assert!(found.contains("a ball joint with friction"), "{found}");
    let still = body("", "kind = \"spherical\", friction = { moment = 1, rate = 1 }").replace(
        "kind = \"dynamics\", duration = 0.4, step = 1e-3, scheme = { spectral_radius = 0.8 }",
        "kind = \"statics\"",
    );
    let found = Model::parse(&still).unwrap_err().to_string();
    assert!(found.contains("1 in statics, which has no motion"), "{found}");
}
