//! Mechanisms, rotor, robot arm, spring and blade.

use std::f64::consts::PI;

use ancf::Model;
use ancf::model::{Analysis, Body, Scheme, Step};
use nalgebra::{Matrix3, Vector3};

use crate::common::assertions::assert_near;
use crate::common::models::files::model;
use crate::common::solutions::{Run, distance};

/// Reads `models/{name}.toml` with another spectral radius, step and duration.
fn stepped(name: &str, radius: f64, step: f64, duration: f64) -> Model {
    let mut model = model(name);
    let Analysis::Dynamics(analysis) = &mut model.analysis else { panic!("{name} is a dynamic analysis") };
    analysis.scheme = Scheme::GeneralizedAlpha { spectral_radius: radius };
    analysis.step = Step::Fixed(step);
    analysis.duration = duration;
    model
}

/// Index of the row at a time.
fn row(run: &Run, t: f64) -> usize {
    let found = run.column("t").iter().position(|&at| (at - t).abs() < 1e-9);
    found.unwrap_or_else(|| panic!("no row at {t}"))
}

/// Deflection of the middle of the rod from its chord, in m.
fn deflections(run: &Run) -> Vec<f64> {
    let [pin, middle, block] = ["pin.", "middle.", "block."].map(|name| run.vectors(name));
    let deflection = |i: usize| {
        let chord = (block[i] - pin[i]).normalize();
        chord.cross(&(middle[i] - pin[i])).z
    };
    (0..pin.len()).map(deflection).collect()
}

/// Deflection of the middle of the rod and position of the block, in m, every 5 ms.
///
/// Source: Simeon's equations (crank of the test set of initial value problems: two sine shapes of bending, two shapes of
/// stretch), by the Runge-Kutta method with steps of 5e-6 s. Two changes: the mass matrix of stretch is divided by 15, a
/// misprint there; the strain energy contains ½ EA ∫ (w'²/2)² dx on the shapes of stretch. Without this term of fourth
/// degree the deflections are 1.87, 1.04, 0.45, ... mm.
const SIMEON: [[f64; 2]; 10] = [
    [1.4034e-3, 0.3917791],
    [0.6974e-3, 0.2706420],
    [0.1188e-3, 0.1821285],
    [-0.0874e-3, 0.1507359],
    [-0.3221e-3, 0.1643854],
    [-0.6203e-3, 0.2300986],
    [-1.6231e-3, 0.3477106],
    [-0.9792e-3, 0.4410953],
    [0.8832e-3, 0.4262489],
    [0.9801e-3, 0.3169483],
];

#[test]
fn slider_crank_rod_bends_as_in_simeons_equations() {
    let run = Run::of(&model("slider_crank"));
    let (deflections, block) = (deflections(&run), run.column("block.x"));
    for (i, [deflection, place]) in SIMEON.into_iter().enumerate() {
        let row = row(&run, 5e-3 * (i + 1) as f64);
        assert_near("deflection", deflections[row], deflection, 0.02 * 1.87e-3);
        assert_near("block", block[row], place, 4e-5);
    }
    assert!(run.largest("block.y") < 1e-12 && run.largest("middle.z") < 1e-12);
    for (&t, angle) in run.column("t").iter().zip(run.column("motor.angle")) {
        assert_near("angle of the crank", *angle, 150.0 * t, 1e-10);
    }
}

#[test]
fn slider_crank_satisfies_the_energy_balance() {
    let run = Run::of(&stepped("slider_crank", 0.95, 2.5e-6, 0.01));
    assert!(run.energy_error() < 1e-6, "{}", run.energy_error());
}

