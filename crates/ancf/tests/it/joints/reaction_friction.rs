//! Friction of joints in proportion to their reactions, and Stribeck friction.

use ancf::record::Series;
use ancf::{Model, Simulation, Stepper};

use crate::common::models::parse;
use crate::runs::given_states::States;

const MU: f64 = 0.2;

fn run_model(model: &Model) -> Series {
    let mut states = States::default();
    let summary = Simulation::new(model).unwrap().run(&mut states).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    states.series
}

fn run(text: &str) -> Series {
    run_model(&parse(text))
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap().last().unwrap()
}

/// Block of mass 2 on a guide that is inclined by an angle.
fn block(angle: f64, friction: &str, speed: f64, more: &str) -> String {
    let [c, s] = [angle.cos(), angle.sin()];
    format!(
        "gravity = [0, -9.81, 0]\n\
         bodies = [{{ kind = \"rigid\", name = \"b\", center = [0, 0, 0], mass = 2, inertia = [0.1, 0.1, 0.1], motion = {{ velocity = [{}, {}, 0] }} }}]\n\
         joints = [{{ kind = \"prismatic\", name = \"g\", a = {{ body = \"b\", at = \"center\" }}, axis = [{c}, {s}, 0], friction = {{ {friction} }} }}]\n\
         analysis = {{ kind = \"dynamics\", duration = 0.5, step = 1e-3, scheme = {{ spectral_radius = 0.8 }} }}\n{more}",
        speed * c,
        speed * s
    )
}

/// A block that slides down an inclined guide has the acceleration g (sin α − μ cos α). Below the angle of friction it sticks, but
/// for a creep of at most the regularisation.
#[test]
fn blocks_slide_and_stick_on_inclined_guides() {
    let friction = format!("coefficient = {MU}, speed = 1e-5");
    for angle in [0.0_f64, 0.5, 1.2] {
        let series = run(&block(-angle, &friction, 3.0, ""));
        let acceleration = 9.81 * (angle.sin() - MU * angle.cos());
        let speed = last(&series, "g.speed");
        assert!((speed - 3.0 - 0.5 * acceleration).abs() < 1e-6, "{angle}: {speed}");
        let dissipated = MU * 2.0 * 9.81 * angle.cos() * last(&series, "g.displacement");
        assert!((last(&series, "dissipated") - dissipated).abs() < 1e-4 * (1.0 + dissipated));
        assert!(last(&series, "balance").abs() < 1e-4);
    }
    // tan 0.15 < μ.
    let series = run(&block(-0.15, &friction, 0.0, ""));
    let creep = 1e-5 * (0.15_f64.tan() / MU).atanh();
    let at = |i: usize| series.column("g.displacement").unwrap()[i];
    let rate = (at(500) - at(250)) / 0.25;
    assert!((rate - creep).abs() < 0.01 * creep, "{rate:e} and {creep:e}");
    assert!(at(500) < 1e-5);
}

/// The friction of a load at an arm: two shoes at a distance carry m g each side by the lever rule.
#[test]
fn shoes_carry_moments() {
    // The weight acts at 0.3 along the guide, between neither shoe: N = m g 2 e/L for e > L/2.
    let text = |span: &str| {
        block(0.0, &format!("coefficient = {MU}, speed = 1e-6{span}"), 4.0, "")
            .replace("at = \"center\" }, axis", "at = [-0.3, 0, 0] }, axis")
    };
    let slowed = |span: &str| 4.0 - last(&run(&text(span)), "g.speed");
    // The moment about the point of the joint contains that of the friction force, which passes through it: none.
    let expected = |normal: f64| MU * normal * 9.81 * 0.5;
    assert!((slowed("") - expected(1.0)).abs() < 1e-6, "{}", slowed(""));
    // The inertia force m a of the deceleration acts at the height of the joint: no moment.
    assert!((slowed(", span = 0.2") - expected(0.6 / 0.2)).abs() < 1e-5, "{}", slowed(", span = 0.2"));
    assert!((slowed(", span = 2") - expected(1.0)).abs() < 1e-6, "{}", slowed(", span = 2"));
}

