//! Energy-momentum scheme: energy, momenta, order, coarse steps.

use std::f64::consts::TAU;

use ancf::record::Series;
use ancf::{Model, Summary, simulate};
use nalgebra::Vector3;

use crate::common::models::parse;
use crate::common::solutions::{Run, recorded_momenta};

/// Largest change of both momenta of a free system, relative to their size.
fn changes_of_momenta(model: &Model) -> [f64; 2] {
    let all = recorded_momenta(model);
    [0, 1].map(|k| all.iter().map(|now| (now[k] - all[0][k]).norm()).fold(0.0, f64::max) / all[0][k].norm())
}

/// Largest change of the total energy relative to the largest kinetic plus strain energy.
fn energy_change(run: &Run) -> f64 {
    let [kinetic, strain, potential] = ["kinetic", "strain", "potential"].map(|name| run.column(name));
    let total: Vec<f64> = (0..kinetic.len()).map(|i| kinetic[i] + strain[i] + potential[i]).collect();
    let size = (0..kinetic.len()).map(|i| kinetic[i] + strain[i]).fold(0.0, f64::max);
    total.iter().map(|now| (now - total[0]).abs()).fold(0.0, f64::max) / size
}

fn with_analysis(parts: &str, duration: f64, step: f64, keys: &str) -> Model {
    parse(&format!(
        "{parts}\n[analysis]\nkind = \"dynamics\"\nduration = {duration}\nstep = {step}\n{keys}\n"
    ))
}

const ENERGY: &str = "scheme = \"energy\"";

/// Free body that tumbles, with a number of steps per turn about z.
fn tumbling(steps: f64, turns: f64, keys: &str) -> Model {
    let (rate, step) = (8.0, TAU / 8.0 / steps);
    let body = format!(
        "bodies = [{{ kind = \"rigid\", name = \"top\", center = [0.2, 0, 0], mass = 2, inertia = [0.5, 0.9, 1.2], \
         motion = {{ spin = [2, 0.3, {rate}], velocity = [1, 2, 3] }} }}]"
    );
    with_analysis(&body, turns * steps * step, step, keys)
}

#[test]
fn free_bodies_conserve_energy_and_momenta_in_steps_of_any_size() {
    for steps in [100.0, 31.0, 12.0] {
        let model = tumbling(steps, 15.0, ENERGY);
        let run = Run::of(&model);
        let (energy, momenta) = (energy_change(&run), changes_of_momenta(&model));
        assert!(energy < 1e-11, "{steps} steps a turn: energy {energy:e}");
        assert!(run.largest("balance") < 1e-11 * run.largest("kinetic"), "{steps} steps a turn: balance");
        assert!(momenta[0] < 1e-11 && momenta[1] < 1e-11, "{steps} steps a turn: momenta {momenta:?}");
        assert!(run.summary.warnings.is_empty(), "{:?}", run.summary.warnings);
        assert_eq!(run.summary.divided_steps, 0, "{steps} steps a turn");
    }
    // Generalized-α needs 22 steps a turn with its default, and more with less damping.
    let other =
        Run::of(&tumbling(12.0, 15.0, "energy_guard = { gain = 10 }\nscheme = { spectral_radius = 0.8 }"));
    assert!(energy_change(&other) > 1e-2);
}

/// The drift of Φ_q v at the ends of steps is of second order and does not grow.
#[test]
fn the_velocity_drift_does_not_grow() {
    let run = Run::of(&tumbling(31.0, 60.0, ENERGY));
    let drift = run.column("drift");
    let (first, last) = drift.split_at(drift.len() / 4);
    let largest = |part: &[f64]| part.iter().fold(0.0_f64, |a, b| a.max(*b));
    assert!(largest(last) < 1.5 * largest(first), "{} {}", largest(first), largest(last));
}

/// Symmetric top, whose axis precesses about the angular momentum L at the rate |L|/J_t: the scheme is of second order.
#[test]
fn precession_is_of_second_order() {
    let (transverse, axial, spin) = (2.0, 1.0, Vector3::new(0.5, 0.0, 3.0));
    let momentum = Vector3::new(transverse * spin.x, 0.0, axial * spin.z);
    let duration = 0.37 * TAU * transverse / momentum.norm();
    let about = momentum.normalize();
    let exact = nalgebra::Rotation3::from_scaled_axis(about * (momentum.norm() / transverse * duration))
        * Vector3::z();
    let errors = [100.0, 200.0].map(|steps| {
        let body = format!(
            "bodies = [{{ kind = \"rigid\", name = \"top\", center = [0, 0, 0], mass = 3, inertia = [{transverse}, {transverse}, {axial}], \
             motion = {{ spin = [0.5, 0, 3] }} }}]\nprobes = [{{ name = \"end\", on = {{ body = \"top\", at = [0, 0, 1] }} }}]"
        );
        (Run::of(&with_analysis(&body, duration, duration / steps, ENERGY)).last_vector("end.") - exact).norm()
    });
    let ratio = errors[0] / errors[1];
    assert!((3.9..4.1).contains(&ratio), "{errors:?}");
}

