//! Bodies in a fluid: motions, equilibria and vibrations with closed forms, and the books of energy.

use std::f64::consts::PI;

use crate::common::solutions::Run;
use ancf::Model;
use nalgebra::Vector3;

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

/// A rod of some density from the origin to `to`, in water, that nothing holds.
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
    Model::parse(&text).unwrap_or_else(|errors| panic!("{errors:?}\n{text}"))
}

fn clamped(model: Model) -> Model {
    let joints =
        "kind = \"clamp\"\nname = \"root\"\na = { body = \"rod\", at = \"start\" }\nfix = \"section\"";
    Model { joints: vec![toml::from_str(joints).unwrap()], ..model }
}

#[track_caller]
fn assert_near(what: &str, found: f64, wanted: f64, tolerance: f64) {
    assert!((found / wanted - 1.0).abs() < tolerance, "{what}: {found:e}, not {wanted:e}");
}

/// Sinking from rest: v = v∞ tanh(g' t/v∞) with v∞ = √((ρs − ρ) A g/D), D = ½ρ d C_n or ½ρ π d C_t, and
/// g' = (ρs − ρ) g/(ρs + C_a ρ), the acceleration of the release.
#[test]
fn a_cylinder_sinks() {
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
            let speed = -run.vectors("tip.v").last().unwrap().z;
            assert_near(name, speed, limit * (start * 0.4 / limit).tanh(), 1e-5);
            let first = -run.vectors("tip.a")[0].z;
            assert_near("release", first, start, 1e-9);
            assert!(run.vectors("tip.v").iter().all(|v| v.xy().norm() < 1e-9), "{name}: it sinks straight");
        }
        let water = "drag = [1.2, 0.3], added_mass = [1.0, 0.5]";
        let run = Run::of(&rod(BODIES[0], SOLID, to, water, &dynamics(8.0, 1e-2)));
        assert_near("terminal velocity", -run.vectors("tip.v").last().unwrap().z, limit, 1e-6);
    }
}

/// Lighter than water, without drag: (ρs − ρ) g/(ρs + C_a ρ) upwards.
#[test]
fn a_buoyant_rod_is_released() {
    for body in BODIES {
        let run = Run::of(&rod(body, 600.0, [1.0, 0.0, 0.0], "drag = [0, 0]", &dynamics(0.1, 1e-3)));
        let exact = 400.0 * GRAVITY / 1600.0;
        for a in run.vectors("tip.a") {
            assert_near("acceleration", a.z, exact, 1e-9);
        }
    }
}

/// Held at an angle in a current: the parts across and along the rod, each by its own coefficient.
#[test]
fn drag_at_an_angle() {
    let (speed, angle): (f64, f64) = (0.02, 0.6);
    let tangent = Vector3::new(angle.cos(), angle.sin(), 0.0);
    for body in &BODIES[..2] {
        let water = format!("current = [{speed}, 0, 0], drag = [1.2, 0.3]");
        let run = Run::of(&clamped(rod(body, WATER, tangent.into(), &water, STATICS)));
        let (along, across) = (speed * angle.cos(), Vector3::x() * speed - tangent * (speed * angle.cos()));
        let drag = across * (0.5 * WATER * DIAMETER * 1.2 * across.norm())
            + tangent * (0.5 * WATER * PI * DIAMETER * 0.3 * along * along);
        let force = *run.vectors("root.f").last().unwrap();
        assert!((force + drag).norm() < 1e-5 * drag.norm(), "{body}: {force} and {drag}");
        let moment = *run.vectors("root.m").last().unwrap();
        let turned = tangent.cross(&drag) * 0.5;
        assert!((moment + turned).norm() < 1e-5 * turned.norm(), "{body}: {moment} and {turned}");
    }
}

