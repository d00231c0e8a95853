//! Loads per length and the acceleration of the ground: closed forms, and what must equal what.

use std::f64::consts::PI;

use crate::common::solutions::{Run, distance};
use ancf::Model;
use ancf::model::ScaleChoice;
use nalgebra::Vector3;

/// Young's modulus and diameter of the rod, one metre long: E I and ρ A follow.
const YOUNG: f64 = 2.1e11;
const DIAMETER: f64 = 0.02;
const LINE_DENSITY: f64 = 7850.0 * PI * DIAMETER * DIAMETER / 4.0;
const BENDING: f64 = YOUNG * PI * DIAMETER * DIAMETER * DIAMETER * DIAMETER / 64.0;
/// 1/(k G A) times E I/L², the share of shear in a deflection: k of a full circle with ν = 0 is 6/7.
const SHEAR: f64 = BENDING / (6.0 / 7.0 * 0.5 * YOUNG * PI * DIAMETER * DIAMETER / 4.0);

const STATICS: &str = "kind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-12 }";

/// A rod along x clamped at the origin.
fn rod(body: &str, loads: &str, analysis: &str) -> Model {
    let text = format!(
        "{loads}
        materials.steel = {{ density = 7850, young = {YOUNG:e} }}
        sections.round = {{ kind = \"circle\", diameter = {DIAMETER} }}
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"rod\", at = \"start\" }} }}]
        probes = [{{ name = \"tip\", on = {{ body = \"rod\", at = \"end\" }} }}]
        [[bodies]]
        {body}
        name = \"rod\"
        from = [0, 0, 0]
        to = [1, 0, 0]
        section = \"round\"
        material = \"steel\"
        [analysis]
        {analysis}"
    );
    Model::parse(&text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"))
}

const BODIES: [&str; 5] = [
    "kind = \"beam\"\nformulation = \"continuum\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"enhanced\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"linked\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"quadratic\"\nelements = 5",
    "kind = \"cable\"\nelements = 5",
];
const LINKED: &str = BODIES[2];

/// How far the tip has moved in the end.
fn moved(model: &Model) -> Vector3<f64> {
    *Run::of(model).vectors("tip.").last().unwrap() - Vector3::x()
}

fn root(model: &Model) -> [Vector3<f64>; 2] {
    let run = Run::of(model);
    ["root.f", "root.m"].map(|name| *run.vectors(name).last().unwrap())
}

#[track_caller]
fn assert_near(what: &str, found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{what}: {found:e}, not {wanted:e}");
}

/// ρ A g along a body is its weight, and the ground that accelerates upwards pulls as gravity does.
#[test]
fn weight_in_three_ways() {
    let weight = format!(
        "loads = [{{ kind = \"distributed_force\", body = \"rod\", force = [0, {:e}, 0] }}]",
        -LINE_DENSITY * 50.0
    );
    let gravity = "gravity = [0, -50, 0]";
    let base = "loads = [{ kind = \"base_acceleration\", acceleration = [0, 50, 0] }]";
    let dynamics =
        "kind = \"dynamics\"\nduration = 0.02\nstep = 1e-3\nscheme = \"average_acceleration\"".to_owned();
    for body in BODIES {
        for analysis in [STATICS, &dynamics] {
            let [a, b, c] =
                [gravity, &weight, base].map(|loads| Run::of(&rod(body, loads, analysis)).vectors("tip."));
            let size = (a.last().unwrap() - Vector3::x()).norm();
            assert!(size > 1e-3, "{body}: moved by {size:e}");
            assert!(distance(&a, &b) < 1e-9 * size, "{body}: {:e}", distance(&a, &b));
            assert!(distance(&a, &c) < 1e-9 * size, "{body}: {:e}", distance(&a, &c));
        }
    }
}

/// Deflections of a slender cantilever under little load, by Euler and Bernoulli with Timoshenko's shear:
/// q L⁴/8EI + q L²/2kGA; 11/120 and 1/3 for a load that grows from the root, 1/30 and 1/6 for one that falls.
#[test]
fn deflections_of_a_cantilever() {
    let cases = [
        ("force = [0, 1, 0]", 1.0 / 8.0, 1.0 / 2.0),
        ("force = [0, 0, 0], force_end = [0, 1, 0]", 11.0 / 120.0, 1.0 / 3.0),
        ("force = [0, 1, 0], force_end = [0, 0, 0]", 1.0 / 30.0, 1.0 / 6.0),
        ("force = [0, 1, 0], follower = true", 1.0 / 8.0, 1.0 / 2.0),
    ];
    let body = LINKED.replace("= 5", "= 64");
    for (force, bent, sheared) in cases {
        let loads = format!("loads = [{{ kind = \"distributed_force\", body = \"rod\", {force} }}]");
        let exact = (bent + sheared * SHEAR) / BENDING;
        assert_near(force, moved(&rod(&body, &loads, STATICS)).y, exact, 1e-6);
    }
    // A moment per length m about z bends by m L³/3EI, as the force m at the tip; sections turn linearly between nodes, so that
    // 64 of them have an error of 1/4n².
    let loads = "loads = [{ kind = \"distributed_moment\", body = \"rod\", moment = [0, 0, 1] }]";
    assert_near(
        "moment",
        moved(&rod(&body, loads, STATICS)).y,
        1.0 / (3.0 * BENDING),
        1.0 / (3.0 * 64.0 * 64.0),
    );
}

/// A torque per length: the moment about the normal that the section turns with. G J θ = m L²/2, or m L²/6 if it falls to zero.
#[test]
fn torque() {
    let twist = |moment: &str| {
        let loads = format!("loads = [{{ kind = \"distributed_moment\", body = \"rod\", {moment} }}]");
        let mut model = rod(LINKED, &loads, STATICS);
        model.probes[0].offset = [0.01, 0.0];
        let turned = *Run::of(&model).vectors("tip.").last().unwrap();
        turned.z.atan2(turned.y)
    };
    let rigidity = 0.5 * YOUNG * PI * DIAMETER.powi(4) / 32.0;
    for follower in [false, true] {
        let uniform = twist(&format!("moment = [100, 0, 0], follower = {follower}"));
        assert_near("uniform", uniform, 50.0 / rigidity, 1e-3);
        let falling = twist(&format!("moment = [100, 0, 0], moment_end = [0, 0, 0], follower = {follower}"));
        assert_near("falling", falling, 100.0 / 6.0 / rigidity, 1e-3);
    }
}

/// Loads on a part that no node bounds: the root carries their resultants.
#[test]
fn resultants_of_a_part() {
    let (a, b): (f64, f64) = (0.13, 0.77);
    for body in BODIES {
        for follower in [false, true].into_iter().filter(|follower| !(*follower && body.contains("cable"))) {
            let loads = format!(
                "loads = [{{ kind = \"distributed_force\", body = \"rod\", from = {a}, to = {b}, \
                 force = [0, 1e-3, 0], force_end = [0, 4e-3, 5e-4], follower = {follower} }}]"
            );
            let [force, moment] = root(&rod(body, &loads, STATICS)).map(|x| x * 1e3);
            let length = b - a;
            let exact = -Vector3::new(0.0, 1.0 + 4.0, 0.5) * (0.5 * length);
            assert!((force - exact).norm() < 1e-5 * exact.norm(), "{body}: {force}");
            // ∫ x q dx of the parts 1 and 3 (x − a)/(b − a), and of 0.5 (x − a)/(b − a).
            let growing = length * (a / 2.0 + length / 3.0);
            let exact = Vector3::new(0.0, 0.5 * growing, -(0.5 * (b * b - a * a) + 3.0 * growing));
            let moment = if body.contains("cable") { exact } else { moment };
            assert!((moment - exact).norm() < 1e-5 * exact.norm(), "{body}: {moment}, not {exact}");
        }
    }
}

/// Pressure p on a curve pushes as on its chord c: p |c| across the chord, with the moment p |c|²/2 about its start.
/// Here it bends a rod by more than a radian, almost without stretch.
#[test]
fn pressure_on_a_curve() {
    let pressure = 8.0 * BENDING;
    let loads = format!(
        "loads = [{{ kind = \"distributed_force\", body = \"rod\", force = [0, {pressure:e}, 0], follower = true }}]"
    );
    let model = rod(&LINKED.replace("= 5", "= 16"), &loads, STATICS);
    let run = Run::of(&model);
    let last = |name: &str| *run.vectors(name).last().unwrap();
    let (tip, force, moment) = (last("tip."), last("root.f"), last("root.m"));
    assert!(tip.x < 0.7, "a tip at {tip}");
    let across = Vector3::z().cross(&tip) * pressure;
    assert!((force + across).norm() < 2e-3 * across.norm(), "{force} and {across}");
    assert_near("moment", -moment.z, 0.5 * pressure * tip.norm_squared(), 2e-3);
}

/// A free body in a frame that accelerates stays behind: x = −∬ a f dt².
#[test]
fn base_acceleration_of_a_free_body() {
    let dynamics = "kind = \"dynamics\"\nduration = 0.5\nstep = 1e-3\nscheme = \"average_acceleration\"";
    let loads = "loads = [{ kind = \"base_acceleration\", acceleration = [1, 2, -3], \
                 time = { kind = \"sine\", frequency = 1, phase = 0 } }]";
    for body in BODIES {
        let mut model = rod(body, loads, dynamics);
        model.joints.clear();
        let omega = 2.0 * PI;
        // −∬ sin ωt = sin ωt/ω² − t/ω, at half a period.
        let exact = Vector3::new(1.0, 2.0, -3.0) * (-0.5 / omega);
        let run = Run::of(&model);
        let found = *run.vectors("tip.").last().unwrap() - Vector3::x();
        assert!((found - exact).norm() < 1e-5 * exact.norm(), "{body}: {found}, not {exact}");
        let balance = run.column("balance").last().unwrap().abs();
        let work = run.column("work").last().unwrap().abs();
        assert!(balance < 1e-4 * work, "{body}: a balance of {balance:e} to a work of {work:e}");
    }
}

/// A column under a uniform load along its axis buckles at q L³/EI = 7.8373 (Timoshenko & Gere 1961).
#[test]
fn a_column_under_its_weight() {
    let loads = "loads = [{ kind = \"distributed_force\", body = \"rod\", force = [-1, 0, 0] }]";
    let run = Run::of(&rod(&LINKED.replace("= 5", "= 32"), loads, "kind = \"buckling\""));
    assert_near("critical load", run.column("factor")[0], 7.8373 * BENDING, 1e-3);
}

/// The work of followers and of loads that vary: the books close, to the second order of the step.
#[test]
fn books() {
    let loads = format!(
        "loads = [
            {{ kind = \"distributed_force\", body = \"rod\", from = 0.4, force = [0, {0:e}, {0:e}], follower = true,
               time = {{ kind = \"sine\", frequency = 3, phase = 0 }} }},
            {{ kind = \"distributed_moment\", body = \"rod\", moment = [0, {0:e}, 0], moment_end = [0, 0, 0],
               time = {{ kind = \"sine\", frequency = 2, phase = 1 }} }},
        ]",
        2.0 * BENDING
    );
    let balance = |step: f64| {
        let dynamics = format!(
            "kind = \"dynamics\"\nduration = 0.1\nstep = {step:e}\nscheme = {{ spectral_radius = 1.0 }}"
        );
        let model = rod(&LINKED.replace("= 5", "= 2"), &loads, &dynamics);
        let run = Run::of(&model);
        let largest = |name: &str| run.column(name).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        largest("balance") / largest("work")
    };
    let [coarse, fine] = [1e-4, 5e-5].map(balance);
    assert!(fine < 1e-2, "a balance of {fine:e}");
    assert!((3.0..5.5).contains(&(coarse / fine)), "{coarse:e}, {fine:e}");
}

/// The equations may be solved in any units: every column is the same but for norms in the numbers of the solver.
#[test]
fn units() {
    let dynamics = "kind = \"dynamics\"\nduration = 0.05\nstep = 1e-3\nscheme = { spectral_radius = 0.8 }";
    let sine = "time = { kind = \"sine\", frequency = 3, phase = 0.2 }";
    let loads = [
        format!(
            "{{ kind = \"distributed_force\", body = \"rod\", from = 0.21, to = 0.9, force = [0, 300, 500],
               force_end = [100, 200, -300], follower = true, {sine} }},
             {{ kind = \"distributed_force\", body = \"rod\", to = 0.77, force = [0, 300, 500] }},
             {{ kind = \"distributed_moment\", body = \"rod\", to = 0.77, moment = [3, 2, 1], moment_end = [0, 0, 1] }}"
        ),
        format!("{{ kind = \"base_acceleration\", acceleration = [3, 0, 7], {sine} }}"),
        format!(
            "{{ kind = \"fluid\", bodies = [\"rod\"], density = 1000, current = [1, 0.5, 2], area = 4e-4, diameter = 0.03,
               drag = [1.2, 0.05], added_mass = [0.9, 0.1], {sine} }}"
        ),
    ];
    for load in loads {
        let model = rod(LINKED, &format!("gravity = [0, 2, 3]\nloads = [{load}]"), dynamics);
        let given = ScaleChoice::Given { length: 0.037, force: 2.9e5, time: Some(13.0) };
        let [a, b] = [ScaleChoice::None, given].map(|scales| Run::of(&Model { scales, ..model.clone() }));
        for (name, a) in a.columns().filter(|(name, _)| !["residual", "increment", "drift"].contains(name)) {
            let size = a.iter().fold(1e-3, |size: f64, x| size.max(x.abs()));
            let apart = a.iter().zip(b.column(name)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-7 * size, "{name}: {apart:e} of {size:e}, {load}");
        }
    }
}