/// Flexibility of a grillage bar for forces along z and moments about x and y at a point c, by Castigliano.
fn flexibility([from, to]: [Vector3<f64>; 2], side: f64, c: Vector3<f64>) -> Matrix3<f64> {
    let (young, shear, length) = (2.07e11, 2.07e11 / 2.6, (to - from).norm());
    let (bending, torsion) = (young * side.powi(4) / 12.0, shear * 0.140577 * side.powi(4));
    let along = (to - from) / length;
    let across = Vector3::z().cross(&along);
    let mut sum = Matrix3::zeros();
    for (s, weight) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
        let arm = (c - from - along * (s * length)).cross(&Vector3::z());
        let by = |axis: Vector3<f64>| Vector3::new(arm.dot(&axis), axis.x, axis.y);
        let (twist, bend) = (by(along), by(across));
        sum += (twist * twist.transpose() / torsion + bend * bend.transpose() / bending) * (weight * length);
    }
    sum[(0, 0)] += length / (shear * side * side * 5.0 / 6.0);
    sum
}

/// Out of its plane the linkage is a grillage clamped at A and D. The hinge at C, misaligned by 5°, prescribes a relative
/// rotation of 2 sin(θ/2) 5° about an axis in the plane.
#[test]
fn misaligned_hinge_bends_the_four_bar_out_of_its_plane() {
    let run = Run::of(&model("four_bar"));
    for theta in [0.54_f64, 1.02] {
        let row = row(&run, theta / 0.6 + 0.1);
        let b = Vector3::new(-theta.sin(), theta.cos(), 0.0) * 0.12;
        let d = Vector3::x() * 0.24;
        let c = b + d;
        let left = flexibility([Vector3::zeros(), b], 0.016, c) + flexibility([b, c], 0.016, c);
        let right = flexibility([d, c], 0.008, c);
        let misalignment = 5_f64.to_radians();
        let gap = Vector3::z().cross(&Vector3::new(theta.sin(), 1.0 - theta.cos(), 0.0)) * misalignment;
        // Action on the left part; the right part has the reaction.
        let action = -(left + right).try_inverse().unwrap() * Vector3::new(0.0, gap.x, gap.y);
        let rise = (left * action)[0];
        assert_near("rise of C", run.vectors("coupler_end.")[row].z, rise, 0.02 * rise.abs());
        let at_d = -Vector3::new(action[1], action[2], 0.0) - (c - d).cross(&(Vector3::z() * action[0]));
        let moment = run.vectors("D.m")[row];
        assert_near("moment at D", (moment + at_d).norm(), 0.0, 0.02 * at_d.norm());
        assert_near("force at D", run.column("D.fz")[row], action[0], 0.02 * at_d.norm() / 0.12);
    }
    let gap = distance(&run.vectors("coupler_end."), &run.vectors("rocker_end."));
    assert!(gap < 1e-10 * 0.24, "gap {gap} at C");
}

/// With parallel axes the linkage is a parallelogram without out-of-plane reactions.
#[test]
fn aligned_four_bar_is_a_parallelogram() {
    let mut model = stepped("four_bar", 0.6, 0.02, 2.0);
    for joint in &mut model.joints {
        if let ancf::model::Joint::Revolute(ancf::model::Revolute { axis, .. }) = joint {
            *axis = [0.0, 0.0, 1.0];
        }
    }
    let run = Run::of(&model);
    // After the decay of the initial vibration.
    for i in row(&run, 1.0)..run.column("t").len() {
        assert_near("angle of the rocker", run.column("D.angle")[i], run.column("A.angle")[i], 1e-8);
    }
    for column in ["coupler_end.z", "D.mx", "D.my", "D.fz"] {
        assert!(run.largest(column) < 1e-9, "{column}: {}", run.largest(column));
    }
}

/// The work of the motor equals the energy of the bars.
#[test]
fn four_bar_satisfies_the_energy_balance() {
    let run = Run::of(&stepped("four_bar", 0.9, 1e-3, 1.0));
    assert!(run.energy_error() < 1e-6, "{}", run.energy_error());
}

