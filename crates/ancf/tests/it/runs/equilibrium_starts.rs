//! Motions that start from an equilibrium.

use std::f64::consts::PI;

use ancf::model::{Analysis, Origin, Stop};
use ancf::record::Series;
use ancf::{InitialReport, Model, Outcome, Scales, simulate};
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::{files, parse};
use crate::common::solutions::{Run, SOLVER_COLUMNS, assert_same_columns};

const GRAVITY: f64 = 9.81;

/// Keys of a motion from an equilibrium.
fn from_equilibrium(duration: f64, step: &str, scheme: &str) -> String {
    format!(
        "initial = {{ from = \"equilibrium\" }}\n\
         analysis = {{ kind = \"dynamics\", duration = {duration}, step = {step}, scheme = {scheme} }}\n"
    )
}

/// Motion of the model of a file from its equilibrium.
fn motion_of(name: &str, duration: f64, step: f64) -> Model {
    let mut model = files::model(name);
    model.analysis = Analysis::Dynamics(ancf::model::Dynamics::new(duration, step));
    model.initial.from = Origin::Equilibrium;
    model.initial.statics.first = 0.1;
    model
}

/// Asserts that a point remains in place, relative to a length.
fn assert_rest(run: &Run, point: &str, length: f64) {
    let places = run.vectors(&format!("{point}."));
    let moved = places.iter().map(|r| (r - places[0]).norm()).fold(0.0, f64::max);
    assert!(moved < 1e-12 * length, "{point} moved by {moved:e}");
}

/// Tension and sag of the elastic catenary, as in its test of statics, at rest over five periods of a pendulum of its sag.
#[test]
fn catenary_starts_at_rest() {
    let run = Run::of(&motion_of("catenary", 20.0, 0.05));
    let w = 1100.0 * GRAVITY * PI * 0.002_f64.powi(2);
    for row in [0, run.column("t").len() - 1] {
        assert_relative("H", run.vectors("right.f")[row].x, 4.597_764_795_843_918 * w, 5e-5);
        assert_relative("sag", -run.vectors("middle.")[row].z, 2.979_298_712_151_081, 1e-5);
    }
    assert_rest(&run, "middle", 12.0);
    let size = run.largest("potential");
    assert!(run.largest("kinetic") < 1e-20 * size && run.largest("balance") < 1e-13 * size);
    let Some(InitialReport::Equilibrium { increments, iterations, unstable }) = run.summary.initial else {
        panic!("the report states the equilibrium");
    };
    assert!(increments > 1 && iterations > increments && unstable == Some(0));
}

/// The mooring line in its current has the reactions of statics at the start, and remains there.
#[test]
fn mooring_line_starts_at_rest() {
    let mut still = files::model("mooring");
    let Analysis::Statics(statics) = &mut still.analysis else { panic!("the analysis is static") };
    statics.stop = Stop::Energy { tolerance: 1e-12 };
    let (statics, motion) = (Run::of(&still), Run::of(&motion_of("mooring", 10.0, 0.05)));
    for joint in ["anchor.f", "fairlead.f"] {
        let (at_rest, forces) = (statics.last_vector(joint), motion.vectors(joint));
        assert!(forces.iter().all(|f| (f - at_rest).norm() < 1e-9 * at_rest.norm()), "{joint}");
    }
    assert_rest(&motion, "middle", 120.0);
}