/// A wheel on a pin of radius r slows down by the moment μ r m g; a collar and the distance of bearings add their parts.
#[test]
fn pins_slow_wheels_down() {
    let wheel = |axis: &str, spin: &str, center: &str, friction: &str, scales: &str| {
        format!(
            "{scales}gravity = [0, -9.81, 0]\n\
             bodies = [{{ kind = \"rigid\", name = \"w\", center = {center}, mass = 5, inertia = [0.1, 0.1, 0.1], motion = {{ spin = {spin} }} }}]\n\
             joints = [{{ kind = \"revolute\", name = \"pin\", a = {{ body = \"w\", at = [0, 0, 0] }}, axis = {axis}, friction = {{ coefficient = {MU}, rate = 1e-4, {friction} }} }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.5, step = 1e-3, scheme = {{ spectral_radius = 0.8 }} }}\n"
        )
    };
    let slowed = |axis: &str, spin: &str, center: &str, friction: &str| {
        let [own, scaled] = ["", "scales = { kind = \"given\", length = 0.03, force = 7, time = 0.2 }\n"]
            .map(|scales| 20.0 - last(&run(&wheel(axis, spin, center, friction, scales)), "pin.rate"));
        assert!((own - scaled).abs() < 1e-9, "{own} and {scaled}");
        own
    };
    let z = |friction: &str| slowed("[0, 0, 1]", "[0, 0, 20]", "[0, 0, 0]", friction);
    let unit = MU * 0.02 * 5.0 * 9.81 / 0.1 * 0.5;
    // The rates of a turning body have an error of the order of (ω h)².
    let error = 1e-3 * unit;
    assert!((z("radius = 0.02") - unit).abs() < error, "{} and {unit}", z("radius = 0.02"));
    let with_seal = z("radius = 0.02, moment = 0.05");
    assert!((with_seal - unit - 0.05 / 0.1 * 0.5).abs() < error, "{with_seal}");
    // The weight at 0.5 beside the bearings, which are 0.1 apart: N = m g 2 · 0.5/0.1.
    let beside = slowed("[0, 0, 1]", "[0, 0, 20]", "[0, 0, 0.5]", "radius = 0.02, span = 0.1");
    assert!((beside - 10.0 * unit).abs() < 10.0 * error, "{beside} and {unit}");
    // A vertical axis: the collar carries the weight.
    let vertical = |friction: &str| slowed("[0, 1, 0]", "[0, 20, 0]", "[0, 0, 0]", friction);
    assert!(vertical("radius = 0.02").abs() < error);
    let on_collar = vertical("radius = 0.02, collar = 0.06");
    assert!((on_collar - 3.0 * unit).abs() < 3.0 * error, "{on_collar}");
}

/// A pendulum whose pin has friction: the normal force contains the centrifugal force, and an integration of the equation of motion
/// agrees. The error is of second order.
#[test]
fn pendulum_with_friction_agrees_with_its_equation() {
    let (m, d, j, r, g) = (3.0, 0.8, 0.5, 0.1, 9.81);
    let creep = 0.05;
    let text = |step: f64| {
        format!(
            "gravity = [0, -9.81, 0]\n\
             bodies = [{{ kind = \"rigid\", name = \"p\", center = [{d}, 0, 0], mass = {m}, inertia = [{j}, {j}, {j}] }}]\n\
             joints = [{{ kind = \"revolute\", name = \"pin\", a = {{ body = \"p\", at = [0, 0, 0] }}, axis = [0, 0, 1], friction = {{ coefficient = 0.4, radius = {r}, rate = {creep} }} }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 2, step = {step}, scheme = {{ spectral_radius = 0.8 }} }}\n"
        )
    };
    // N by the angular acceleration itself: fixed-point iteration.
    let acceleration = |theta: f64, omega: f64| {
        let mut alpha = 0.0;
        for _ in 0..60 {
            let along = m * d * omega * omega + m * g * -theta.sin();
            let across = m * d * alpha + m * g * theta.cos();
            let friction = 0.4 * r * (along * along + across * across).sqrt() * (omega / creep).tanh();
            alpha = (-m * g * d * theta.cos() - friction) / (j + m * d * d);
        }
        alpha
    };
    let (mut theta, mut omega, n) = (0.0, 0.0, 20_000);
    let h = 2.0 / f64::from(n);
    for _ in 0..n {
        let k1 = (omega, acceleration(theta, omega));
        let k2 = (omega + 0.5 * h * k1.1, acceleration(theta + 0.5 * h * k1.0, omega + 0.5 * h * k1.1));
        let k3 = (omega + 0.5 * h * k2.1, acceleration(theta + 0.5 * h * k2.0, omega + 0.5 * h * k2.1));
        let k4 = (omega + h * k3.1, acceleration(theta + h * k3.0, omega + h * k3.1));
        theta += h / 6.0 * (k1.0 + 2.0 * k2.0 + 2.0 * k3.0 + k4.0);
        omega += h / 6.0 * (k1.1 + 2.0 * k2.1 + 2.0 * k3.1 + k4.1);
    }
    let error = |step: f64| (last(&run(&text(step)), "pin.angle") - theta).abs();
    let [coarse, fine] = [4e-3, 1e-3].map(error);
    assert!(coarse < 1e-3, "{coarse:e}");
    assert!(fine < coarse / 10.0, "{coarse:e} and {fine:e}");
}