/// Heavy top on a ball joint: energy, and the angular momentum about the vertical through the joint.
#[test]
fn heavy_top_conserves_energy_and_vertical_momentum() {
    for steps in [60.0, 16.0] {
        let step = TAU / 8.0 / steps;
        let parts = "gravity = [0, 0, -9.81]\nbodies = [{ kind = \"rigid\", name = \"top\", center = [0, 0.3, 0.4], mass = 2, \
                     inertia = [0.5, 0.9, 1.2], motion = { spin = [0.3, 0.2, 8], about = [0, 0, 0] } }]\n\
                     joints = [{ kind = \"spherical\", name = \"foot\", a = { body = \"top\", at = [0, 0, 0] } }]";
        let model = with_analysis(parts, 10.0 * steps * step, step, ENERGY);
        let energy = energy_change(&Run::of(&model));
        assert!(energy < 1e-11, "{steps} steps a turn: energy {energy:e}");
        let all = recorded_momenta(&model);
        let moved = all.iter().map(|now| (now[1].z - all[0][1].z).abs()).fold(0.0, f64::max) / all[0][1].z;
        assert!(moved < 1e-11, "{steps} steps a turn: momentum {moved:e}");
    }
}

/// Beam or cable that spins about its axis and tumbles, with other keys of body and material.
fn shaft(kind: &str, material: &str, step: f64, keys: &str) -> Model {
    let parts = format!(
        "materials.m = {{ density = 1200, young = 3e8{material} }}\nsections.s = {{ kind = \"circle\", diameter = 0.06 }}\n\
         bodies = [{{ {kind}, name = \"shaft\", from = [0, 0, 0], to = [0.4, 0.2, 0], elements = 2, section = \"s\", material = \"m\", \
         motion = {{ spin = [60, 30, 25], velocity = [1, 0, 2] }} }}]"
    );
    with_analysis(&parts, 40.0 * step, step, keys)
}

const FORMULATIONS: [&str; 5] = [
    "kind = \"beam\", formulation = \"continuum\"",
    "kind = \"beam\", formulation = \"enhanced\"",
    "kind = \"beam\", formulation = \"linked\"",
    "kind = \"beam\", formulation = \"quadratic\"",
    "kind = \"cable\"",
];

/// 72 rad/s: 58 and 29 steps a turn, with stretches by centrifugal forces and longitudinal waves that no step resolves.
#[test]
fn beams_and_cables_conserve_energy_and_momenta() {
    for kind in FORMULATIONS {
        for step in [1.5e-3, 3e-3] {
            let model = shaft(kind, "", step, ENERGY);
            let run = Run::of(&model);
            let (energy, momenta) = (energy_change(&run), changes_of_momenta(&model));
            assert!(run.largest("strain") > 1e-5 * run.largest("kinetic"), "{kind}: unstrained");
            assert!(energy < 1e-11, "{kind}, {step}: energy {energy:e}");
            assert!(momenta[0] < 1e-11 && momenta[1] < 1e-11, "{kind}, {step}: momenta {momenta:?}");
        }
    }
    let rubber = shaft(FORMULATIONS[0], ", poisson = 0.4, law = \"neo_hookean\"", 1e-3, ENERGY);
    let (energy, momenta) = (energy_change(&Run::of(&rubber)), changes_of_momenta(&rubber));
    assert!(energy < 1e-10, "energy {energy:e}");
    assert!(momenta[0] < 1e-11 && momenta[1] < 1e-10, "momenta {momenta:?}");
}

/// χ > 0 only removes energy, and changes no momentum.
#[test]
fn numerical_damping_removes_energy_only() {
    for kind in FORMULATIONS {
        let model =
            shaft(kind, "", 1.5e-3, "scheme = { energy_damping = 0.01 }\nenergy_guard = { loss = 1 }");
        let run = Run::of(&model);
        let total: Vec<f64> =
            run.column("kinetic").iter().zip(run.column("strain")).map(|(a, b)| a + b).collect();
        let rises = total.windows(2).all(|pair| pair[1] <= pair[0] * (1.0 + 1e-13));
        assert!(rises && total[40] < total[0] * (1.0 - 1e-7), "{kind}: {} {}", total[0], total[40]);
        let momenta = changes_of_momenta(&model);
        assert!(momenta[0] < 1e-11 && momenta[1] < 1e-11, "{kind}: momenta {momenta:?}");
    }
}