/// A rope on a hook and a pendulum that starts sideways have an equilibrium by their weight only.
#[test]
fn weight_supports_a_rope_and_a_pendulum() {
    let rope = Run::of(&motion_of("hanging_rope", 2.0, 0.01));
    assert_rest(&rope, "end", 3.0);
    let mut pendulum = parse(&format!(
        "gravity = [0, 0, -9.81]\n\
         bodies = [{{ kind = \"rigid\", name = \"bob\", center = [1, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.3] }}]\n\
         joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"bob\", at = [0, 0, 0] }}, axis = [0, 1, 0] }}]\n\
         probes = [{{ name = \"bob\", on = {{ body = \"bob\", at = \"center\" }} }}]\n{}",
        from_equilibrium(1.0, "0.01", "{ spectral_radius = 0.8 }")
    ));
    let run = Run::of(&pendulum);
    let bottom = run.vectors("bob.")[0];
    assert!((bottom + Vector3::z()).norm() < 1e-7, "{bottom}");
    assert_relative("angle", run.column("hinge.angle")[0], 0.5 * PI, 1e-7);
    pendulum.joints.clear();
    let summary = simulate(&pendulum, &mut Series::new()).unwrap();
    let Outcome::Failed { time, reason, at, .. } = summary.outcome else { panic!("a free body falls") };
    pendulum.analysis = Analysis::Statics(ancf::model::Statics::default());
    let statics = simulate(&pendulum, &mut Series::new()).unwrap().outcome;
    let Outcome::Failed { reason: of_statics, at: at_statics, .. } = statics else {
        panic!("a free body falls")
    };
    assert_eq!((time, at), (0.0, at_statics));
    assert_eq!(reason, format!("equilibrium at the start: {of_statics}"));
}

/// Arm on a hinge with a spring, under its weight, and its circular frequency about the equilibrium in closed form.
///
/// k θ = m g l cos θ,  ω² = (k + m g l sin θ)/(J + m l²) for an arm that starts horizontal and sinks by θ.
fn sprung_arm(settings: &str) -> (Model, f64, f64) {
    let (k, mgl, inertia) = (12.0, 2.0 * GRAVITY * 0.5, 0.05 + 2.0 * 0.25);
    let mut angle = 0.5;
    for _ in 0..50 {
        angle -= (k * angle - mgl * f64::cos(angle)) / (k + mgl * f64::sin(angle));
    }
    let omega = ((k + mgl * f64::sin(angle)) / inertia).sqrt();
    let model = parse(&format!(
        "gravity = [0, 0, -9.81]\n\
         bodies = [{{ kind = \"rigid\", name = \"arm\", center = [0.5, 0, 0], mass = 2, inertia = [0.01, 0.05, 0.05], \
         motion = {{ spin = [0, 1e-4, 0], about = [0, 0, 0] }} }}]\n\
         joints = [{{ kind = \"revolute\", name = \"hinge\", a = {{ body = \"arm\", at = [0, 0, 0] }}, axis = [0, 1, 0], \
         spring = {{ stiffness = {k} }} }}]\n{settings}"
    ));
    (model, angle, omega)
}

/// Frequency of an oscillation by its first and last crossings of the start value, from below.
fn frequency(times: &[f64], values: &[f64]) -> f64 {
    let crossings: Vec<f64> = (1..values.len())
        .filter(|&i| values[i - 1] <= values[0] && values[i] > values[0])
        .map(|i| {
            let part = (values[0] - values[i - 1]) / (values[i] - values[i - 1]);
            times[i - 1] + part * (times[i] - times[i - 1])
        })
        .collect();
    (crossings.len() - 1) as f64 / (crossings[crossings.len() - 1] - crossings[0])
}

/// A small oscillation about the equilibrium has the frequency of the closed form and of the prestressed modes. Its energy balance
/// begins with the energies of the equilibrium.
#[test]
fn arm_oscillates_at_its_frequency_about_the_equilibrium() {
    let settings = from_equilibrium(20.0, "2e-3", "\"average_acceleration\"");
    let (model, angle, omega) = sprung_arm(&settings);
    let run = Run::of(&model);
    assert_relative("angle", run.column("hinge.angle")[0], angle, 1e-12);
    assert_relative("potential", run.column("potential")[0], -2.0 * GRAVITY * 0.5 * angle.sin(), 1e-12);
    assert_relative("kinetic energy", run.column("kinetic")[0], 0.5 * 0.55 * 1e-8, 1e-9);
    let found = frequency(run.column("t"), run.column("hinge.angle"));
    // Average acceleration lengthens the period by (ω h)²/12.
    assert_relative("frequency", found, omega / (2.0 * PI), (omega * 2e-3).powi(2) / 10.0);
    let (modes, ..) = sprung_arm("analysis = { kind = \"modes\", count = 1, about = \"equilibrium\" }\n");
    assert_relative("mode", Run::of(&modes).column("frequency")[0], omega / (2.0 * PI), 1e-9);
}