/// Mass of the disc, effective mass (Rayleigh) and stiffness of the shaft.
fn jeffcott() -> [f64; 3] {
    let (disc, radius) = (5.0, 0.01_f64);
    let shaft = 7850.0 * PI * radius.powi(2);
    [disc, disc + 17.0 / 35.0 * shaft, 48.0 * 2.1e11 * PI * radius.powi(4) / 4.0]
}

/// z = A (e^{iωt} − cos ω_c t − i (ω/ω_c) sin ω_c t), A = e' / ((ω_c/ω)² − 1), for an initially straight rotor.
#[test]
fn rotor_whirls_as_a_jeffcott_rotor() {
    let run = Run::of(&model("rotor"));
    let [disc, mass, stiffness] = jeffcott();
    let (critical, rate) = ((stiffness / mass).sqrt(), 75.0);
    assert_near("critical speed", critical, 113.0, 0.05);
    let amplitude = 0.0005 * disc / mass / ((critical / rate).powi(2) - 1.0);
    assert_near("amplitude", amplitude, 0.317e-3, 1e-6);
    let middle = run.vectors("middle.");
    for (&t, middle) in run.column("t").iter().zip(&middle) {
        let y = amplitude * ((rate * t).cos() - (critical * t).cos());
        let z = amplitude * ((rate * t).sin() - rate / critical * (critical * t).sin());
        assert_near("y", middle.y, y, 0.03 * amplitude);
        assert_near("z", middle.z, z, 0.03 * amplitude);
    }
    let largest = middle.iter().map(|r| r.y.hypot(r.z)).fold(0.0, f64::max);
    assert_near("largest deflection as stated", largest, 0.635e-3, 0.02e-3);
    assert!(distance(&middle, &run.vectors("seat_of_disc.")) < 1e-10);
    assert!(run.energy_error() < 1e-6, "{}", run.energy_error());
}

/// The lowest frequencies in both planes equal the critical speed.
#[test]
fn rotor_frequencies_equal_the_critical_speed() {
    let mut model = model("rotor");
    model.analysis = toml::from_str("kind = \"modes\"\ncount = 4").unwrap();
    let run = Run::of(&model);
    let [_, mass, stiffness] = jeffcott();
    let expected = (stiffness / mass).sqrt() / (2.0 * PI);
    let frequencies = run.column("frequency");
    let near = frequencies.iter().filter(|&&f| (f - expected).abs() < 0.003 * expected).count();
    assert_eq!(near, 2, "{frequencies:?}, not {expected}");
}

/// Masses of the links per length.
const LINKS: [f64; 2] =
    [2700.0 * PI / 4.0 * (0.04 * 0.04 - 0.036 * 0.036), 2700.0 * PI / 4.0 * (0.03 * 0.03 - 0.027 * 0.027)];
/// Mass of the payload.
const PAYLOAD: f64 = 3.0;

/// Angular momentum of rigid links about the shoulder, moment of the weight about the shoulder and about the elbow.
fn rigid_arm(t: f64) -> [f64; 3] {
    let s = (t / 2.0).clamp(0.0, 1.0);
    let (part, rate) = (s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s), 15.0 * (s * (1.0 - s)).powi(2));
    let (upper, lower) = (1.2 * part, 1.6 * part);
    // Position and velocity of the end of an arm at an angle from the vertical.
    let arm = |angle: f64, turned: f64, length: f64| {
        let (sin, cos) = angle.sin_cos();
        (Vector3::new(sin, -cos, 0.0) * length, Vector3::new(cos, sin, 0.0) * (length * turned * rate))
    };
    let (mut momentum, mut weight, mut at_elbow) = (0.0, 0.0, 0.0);
    let mut add = |(r, v): (Vector3<f64>, Vector3<f64>), mass: f64, elbow: f64| {
        momentum += mass * r.cross(&v).z;
        weight += 9.81 * mass * r.x;
        at_elbow += 9.81 * mass * (r.x - elbow);
    };
    let elbow = arm(upper, 1.2, 0.8);
    // Three point masses equivalent to a rod.
    for (at, part) in [(0.0, 1.0 / 6.0), (0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
        let r = arm(lower, 1.6, 0.7 * at);
        let r = (elbow.0 + r.0, elbow.1 + r.1);
        add(r, 0.7 * LINKS[1] * part + if at == 1.0 { PAYLOAD } else { 0.0 }, elbow.0.x);
    }
    for (at, part) in [(0.5, 4.0 / 6.0), (1.0, 1.0 / 6.0)] {
        let (r, v) = arm(upper, 1.2, 0.8 * at);
        add((r, v), 0.8 * LINKS[0] * part, r.x);
    }
    [momentum, weight, at_elbow]
}

