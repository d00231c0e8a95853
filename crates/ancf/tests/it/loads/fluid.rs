//! Bodies in a fluid: motions, equilibria and vibrations with closed forms; energy balance.

use std::f64::consts::PI;

use ancf::Model;
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

const WATER: f64 = 1000.0;
const SOLID: f64 = 1800.0;
const DIAMETER: f64 = 0.05;
const GRAVITY: f64 = 9.81;
const BODIES: [&str; 3] = [
    "kind = \"beam\"\nformulation = \"linked\"",
    "kind = \"beam\"\nformulation = \"quadratic\"",
    "kind = \"cable\"",
];
const STATICS: &str = "kind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-12 }";

fn area() -> f64 {
    PI * DIAMETER * DIAMETER / 4.0
}

fn dynamics(duration: f64, step: f64) -> String {
    format!(
        "kind = \"dynamics\"\nduration = {duration:e}\nstep = {step:e}\nscheme = {{ spectral_radius = 0.9 }}"
    )
}

/// Free rod of a given density from the origin to `to`, in water.
fn rod(body: &str, density: f64, to: [f64; 3], fluid: &str, analysis: &str) -> Model {
    let text = format!(
        "gravity = [0, 0, {}]
        materials.solid = {{ density = {density}, young = 1e9 }}
        sections.round = {{ kind = \"circle\", diameter = {DIAMETER} }}
        probes = [{{ name = \"tip\", on = {{ body = \"rod\", at = \"end\" }} }}]
        loads = [{{ kind = \"fluid\", bodies = [\"rod\"], density = {WATER}, {fluid} }}]
        [[bodies]]
        {body}
        name = \"rod\"
        from = [0, 0, 0]
        to = {to:?}
        elements = 2
        section = \"round\"
        material = \"solid\"
        [analysis]
        {analysis}",
        -GRAVITY
    );
    parse(&text)
}

fn clamped(model: Model) -> Model {
    let joints =
        "kind = \"clamp\"\nname = \"root\"\na = { body = \"rod\", at = \"start\" }\nfix = \"section\"";
    Model { joints: vec![toml::from_str(joints).unwrap()], ..model }
}

/// Sinking from rest: v = v∞ tanh(g' t/v∞) with v∞ = √((ρs − ρ) A g/D), D = ½ρ d C_n or ½ρ π d C_t.
///
/// Initial acceleration g' = (ρs − ρ) g/(ρs + C_a ρ).
#[test]
fn sinking_cylinder_has_its_terminal_velocity() {
    let weight = (SOLID - WATER) * GRAVITY * area();
    let cases = [
        ("across", [1.0, 0.0, 0.0], 0.5 * WATER * DIAMETER * 1.2, 1.0),
        ("along", [0.0, 0.0, -1.0], 0.5 * WATER * PI * DIAMETER * 0.3, 0.5),
    ];
    for (name, to, drag, added) in cases {
        let (limit, start) = ((weight / drag).sqrt(), weight / area() / (SOLID + added * WATER));
        for body in BODIES {
            let water = "drag = [1.2, 0.3], added_mass = [1.0, 0.5]";
            let run = Run::of(&rod(body, SOLID, to, water, &dynamics(0.4, 1e-3)));
            let speed = -run.last_vector("tip.v").z;
            assert_relative(name, speed, limit * (start * 0.4 / limit).tanh(), 1e-5);
            let first = -run.vectors("tip.a")[0].z;
            assert_relative("release", first, start, 1e-9);
            assert!(run.vectors("tip.v").iter().all(|v| v.xy().norm() < 1e-9), "{name}: lateral velocity");
        }
        let water = "drag = [1.2, 0.3], added_mass = [1.0, 0.5]";
        let run = Run::of(&rod(BODIES[0], SOLID, to, water, &dynamics(8.0, 1e-2)));
        assert_relative("terminal velocity", -run.last_vector("tip.v").z, limit, 1e-6);
    }
}

/// Upward acceleration (ρ − ρs) g/(ρs + C_a ρ) of a rod lighter than water, without drag.
#[test]
fn buoyant_rod_accelerates_against_its_added_mass() {
    for body in BODIES {
        let run = Run::of(&rod(body, 600.0, [1.0, 0.0, 0.0], "drag = [0, 0]", &dynamics(0.1, 1e-3)));
        let exact = 400.0 * GRAVITY / 1600.0;
        for a in run.vectors("tip.a") {
            assert_relative("acceleration", a.z, exact, 1e-9);
        }
    }
}

/// Rod clamped at an angle to a current: normal and tangential drag, each with its coefficient.
#[test]
fn drag_has_normal_and_tangential_components() {
    let (speed, angle): (f64, f64) = (0.02, 0.6);
    let tangent = Vector3::new(angle.cos(), angle.sin(), 0.0);
    for body in &BODIES[..2] {
        let water = format!("current = [{speed}, 0, 0], drag = [1.2, 0.3]");
        let run = Run::of(&clamped(rod(body, WATER, tangent.into(), &water, STATICS)));
        let (along, across) = (speed * angle.cos(), Vector3::x() * speed - tangent * (speed * angle.cos()));
        let drag = across * (0.5 * WATER * DIAMETER * 1.2 * across.norm())
            + tangent * (0.5 * WATER * PI * DIAMETER * 0.3 * along * along);
        let force = run.last_vector("root.f");
        assert!((force + drag).norm() < 1e-5 * drag.norm(), "{body}: {force} and {drag}");
        let moment = run.last_vector("root.m");
        let expected = tangent.cross(&drag) * 0.5;
        assert!((moment + expected).norm() < 1e-5 * expected.norm(), "{body}: {moment} and {expected}");
    }
}

/// Weightless line in a current without tangential drag: constant tension T, shape of a catenary, T dφ/ds = D sin²φ.
///
/// Half the length S has the span (T/D) asinh(D S/T) and the sag (T/D) (√(1 + (D S/T)²) − 1).
#[test]
fn line_in_a_current_is_a_catenary() {
    let (half, span, speed): (f64, f64, f64) = (1.0, 0.9, 0.5);
    let drag = 0.5 * WATER * 0.01 * 1.2 * speed * speed;
    let text = format!(
        "materials.rubber = {{ density = {WATER}, young = 1e9 }}
        sections.thin = {{ kind = \"general\", area = 7.85e-5, iy = 1e-14, iz = 1e-14 }}
        bodies = [{{ kind = \"cable\", name = \"line\", from = [0, -1, 0], to = [0, 1, 0], elements = 40, section = \"thin\",
                     material = \"rubber\" }}]
        joints = [
            {{ kind = \"spherical\", name = \"left\", a = {{ body = \"line\", at = \"start\" }}, b = {{ point = [0, -{span}, 0] }} }},
            {{ kind = \"spherical\", name = \"right\", a = {{ body = \"line\", at = \"end\" }}, b = {{ point = [0, {span}, 0] }} }},
        ]
        loads = [{{ kind = \"fluid\", bodies = [\"line\"], density = {WATER}, diameter = 0.01, current = [{speed}, 0, 0],
                    drag = [1.2, 0] }}]
        probes = [{{ name = \"middle\", on = {{ body = \"line\", at = 1 }} }}]
        [analysis]
        {STATICS}
        first = 0.1"
    );
    let run = Run::of(&parse(&text));
    // Lengths in multiples of T/D: asinh(S)/S falls with S.
    let (mut low, mut high) = (1e-3_f64, 10.0_f64);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle.asinh() / middle > span / half { low = middle } else { high = middle }
    }
    let unit = half / low;
    let sag = unit * ((1.0 + low * low).sqrt() - 1.0);
    assert_relative("sag", run.last_vector("middle.").x, sag, 1e-3);
    let tension = unit * drag;
    for end in ["left.f", "right.f"] {
        assert_relative("tension", run.last_vector(end).norm(), tension, 1e-3);
    }
}

/// A neutrally buoyant rod moves with an unsteady current, in any orientation.
#[test]
fn neutrally_buoyant_rod_moves_with_the_current() {
    let water = "drag = [0, 0], added_mass = [1.0, 0.4], current = [1, 2, -1], \
                 time = { kind = \"expression\", text = \"t^2\" }";
    for body in BODIES {
        let run = Run::of(&rod(body, WATER, [0.6, 0.0, 0.8], water, &dynamics(0.2, 1e-3)));
        let found = run.last_vector("tip.v") - Vector3::new(1.0, 2.0, -1.0) * 0.04;
        assert!(found.norm() < 1e-6, "{body}: {found}");
    }
}

/// Added mass lowers bending frequencies by the factor √(1 + C_a ρ/ρs).
#[test]
fn added_mass_lowers_bending_frequencies() {
    let of = |added: f64| {
        let water = format!("drag = [0, 0], added_mass = [{added}, 0]");
        let analysis = "kind = \"modes\"\ncount = 4";
        let model = clamped(rod(BODIES[0], SOLID, [2.0, 0.0, 0.0], &water, analysis));
        Run::of(&model).column("frequency").to_vec()
    };
    let (dry, wet) = (of(0.0), of(1.3));
    for (dry, wet) in dry.iter().zip(&wet) {
        // Added mass has no rotary inertia of the sections, at most π²d²/16L² of the lowest frequency.
        assert_relative("frequency", dry / wet, (1.0 + 1.3 * WATER / SOLID).sqrt(), 2e-3);
    }
}

/// Drag in a fluid at rest, or of a current along the axis without tangential drag, is quadratic in the velocities: damped modes are those
/// without drag. In a current they are damped.
#[test]
fn drag_at_rest_does_not_damp_small_vibrations() {
    let of = |keys: &str, damped: bool| {
        let analysis = format!("kind = \"modes\"\nabout = \"equilibrium\"\ncount = 2\ndamped = {damped}");
        let model = clamped(rod(BODIES[0], WATER, [2.0, 0.0, 0.0], keys, &analysis));
        Run::of(&model)
    };
    let undamped = of("drag = [1.2, 0.1]", false);
    for keys in ["drag = [1.2, 0.1]", "drag = [1.2, 0], current = [0.3, 0, 0]"] {
        let damped = of(keys, true);
        for (frequency, expected) in damped.column("frequency").iter().zip(undamped.column("frequency")) {
            assert_relative(keys, *frequency, *expected, 1e-5);
        }
        assert!(damped.column("damping_ratio").iter().all(|ratio| ratio.abs() < 1e-9), "{keys}");
    }
    let current = of("drag = [1.2, 0], current = [0, 0.3, 0]", true);
    assert!(current.column("damping_ratio").iter().all(|ratio| *ratio > 1e-4));
}

/// Reaction of a tapered rod: weight less buoyancy, integrated over the areas.
#[test]
fn reaction_of_a_tapered_rod_is_weight_less_buoyancy() {
    let mut model = clamped(rod(BODIES[0], SOLID, [1.0, 0.0, 0.0], "drag = [1, 0]", STATICS));
    let end = ancf::model::Section::circle(0.02);
    model.sections.insert("thin".into(), end);
    let ancf::model::Body::Beam(beam) = &mut model.bodies[0] else { panic!("the body is a beam") };
    beam.section_end = Some("thin".into());
    // Volume of a frustum with the diameters D and d: π/12 (D² + D d + d²) per length.
    let volume = PI / 12.0 * (DIAMETER * DIAMETER + DIAMETER * 0.02 + 0.02 * 0.02);
    let force = Run::of(&model).last_vector("root.f");
    assert_relative("force", force.z, (SOLID - WATER) * GRAVITY * volume, 1e-9);
}

/// Energy balance of a soft rod in an oscillating current: error of second order in the step.
#[test]
fn energy_balance_in_a_current_is_of_second_order() {
    let water = "current = [0.3, 0.5, 0], drag = [1.2, 0.1], added_mass = [1.0, 0.2], \
                 time = { kind = \"sine\", frequency = 1.5, phase = 0.4 }";
    for body in BODIES {
        let error = |step: f64| {
            let analysis = dynamics(0.5, step).replace("0.9", "1.0");
            let mut model = clamped(rod(body, SOLID, [1.0, 0.0, 0.0], water, &analysis));
            model.materials.get_mut("solid").unwrap().young = 3e6;
            let run = Run::of(&model);
            assert!(run.column("dissipated").windows(2).all(|pair| pair[0] <= pair[1]), "{body}");
            assert!(
                run.largest("work") > 1e-2 * run.largest("potential"),
                "{body}: {:e}",
                run.largest("work")
            );
            run.largest("balance") / run.largest("potential")
        };
        let [coarse, fine] = [1e-3, 5e-4].map(error);
        assert!(fine < 1e-3, "{body}: error of the balance {fine:e}");
        assert!((3.0..5.5).contains(&(coarse / fine)), "{body}: {coarse:e}, {fine:e}");
    }
}