/// Clamped column under half of its critical load and a side load.
fn column(settings: &str) -> Model {
    parse(&format!(
        "materials.m = {{ density = 1000, young = 2e8 }}\nsections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
         bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [0, 0, 1], elements = 4, section = \"s\", \
         material = \"m\", motion = {{ spin = [0, 1e-4, 0] }} }}]\n\
         joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
         loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = [0.05, 0, -1.9379] }}]\n\
         probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }} }}]\n{settings}"
    ))
}

/// The oscillation of a column about its bent equilibrium has the frequency of the prestressed mode, 0.7 of that without load.
#[test]
fn column_oscillates_at_the_frequency_of_its_prestressed_mode() {
    let run = Run::of(&column(&from_equilibrium(12.0, "4e-3", "{ spectral_radius = 0.8 }")));
    let loaded = Run::of(&column("analysis = { kind = \"modes\", count = 4, about = \"equilibrium\" }\n"));
    let free = Run::of(&column("analysis = { kind = \"modes\", count = 4 }\n"));
    // Modes in pairs: the first ones are in the plane of the side load and normal to it.
    let [loaded, free] = [loaded, free].map(|run| run.column("frequency")[0]);
    assert!(loaded < 0.8 * free, "{loaded} and {free}");
    assert_relative("frequency", frequency(run.column("t"), run.column("tip.x")), loaded, 3e-3);
}

/// Drives and loads have their values at t = 0, without their rates. The equilibrium is that of statics with these values.
#[test]
fn drives_and_loads_have_their_values_at_the_start() {
    let arm = |drive: &str, load: &str, settings: &str| {
        parse(&format!(
            "gravity = [0, 0, -9.81]\nmaterials.m = {{ density = 1000, young = 2e8, damping = {{ strain = 1e-3, mass = 0.5 }} }}\n\
             sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
             bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 3, section = \"s\", material = \"m\" }}]\n\
             joints = [{{ kind = \"drive\", name = \"root\", a = {{ body = \"b\", at = \"start\" }}, axis = [0, 0, 1], angle = 0.6{drive} }}]\n\
             loads = [{{ kind = \"force\", on = {{ body = \"b\", at = \"end\" }}, force = [0, 0.2, 0]{load} }},\n\
             {{ kind = \"fluid\", bodies = [\"b\"], density = 1, current = [0, 3, 0], diameter = 0.02, drag = [1, 0.1], added_mass = [1, 0]{load} }}]\n\
             probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }} }}]\n{settings}"
        ))
    };
    let drive = ", time = { kind = \"expression\", text = \"cos(t)\" }";
    let load = ", time = { kind = \"expression\", text = \"1 + 5*t\" }";
    let motion = Run::of(&arm(drive, load, &from_equilibrium(0.1, "0.01", "{ spectral_radius = 0.8 }")));
    let statics = Run::of(&arm(
        ", time = 1",
        "",
        "analysis = { kind = \"statics\", stop = { rule = \"energy\", tolerance = 1e-12 } }\n",
    ));
    let [moved, still] = [motion.vectors("tip.")[0], statics.last_vector("tip.")];
    assert!((moved - still).norm() < 1e-10, "{moved} and {still}");
    assert!(still.y > 0.5 && still.z < -0.1, "{still}");
    assert_eq!(motion.column("kinetic")[0], 0.0);
}