#[test]
fn robot_arm_motors_carry_its_weight() {
    let run = Run::of(&model("robot_arm"));
    let [_, shoulder, elbow] = rigid_arm(3.5);
    assert_near("shoulder as stated", shoulder, 47.15, 0.01);
    assert_near("elbow as stated", elbow, 21.46, 0.01);
    assert_near("shoulder", run.last("shoulder.mz"), shoulder, 0.002 * shoulder);
    assert_near("elbow", run.last("elbow.mz"), elbow, 0.002 * elbow);
    // During the motion: torque of rigid links, within the vibration of the flexible ones.
    let (t, torque) = (run.column("t"), run.column("shoulder.mz"));
    let rigid = |t: f64| (rigid_arm(t + 1e-5)[0] - rigid_arm(t - 1e-5)[0]) / 2e-5 + rigid_arm(t)[1];
    let squares: f64 = t.iter().zip(torque).map(|(&t, torque)| (torque - rigid(t)).powi(2)).sum();
    let deviation = (squares / t.len() as f64).sqrt();
    assert!(deviation < 0.02 * run.largest("shoulder.mz"), "torques deviate by {deviation}");
    assert!(distance(&run.vectors("hand."), &run.vectors("payload_at.")) < 1e-10);
}

#[test]
fn robot_arm_satisfies_the_energy_balance() {
    let run = Run::of(&stepped("robot_arm", 1.0, 4e-4, 1.0));
    assert!(run.energy_error() < 1e-6, "{}", run.energy_error());
}

/// Stiffness of the spring and mass of its wire.
fn spring() -> [f64; 2] {
    let (wire, mean, turns, pitch): (f64, f64, f64, f64) = (0.004, 0.05, 6.0, 0.012);
    let length = turns * (PI * mean).hypot(pitch);
    [2.1e11 / 2.6 * wire.powi(4) / (8.0 * mean.powi(3) * turns), 7850.0 * PI / 4.0 * wire * wire * length]
}

#[test]
fn helical_spring_has_its_stiffness() {
    let run = Run::of(&model("spring"));
    let [stiffness, mass] = spring();
    assert_near("stiffness as stated", stiffness, 3446.0, 0.5);
    let deflection = 9.81 * (2.0 + mass / 2.0) / stiffness;
    assert_near("deflection as stated", deflection, 5.83e-3, 1e-5);
    assert_near("deflection", -0.072 - run.last("weight_at.z"), deflection, 0.005 * deflection);
    assert_near("force at the bottom", run.last("bottom.fz"), 2.0 * 9.81, 1e-6);
    assert_near("force at the top", run.last("top.fz"), (2.0 + mass) * 9.81, 1e-3 * 20.0);
    assert_near("lateral displacement", run.last("weight_at.x").hypot(run.last("weight_at.y")), 0.0, 1e-12);
}

/// f = √(k/(m + m'/3))/2π with the mass m' of the spring.
#[test]
fn weight_on_a_spring_has_its_natural_frequency() {
    let mut model = model("spring");
    model.analysis = toml::from_str("kind = \"modes\"\ncount = 3").unwrap();
    let run = Run::of(&model);
    let [stiffness, mass] = spring();
    let expected = (stiffness / (2.0 + mass / 3.0)).sqrt() / (2.0 * PI);
    assert_near("frequency", run.column("frequency")[0], expected, 0.01 * expected);
}