/// Masses on springs and a rope that becomes slack and tight.
#[test]
fn springs_and_ropes_conserve_energy_and_momenta() {
    let parts = "bodies = [{ kind = \"mass\", name = \"a\", center = [0, 0, 0], mass = 1, motion = { velocity = [1, 8, 0] } },\n\
                 { kind = \"mass\", name = \"b\", center = [1, 0, 0], mass = 2, motion = { velocity = [0, -4, 1] } },\n\
                 { kind = \"mass\", name = \"c\", center = [1, 1, 0], mass = 1.5, motion = { velocity = [0, 0, -2] } }]\n\
                 joints = [{ kind = \"spring\", name = \"s\", a = { body = \"a\", at = \"center\" }, b = { body = \"b\", at = \"center\" }, \
                 stiffness = 900, length = 0.8 },\n\
                 { kind = \"spring\", name = \"r\", a = { body = \"b\", at = \"center\" }, b = { body = \"c\", at = \"center\" }, \
                 stiffness = 500, length = 1.05, tension_only = true }]";
    let model = with_analysis(parts, 4.0, 0.02, ENERGY);
    let run = Run::of(&model);
    let (energy, momenta) = (energy_change(&run), changes_of_momenta(&model));
    assert!(energy < 1e-10, "energy {energy:e}");
    assert!(momenta[0] < 1e-11 && momenta[1] < 1e-11, "{momenta:?}");
}