/// A beam that lies on a bed under its weight starts there, with friction and damping of the contact.
#[test]
fn contacts_carry_the_weight() {
    let settings = from_equilibrium(0.5, "0.01", "{ spectral_radius = 0.8 }");
    let run = Run::of(&parse(&format!(
        "gravity = [0, 0, -9.81]\nmaterials.m = {{ density = 1000, young = 2e7 }}\n\
         sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
         bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0.1], to = [1, 0, 0.1], elements = 8, section = \"s\", material = \"m\" }}]\n\
         joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
         contacts = [{{ with = {{ kind = \"plane\", point = [0, 0, 0], normal = [0, 0, 1] }}, stiffness = 1e5, damping = 0.1, friction = 0.3 }}]\n\
         probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }} }}]\n{settings}"
    )));
    let tip = run.vectors("tip.")[0];
    assert!((0.009..0.01).contains(&tip.z), "{tip}");
    let weight = 1000.0 * GRAVITY * PI * 1e-4;
    assert!(run.vectors("root.f")[0].z < 0.9 * weight, "the bed carries a part of the weight");
    assert_rest(&run, "tip", 1.0);
    assert!(run.largest("kinetic") < 1e-20);
}

/// The equilibrium remains with adaptive steps, with the energy-momentum scheme and with accelerations that start from zero.
#[test]
fn every_scheme_remains_at_rest() {
    for (step, scheme, more) in [
        ("{ tolerance = 1e-4 }", "{ spectral_radius = 0.8 }", ""),
        ("0.01", "\"energy\"", ""),
        ("0.01", "{ energy_damping = 0.01 }", ""),
        ("0.01", "\"adams\"", ", start = \"zero\""),
    ] {
        let settings = from_equilibrium(1.0, step, &format!("{scheme}{more}"));
        let mut model = column(&settings);
        let ancf::model::Body::Beam(beam) = &mut model.bodies[0] else { panic!("the body is a beam") };
        beam.motion = ancf::model::InitialMotion::default();
        let run = Run::of(&model);
        assert_rest(&run, "tip", 1.0);
        assert!(run.column("tip.x")[0] > 0.005);
    }
}

/// The motion from an equilibrium does not depend on units.
#[test]
fn units_do_not_change_the_motion() {
    let model = column(&from_equilibrium(0.5, "0.01", "{ spectral_radius = 0.8 }"));
    let scales = Scales { length: 8.0, time: 0.25, force: 1024.0 };
    let (own, scaled) = (Run::of(&model), Run::of(&model.scaled(&scales)));
    for (a, b) in own.vectors("tip.").iter().zip(scaled.vectors("tip.")) {
        assert!((a - b * scales.length).norm() < 1e-12);
    }
    let mut automatic = model;
    automatic.scales = ancf::model::ScaleChoice::Auto;
    assert_same_columns("scales", [&own, &Run::of(&automatic)], &SOLVER_COLUMNS, 1e-6, 1e-8);
}

/// The motion from an equilibrium does not depend on the frame of reference.
#[test]
fn turned_models_have_turned_motions() {
    let model = column(&from_equilibrium(0.5, "0.01", "{ spectral_radius = 0.8 }"));
    // (x, y, z) -> (z, x, y).
    let turn = |v: [f64; 3]| [v[2], v[0], v[1]];
    let mut turned = model.clone();
    let ancf::model::Body::Beam(beam) = &mut turned.bodies[0] else { panic!("the body is a beam") };
    (beam.to, beam.motion.spin) = (turn(beam.to), turn(beam.motion.spin));
    let ancf::model::Load::Force(load) = &mut turned.loads[0] else { panic!("the load is a force") };
    load.force = turn(load.force);
    let (own, other) = (Run::of(&model), Run::of(&turned));
    for (a, b) in own.vectors("tip.").iter().zip(other.vectors("tip.")) {
        assert!((Vector3::new(a.z, a.x, a.y) - b).norm() < 1e-10, "{a} {b}");
    }
}

/// An equilibrium beyond the critical load is unstable, which is a warning; `unstable = "stop"` rejects it.
#[test]
fn unstable_equilibria_are_reported() {
    let mut model = column(&from_equilibrium(0.1, "0.01", "{ spectral_radius = 0.8 }"));
    let ancf::model::Load::Force(load) = &mut model.loads[0] else { panic!("the load is a force") };
    load.force = [0.0, 0.0, -6.0];
    let summary = simulate(&model, &mut Series::new()).unwrap();
    assert!(summary.outcome.is_finished());
    let is_meant = |text: &String| text.starts_with("equilibrium at the start: the last equilibrium");
    assert!(summary.warnings.iter().any(is_meant), "{:?}", summary.warnings);
    model.initial.statics.unstable = ancf::model::Unstable::Stop;
    let summary = simulate(&model, &mut Series::new()).unwrap();
    let Outcome::Failed { reason, advice, .. } = summary.outcome else { panic!("the search stops") };
    assert!(reason.starts_with("equilibrium at the start: ") && reason.contains("load factor"), "{reason}");
    assert!(advice.contains("unstable = \"leave\""), "{advice}");
}