/// A line in a current without weight and without tangential drag has the same tension T all along and hangs as a catenary:
/// T dφ/ds = D sin²φ, so that its half, of length S, spans (T/D) asinh(D S/T) and sags by (T/D) (√(1 + (D S/T)²) − 1).
#[test]
fn a_line_in_a_current() {
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
    let model = Model::parse(&text).unwrap_or_else(|errors| panic!("{errors:?}"));
    let run = Run::of(&model);
    // Lengths in multiples of T/D: asinh(S)/S falls with S.
    let (mut low, mut high) = (1e-3_f64, 10.0_f64);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle.asinh() / middle > span / half { low = middle } else { high = middle }
    }
    let unit = half / low;
    let sag = unit * ((1.0 + low * low).sqrt() - 1.0);
    assert_near("sag", run.vectors("middle.").last().unwrap().x, sag, 1e-3);
    let tension = unit * drag;
    for end in ["left.f", "right.f"] {
        assert_near("tension", run.vectors(end).last().unwrap().norm(), tension, 1e-3);
    }
}

/// A rod of the weight of water goes with a current that changes, however it lies.
#[test]
fn a_current_takes_along() {
    let water = "drag = [0, 0], added_mass = [1.0, 0.4], current = [1, 2, -1], \
                 time = { kind = \"expression\", text = \"t^2\" }";
    for body in BODIES {
        let run = Run::of(&rod(body, WATER, [0.6, 0.0, 0.8], water, &dynamics(0.2, 1e-3)));
        let found = run.vectors("tip.v").last().unwrap() - Vector3::new(1.0, 2.0, -1.0) * 0.04;
        assert!(found.norm() < 1e-6, "{body}: {found}");
    }
}

/// Water without drag lowers frequencies of bending by √(1 + C_a ρ/ρs).
#[test]
fn frequencies_in_water() {
    let of = |added: f64| {
        let water = format!("drag = [0, 0], added_mass = [{added}, 0]");
        let analysis = "kind = \"modes\"\ncount = 4";
        let model = clamped(rod(BODIES[0], SOLID, [2.0, 0.0, 0.0], &water, analysis));
        Run::of(&model).column("frequency").to_vec()
    };
    let (dry, wet) = (of(0.0), of(1.3));
    for (dry, wet) in dry.iter().zip(&wet) {
        // The rotary inertia of sections, π²d²/16L² of the lowest at most, is not that of water.
        assert_near("frequency", dry / wet, (1.0 + 1.3 * WATER / SOLID).sqrt(), 2e-3);
    }
}

/// A tapered rod: what holds it is its weight less that of the water, of the areas along it.
#[test]
fn buoyancy_of_a_tapered_rod() {
    let mut model = clamped(rod(BODIES[0], SOLID, [1.0, 0.0, 0.0], "drag = [1, 0]", STATICS));
    let end = ancf::model::Section::Circle { diameter: 0.02 };
    model.sections.insert("thin".into(), end);
    let ancf::model::Body::Beam(beam) = &mut model.bodies[0] else { panic!("a beam") };
    beam.section_end = Some("thin".into());
    // Of a frustum of the diameters D and d: π/12 (D² + D d + d²).
    let volume = PI / 12.0 * (DIAMETER * DIAMETER + DIAMETER * 0.02 + 0.02 * 0.02);
    let force = *Run::of(&model).vectors("root.f").last().unwrap();
    assert_near("force", force.z, (SOLID - WATER) * GRAVITY * volume, 1e-9);
}

/// A soft rod swings in water that flows and surges: the books close, to the second order of the step.
#[test]
fn books() {
    let water = "current = [0.3, 0.5, 0], drag = [1.2, 0.1], added_mass = [1.0, 0.2], \
                 time = { kind = \"sine\", frequency = 1.5, phase = 0.4 }";
    for body in BODIES {
        let closed = |step: f64| {
            let analysis = dynamics(0.5, step).replace("0.9", "1.0");
            let mut model = clamped(rod(body, SOLID, [1.0, 0.0, 0.0], water, &analysis));
            model.materials.get_mut("solid").unwrap().young = 3e6;
            let run = Run::of(&model);
            let largest = |name: &str| run.column(name).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(run.column("dissipated").windows(2).all(|pair| pair[0] <= pair[1]), "{body}");
            assert!(largest("work") > 1e-2 * largest("potential"), "{body}: {:e}", largest("work"));
            largest("balance") / largest("potential")
        };
        let [coarse, fine] = [1e-3, 5e-4].map(closed);
        assert!(fine < 1e-3, "{body}: a balance of {fine:e}");
        assert!((3.0..5.5).contains(&(coarse / fine)), "{body}: {coarse:e}, {fine:e}");
    }
}