/// Joints without work: hinges of rigid bodies, joints on sections with frames, springs of angles, a bushing and a slider.
fn mechanisms() -> [(&'static str, String, f64); 5] {
    let materials = "gravity = [0, -9.81, 0]\nmaterials.m = { density = 1000, young = 1e8 }\n\
                     sections.s = { kind = \"rectangle\", width = 0.03, height = 0.05 }\n";
    let arm = "{ kind = \"beam\", formulation = \"linked\", name = \"arm\", from = [0, 0, 0], to = [0.6, 0, 0], elements = 2, \
               section = \"s\", material = \"m\" }";
    let bob = "{ kind = \"rigid\", name = \"bob\", center = [0.8, 0, 0], mass = 0.6, inertia = [0.004, 0.01, 0.01] }";
    let beam = |joints: &str| format!("{materials}bodies = [{arm}, {bob}]\njoints = [{joints}]");
    let root =
        "{ kind = \"revolute\", name = \"root\", a = { body = \"arm\", at = \"start\" }, axis = [0, 0, 1] }";
    let sprung = "{ kind = \"revolute\", name = \"root\", a = { body = \"arm\", at = \"start\" }, axis = [0, 0, 1], \
                  spring = { stiffness = 5 } }";
    let on = "b = { body = \"arm\", at = \"end\" }";
    [
        (
            "double pendulum",
            "gravity = [0, -9.81, 0]\nbodies = [{ kind = \"rigid\", name = \"a\", center = [0.5, 0, 0], mass = 2, inertia = [0.01, 0.2, 0.2] },\n\
             { kind = \"rigid\", name = \"b\", center = [1.5, 0, 0], mass = 1, inertia = [0.01, 0.1, 0.1] }]\n\
             joints = [{ kind = \"revolute\", name = \"p\", a = { body = \"a\", at = [0, 0, 0] }, axis = [0, 0, 1] },\n\
             { kind = \"revolute\", name = \"q\", a = { body = \"b\", at = [1, 0, 0] }, b = { body = \"a\", at = [1, 0, 0] }, axis = [0, 0.3, 1], \
             spring = { stiffness = 3 } }]"
                .into(),
            0.03,
        ),
        (
            "hinges on a beam",
            beam(&format!(
                "{root}, {{ kind = \"revolute\", name = \"knee\", a = {{ body = \"bob\", at = [0.6, 0, 0] }}, {on}, axis = [0, 0.2, 1] }}"
            )),
            5e-3,
        ),
        (
            "bushing",
            beam(&format!(
                "{root}, {{ kind = \"bushing\", name = \"knee\", a = {{ body = \"bob\", at = [0.6, 0, 0] }}, {on}, \
                 stiffness = [3e3, 4e3, 5e3, 8, 5, 6] }}"
            )),
            4e-3,
        ),
        (
            "springs of angles",
            beam(&format!("{sprung}, {{ kind = \"spherical\", name = \"knee\", a = {{ body = \"bob\", at = [0.6, 0, 0] }}, {on} }}")),
            5e-3,
        ),
        (
            "slider",
            format!(
                "{materials}bodies = [{arm}, {{ kind = \"mass\", name = \"bead\", center = [0.25, 0, 0], mass = 0.3 }}]\n\
                 joints = [{root}, {{ kind = \"slide\", name = \"knee\", a = {{ body = \"bead\", at = \"center\" }}, b = {{ body = \"arm\", at = 0.25 }}, \
                 spring = {{ stiffness = 100 }} }}]"
            ),
            2e-3,
        ),
    ]
}

#[test]
fn joints_without_work_conserve_energy() {
    for (name, parts, step) in mechanisms() {
        let run = Run::of(&with_analysis(&parts, 120.0 * step, step, ENERGY));
        let (energy, iterations) = (energy_change(&run), run.summary.iterations as f64 / 120.0);
        let tolerance = if name == "slider" { 1e-6 } else { 1e-10 };
        assert!(energy < tolerance, "{name}: {energy:e}");
        assert!(iterations < 16.0, "{name}: {iterations} iterations a step");
        assert!(run.summary.warnings.is_empty(), "{name}: {:?}", run.summary.warnings);
    }
}

/// Dampers, damping of the material and drag of the medium remove exactly the recorded energy.
#[test]
fn dissipation_is_the_removed_energy() {
    for kind in FORMULATIONS {
        let model = shaft(kind, ", damping = { strain = 1e-3, mass = 2 }", 1.5e-3, ENERGY);
        let run = Run::of(&model);
        let size = run.largest("kinetic");
        assert!(run.last("dissipated") > 0.02 * size, "{kind}: {}", run.last("dissipated"));
        assert!(run.largest("balance") < 1e-11 * size, "{kind}: {:e}", run.largest("balance"));
    }
}

/// A prescribed rotation supplies work: the balance is of second order in the step.
#[test]
fn drives_supply_their_work() {
    let errors = [0.02, 0.01].map(|step| {
        let parts = "bodies = [{ kind = \"rigid\", name = \"arm\", center = [1, 0, 0], mass = 2, inertia = [1, 2, 3] }]\n\
                     joints = [{ kind = \"revolute\", name = \"motor\", a = { body = \"arm\", at = [0, 0, 0] }, axis = [0, 0, 1], \
                     drive = { angle = 3, time = { kind = \"sine\", frequency = 0.5 } } }]";
        let run = Run::of(&with_analysis(parts, 1.0, step, ENERGY));
        run.largest("balance") / run.largest("kinetic")
    });
    assert!(errors[0] < 2e-3 && errors[1] < 0.3 * errors[0], "{errors:?}");
}

/// A steep tolerance on iterations divides steps: energy is conserved all the same.
#[test]
fn divided_steps_conserve_energy() {
    let run = Run::of(&tumbling(16.0, 3.0, "scheme = \"energy\"\nmax_iterations = 9"));
    assert!(run.summary.divided_steps > 0 && energy_change(&run) < 1e-11);
}

fn summary_of(keys: &str) -> Summary {
    Run::of(&tumbling(31.0, 3.0, keys)).summary
}

/// Few iterations with approximate tangents, also with a new one in each iteration and with an absolute rule.
#[test]
fn iterations_are_few() {
    for keys in ["", "newton = \"full\"\n", "stop = { rule = \"increment\", tolerance = 1e-12 }\n"] {
        let Summary { iterations, steps, .. } = summary_of(&format!("{keys}{ENERGY}"));
        assert!(iterations < 12 * steps, "{keys}: {iterations} iterations in {steps} steps");
    }
}

/// Units of the solution do not matter.
#[test]
fn motions_do_not_depend_on_units() {
    let (_, parts, step) = &mechanisms()[1];
    let run = |scales: &str| {
        let probes = "probes = [{ name = \"tip\", on = { body = \"bob\", at = \"center\" } }]";
        Run::of(&with_analysis(&format!("{scales}\n{probes}\n{parts}"), 60.0 * step, *step, ENERGY))
    };
    let [plain, other] = [
        "scales = { kind = \"none\" }",
        "scales = { kind = \"given\", length = 0.01, force = 3, time = 0.5 }",
    ]
    .map(run);
    let apart = (plain.last_vector("tip.") - other.last_vector("tip.")).norm();
    assert!(apart < 1e-6, "{apart:e}");
    assert!(energy_change(&other) < 1e-10);
}

/// A strip that bounces on a plane conserves its energy.
#[test]
fn contacts_without_damping_conserve_energy() {
    let parts = "gravity = [0, 0, -9.81]\nmaterials.m = { density = 1000, young = 2e7 }\nsections.s = { kind = \"circle\", diameter = 0.02 }\n\
                 bodies = [{ kind = \"cable\", name = \"c\", from = [0, 0, 0.03], to = [0.3, 0, 0.05], elements = 3, section = \"s\", material = \"m\" }]\n\
                 contacts = [{ with = { kind = \"plane\", point = [0, 0, 0], normal = [0, 0, 1] }, stiffness = 1e5 }]";
    let run = Run::of(&with_analysis(parts, 0.2, 1e-3, ENERGY));
    let energy = energy_change(&run);
    assert!(run.largest("strain") > 0.05 * run.largest("kinetic"), "no contact");
    assert!(energy < 1e-9, "{energy:e}");
}

/// Steps by error control change, which this scheme does not damp.
#[test]
fn steps_by_error_control_are_rejected() {
    let model = Model::parse(
        "bodies = [{ kind = \"mass\", name = \"a\", center = [0, 0, 0], mass = 1 }]\n\
         analysis = { kind = \"dynamics\", duration = 1, step = { tolerance = 1e-4 }, scheme = \"energy\" }",
    );
    let text = model.unwrap_err().to_string();
    assert!(text.contains("analysis.scheme") && text.contains("does not damp"), "{text}");
}

/// Forces and accelerations in a row are those of the middle of the step: an inertial sensor on a body that spins steadily reads the
/// centripetal acceleration along the arm, and the section forces at a free end vanish with the square of the step.
#[test]
fn forces_of_rows_are_of_second_order() {
    let spinning = |steps: f64| {
        let text = format!(
            "bodies = [{{ kind = \"rigid\", name = \"arm\", center = [0, 0, 0], mass = 1, inertia = [0.1, 0.2, 0.25], \
             motion = {{ spin = [0, 0, 10] }} }}]\n\
             joints = [{{ kind = \"revolute\", name = \"h\", a = {{ body = \"arm\", at = \"center\" }}, axis = [0, 0, 1] }}]\n\
             probes = [{{ name = \"p\", on = {{ body = \"arm\", at = [0.5, 0, 0] }}, record = [\"inertial_sensor\"] }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.6, step = {}, scheme = \"energy\" }}\n",
            TAU / 10.0 / steps
        );
        let mut series = Series::new();
        assert!(simulate(&parse(&text), &mut series).unwrap().outcome.is_finished());
        ["p.imu_ax", "p.imu_ay"].map(|name| series.column(name).unwrap()[5])
    };
    let [[_, across], [coarse, _], [fine, _]] = [spinning(40.0), spinning(20.0), spinning(40.0)];
    assert!(across.abs() < 1e-9, "{across}");
    let ratio = (coarse + 50.0) / (fine + 50.0);
    assert!((ratio - 4.0).abs() < 0.2 && (fine + 50.0).abs() < 0.5, "{coarse} {fine}");
    let driven = |step: f64| {
        let text = format!(
            "gravity = [1, 2, -3]\nmaterials.s = {{ density = 7850, young = 2e9, poisson = 0.3, damping = {{ strain = 5e-3 }} }}\n\
             sections.r = {{ kind = \"rectangle\", height = 0.02, width = 0.01 }}\n\
             bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 3, section = \"r\", material = \"s\" }}]\n\
             joints = [{{ kind = \"drive\", name = \"w\", a = {{ body = \"b\", at = \"start\" }}, axis = [0, 1, 1], angle = 1, \
             time = {{ kind = \"expression\", text = \"sin(20*t)^2\" }} }}]\n\
             probes = [{{ name = \"p\", on = {{ body = \"b\", at = \"end\" }}, record = [\"section_forces\"] }}]\n\
             analysis = {{ kind = \"dynamics\", duration = 0.04, step = {step}, scheme = \"energy\" }}\n"
        );
        let mut series = Series::new();
        assert!(simulate(&parse(&text), &mut series).unwrap().outcome.is_finished());
        ["p.N", "p.Qy", "p.Qz"].map(|name| *series.column(name).unwrap().last().unwrap())
    };
    let [coarse, fine] = [driven(5e-4), driven(2.5e-4)];
    for (coarse, fine) in coarse.iter().zip(fine) {
        assert!((coarse / fine - 4.0).abs() < 0.5, "{coarse} {fine}");
    }
    assert!(fine[1].abs() < 1e-3 && fine[2].abs() < 1e-3, "{fine:?}");
}
