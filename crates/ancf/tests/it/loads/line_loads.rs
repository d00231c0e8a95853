//! Distributed loads and base acceleration against closed forms and equivalent loads.

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::ScaleChoice;
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::{Run, assert_same_columns, distance};

/// Young's modulus of the rod of 1 m.
const YOUNG: f64 = 2.1e11;
const DIAMETER: f64 = 0.02;
const LINE_DENSITY: f64 = 7850.0 * PI * DIAMETER * DIAMETER / 4.0;
const BENDING: f64 = YOUNG * PI * DIAMETER * DIAMETER * DIAMETER * DIAMETER / 64.0;
/// E I/(k G A L²), the shear part of a deflection. k = 6/7 for a circle with ν = 0.
const SHEAR: f64 = BENDING / (6.0 / 7.0 * 0.5 * YOUNG * PI * DIAMETER * DIAMETER / 4.0);

const STATICS: &str = "kind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-12 }";

/// Rod along x, clamped at the origin.
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
    parse(&text)
}

const BODIES: [&str; 5] = [
    "kind = \"beam\"\nformulation = \"continuum\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"enhanced\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"linked\"\nelements = 5",
    "kind = \"beam\"\nformulation = \"quadratic\"\nelements = 5",
    "kind = \"cable\"\nelements = 5",
];
const LINKED: &str = BODIES[2];

/// Final displacement of the tip.
fn tip_displacement(model: &Model) -> Vector3<f64> {
    Run::of(model).last_vector("tip.") - Vector3::x()
}

/// Final force and moment of the clamp.
fn root(model: &Model) -> [Vector3<f64>; 2] {
    let run = Run::of(model);
    ["root.f", "root.m"].map(|name| run.last_vector(name))
}

/// Gravity, the distributed load ρ A g and an upward acceleration of the base have the same effect.
#[test]
fn gravity_equals_line_load_and_base_acceleration() {
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
            assert!(size > 1e-3, "{body}: displacement {size:e}");
            assert!(distance(&a, &b) < 1e-9 * size, "{body}: {:e}", distance(&a, &b));
            assert!(distance(&a, &c) < 1e-9 * size, "{body}: {:e}", distance(&a, &c));
        }
    }
}

/// Small deflections of the Timoshenko cantilever, q L⁴/8EI + q L²/2kGA.
///
/// Factors 11/120 and 1/3 for a load that increases from the root, 1/30 and 1/6 for one that decreases.
#[test]
fn line_loads_have_timoshenko_deflections() {
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
        assert_relative(force, tip_displacement(&rod(&body, &loads, STATICS)).y, exact, 1e-6);
    }
    // A moment m per length about z has the deflection m L³/3EI of a tip force m. Section rotations are linear between
    // nodes: n = 64 elements have an error of 1/4n².
    let loads = "loads = [{ kind = \"distributed_moment\", body = \"rod\", moment = [0, 0, 1] }]";
    assert_relative(
        "moment",
        tip_displacement(&rod(&body, loads, STATICS)).y,
        1.0 / (3.0 * BENDING),
        1.0 / (3.0 * 64.0 * 64.0),
    );
}

/// Twist by a torque per length: G J θ = m L²/2, or m L²/6 if the torque decreases to zero.
#[test]
fn torque_per_length_causes_the_twist_of_st_venant() {
    let twist = |moment: &str| {
        let loads = format!("loads = [{{ kind = \"distributed_moment\", body = \"rod\", {moment} }}]");
        let mut model = rod(LINKED, &loads, STATICS);
        model.probes[0].offset = [0.01, 0.0];
        let tip = Run::of(&model).last_vector("tip.");
        tip.z.atan2(tip.y)
    };
    let rigidity = 0.5 * YOUNG * PI * DIAMETER.powi(4) / 32.0;
    for follower in [false, true] {
        let uniform = twist(&format!("moment = [100, 0, 0], follower = {follower}"));
        assert_relative("uniform", uniform, 50.0 / rigidity, 1e-3);
        let falling = twist(&format!("moment = [100, 0, 0], moment_end = [0, 0, 0], follower = {follower}"));
        assert_relative("falling", falling, 100.0 / 6.0 / rigidity, 1e-3);
    }
}

/// Reactions of loads on a part of the body with bounds inside elements.
#[test]
fn reactions_of_a_partial_load_are_its_resultants() {
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
            // ∫ x q dx of the components 1 + 3 (x − a)/(b − a) and 0.5 (x − a)/(b − a).
            let growing = length * (a / 2.0 + length / 3.0);
            let exact = Vector3::new(0.0, 0.5 * growing, -(0.5 * (b * b - a * a) + 3.0 * growing));
            let moment = if body.contains("cable") { exact } else { moment };
            assert!((moment - exact).norm() < 1e-5 * exact.norm(), "{body}: {moment}, not {exact}");
        }
    }
}

/// Resultant of a pressure p on a curve with the chord c: force p |c| normal to the chord, moment p |c|²/2 about its start.
///
/// The rod bends by more than 1 rad, almost without stretch.
#[test]
fn pressure_on_a_curve_has_the_resultant_of_its_chord() {
    let pressure = 8.0 * BENDING;
    let loads = format!(
        "loads = [{{ kind = \"distributed_force\", body = \"rod\", force = [0, {pressure:e}, 0], follower = true }}]"
    );
    let model = rod(&LINKED.replace("= 5", "= 16"), &loads, STATICS);
    let run = Run::of(&model);
    let [tip, force, moment] = ["tip.", "root.f", "root.m"].map(|name| run.last_vector(name));
    assert!(tip.x < 0.7, "tip at {tip}");
    let across = Vector3::z().cross(&tip) * pressure;
    assert!((force + across).norm() < 2e-3 * across.norm(), "{force} and {across}");
    assert_relative("moment", -moment.z, 0.5 * pressure * tip.norm_squared(), 2e-3);
}

/// Motion of a free body in an accelerated frame: x = −∬ a f dt².
#[test]
fn free_body_stays_behind_an_accelerated_base() {
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
        let found = run.last_vector("tip.") - Vector3::x();
        assert!((found - exact).norm() < 1e-5 * exact.norm(), "{body}: {found}, not {exact}");
        let [balance, work] = ["balance", "work"].map(|name| run.last(name).abs());
        assert!(balance < 1e-4 * work, "{body}: error of the balance {balance:e}, work {work:e}");
    }
}

/// Column under a uniform axial load: q L³/EI = 7.8373 (Timoshenko & Gere 1961).
#[test]
fn column_buckles_under_a_uniform_axial_load() {
    let loads = "loads = [{ kind = \"distributed_force\", body = \"rod\", force = [-1, 0, 0] }]";
    let run = Run::of(&rod(&LINKED.replace("= 5", "= 32"), loads, "kind = \"buckling\""));
    assert_relative("critical load", run.column("factor")[0], 7.8373 * BENDING, 1e-3);
}

/// Energy balance with follower loads and varying loads: error of second order in the step.
#[test]
fn energy_balance_with_follower_loads_is_of_second_order() {
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
        run.largest("balance") / run.largest("work")
    };
    let [coarse, fine] = [1e-4, 5e-5].map(balance);
    assert!(fine < 1e-2, "error of the balance {fine:e}");
    assert!((3.0..5.5).contains(&(coarse / fine)), "{coarse:e}, {fine:e}");
}

/// All columns except norms in units of the solver.
#[test]
fn scales_do_not_change_distributed_loads() {
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
        assert_same_columns(&load, [&a, &b], &["residual", "increment", "drift"], 1e-3, 1e-7);
    }
}