/// A ring on a beam: the friction is μ N with the part of the reaction normal to the beam.
#[test]
fn rings_on_beams_have_friction_by_their_reaction() {
    let text = format!(
        "gravity = [0, -9.81, 0]\n\
         materials.m = {{ density = 1000, young = 2e11 }}\nsections.s = {{ kind = \"circle\", diameter = 0.1 }}\n\
         bodies = [{{ kind = \"beam\", name = \"rail\", from = [0, 0, 0], to = [2, 0, 0], elements = 4, section = \"s\", material = \"m\" }},\n\
         {{ kind = \"mass\", name = \"ring\", center = [0.5, 0, 0], mass = 0.5, motion = {{ velocity = [2, 0, 0] }} }}]\n\
         joints = [{{ kind = \"clamp\", name = \"l\", a = {{ body = \"rail\", at = \"start\" }} }}, {{ kind = \"clamp\", name = \"r\", a = {{ body = \"rail\", at = \"end\" }} }},\n\
         {{ kind = \"slide\", name = \"s\", a = {{ body = \"ring\", at = \"center\" }}, b = {{ body = \"rail\", at = 0.5 }}, friction = {{ coefficient = {MU}, speed = 1e-3 }} }}]\n\
         analysis = {{ kind = \"dynamics\", duration = 0.5, step = 1e-3, scheme = {{ spectral_radius = 0.5 }} }}\n"
    );
    let speed = last(&run(&text), "s.speed");
    assert!((speed - (2.0 - MU * 9.81 * 0.5)).abs() < 2e-3, "{speed}");
}

/// Stribeck friction: a steady drive needs the force μ m g (1 + (p − 1) exp(−(v/d)²)) tanh(v/ε).
#[test]
fn friction_falls_from_its_peak() {
    for speed in [0.02, 0.1, 0.5] {
        let friction = format!("coefficient = {MU}, speed = 0.01, peak = 1.8, decay = 0.15");
        let text = block(0.0, &friction, speed, "")
            .replace("friction =", &format!("drive = {{ speed = {speed} }}, friction ="));
        let series = run(&text);
        let ratio = (speed / 0.01_f64).tanh() * (1.0 + 0.8 * (-(speed / 0.15_f64).powi(2)).exp());
        let force = last(&series, "g.fx");
        assert!((force - 0.0).abs() < 1e-6 || (force - MU * 2.0 * 9.81 * ratio).abs() < 1e-6, "{force}");
        let work = MU * 2.0 * 9.81 * ratio * speed * 0.5;
        assert!((last(&series, "work") - work).abs() < 1e-4 * work, "{} and {work}", last(&series, "work"));
    }
}

#[test]
fn errors_of_friction_have_their_places() {
    let message = |text: &str| Model::parse(text).unwrap_err().to_string();
    let radius = message(
        "bodies = [{ kind = \"rigid\", name = \"w\", center = [0, 0, 0], mass = 5, inertia = [0.1, 0.1, 0.1] }]\n\
         joints = [{ kind = \"revolute\", name = \"pin\", a = { body = \"w\", at = [0, 0, 0] }, axis = [0, 0, 1], friction = { coefficient = 0.1, rate = 1e-4 } }]\n\
         analysis = { kind = \"dynamics\", duration = 0.5, step = 1e-3 }\n",
    );
    assert!(radius.contains("joints[0].friction.radius: found no radius beside a coefficient"), "{radius}");
    let decay = message(&block(0.0, "force = 1, speed = 0.1, peak = 2", 0.0, ""));
    assert!(decay.contains("joints[0].friction.decay: found no decay beside a peak"), "{decay}");
    let still = message(&block(0.0, "coefficient = 0.1, speed = 0.1", 0.0, "").replace(
        "kind = \"dynamics\", duration = 0.5, step = 1e-3, scheme = { spectral_radius = 0.8 }",
        "kind = \"statics\"",
    ));
    assert!(still.contains("0.1 in statics, which has no motion"), "{still}");
    let mut stepper = Stepper::new(&parse(&block(0.0, "coefficient = 0.1, speed = 0.1", 0.0, ""))).unwrap();
    let linear = stepper.linearise(&[]).unwrap_err().to_string();
    assert!(linear.contains("the friction of joint"), "{linear}");
}