/// Comparison with hinged rigid rods of the same mass.
#[test]
fn stiff_double_pendulum_moves_as_rigid_rods() {
    let mut stiff = stepped("double_pendulum", 0.9, 2.5e-4, 0.6);
    for material in stiff.materials.values_mut() {
        material.young *= 100.0;
    }
    let mut rigid = stiff.clone();
    let (upper, lower) = (2700.0 * 0.004 * 0.02 * 0.6, 2700.0 * PI * 0.003 * 0.003 * 0.4);
    rigid.bodies = vec![
        bar("upper", [0.3, 0.0, 0.0], upper, [0.0, 0.6]),
        bar("lower", [0.6, -0.2, 0.0], lower, [0.4, 0.0]),
    ];
    let text = toml::to_string(&rigid).unwrap();
    let at = [
        ("upper", "start", "[0.0, 0.0, 0.0]"),
        ("upper", "end", "[0.6, 0.0, 0.0]"),
        ("lower", "start", "[0.6, 0.0, 0.0]"),
        ("lower", "end", "[0.6, -0.4, 0.0]"),
    ];
    let text = at.iter().fold(text, |text, (body, end, place)| {
        text.replace(
            &format!("body = \"{body}\"\nat = \"{end}\""),
            &format!("body = \"{body}\"\nat = {place}"),
        )
    });
    let (stiff, rigid) = (Run::of(&stiff), Run::of(&Model::parse(&text).unwrap()));
    for place in ["elbow_point.", "tip."] {
        let error = distance(&stiff.vectors(place), &rigid.vectors(place));
        assert!(error < 2e-4, "{place}: {error}");
    }
}

/// Thin rigid rod in the xy plane, with its lengths along y and x.
fn bar(name: &str, center: [f64; 3], mass: f64, [y, x]: [f64; 2]) -> Body {
    let [xx, yy] = [y, x].map(|length: f64| mass * length * length / 12.0);
    let text = format!(
        "kind = \"rigid\"\nname = \"{name}\"\ncenter = {center:?}\nmass = {mass}\ninertia = [{xx}, {yy}, {}]",
        xx + yy
    );
    toml::from_str(&text).unwrap()
}

#[test]
fn double_pendulum_satisfies_the_energy_balance() {
    let run = Run::of(&stepped("double_pendulum", 1.0, 5e-5, 0.4));
    assert!(run.energy_error() < 1e-6, "{}", run.energy_error());
}

#[test]
fn rotating_blade_has_its_centrifugal_force() {
    let run = Run::of(&model("blade"));
    let (area, length, rate) = (0.2 * 0.02, 5.0, 40.0_f64);
    let force = 2700.0 * area * (rate * length).powi(2) / 2.0;
    assert_near("force as stated", force, 216.0e3, 50.0);
    let stretch = 2700.0 * rate.powi(2) * length.powi(3) / (3.0 * 7e10);
    assert_near("stretch as stated", stretch, 2.571e-3, 1e-6);
    let steady: Vec<usize> = (0..run.column("t").len()).filter(|&i| run.column("t")[i] > 6.1).collect();
    let mean = |x: &dyn Fn(usize) -> f64| steady.iter().map(|&i| x(i)).sum::<f64>() / steady.len() as f64;
    let (hub, tip) = (run.vectors("hub.f"), run.vectors("tip."));
    assert_near("force", mean(&|i| hub[i].norm()), force, 0.003 * force);
    assert_near("stretch", mean(&|i| tip[i].norm()) - length, stretch, 0.01 * stretch);
    assert!(run.vectors("root.").iter().all(|root| root.norm() < 1e-10 * length));
}
