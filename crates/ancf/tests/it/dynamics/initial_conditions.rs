//! Initial conditions: velocities of rigid-body motions, closed gaps.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model::{
    Analysis, At, Beam, Body, Clamp, End, Ground, InitialMotion, Joint, NamedPosition, Place, Probe, Start,
    Statics,
};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper, consistent_velocities};
use ancf::solver::equations::{EquationsOfMotion, State};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

use crate::common::models::rod;
use crate::common::solutions::{Run, distance, momenta};

const VELOCITY: [f64; 3] = [1.0, -2.0, 0.5];
const SPIN: [f64; 3] = [0.7, 3.0, -4.0];

fn moving(mut model: Model, motion: InitialMotion) -> Model {
    rod::beam(&mut model).motion = motion;
    rod::settings(&mut model).duration = 0.1;
    model
}

fn weightless(model: Model) -> Model {
    Model { gravity: [0.0; 3], ..model }
}

/// Linear and angular momentum about the origin.
fn momenta_of(assembly: &Assembly, s: &State) -> [Vector3<f64>; 2] {
    momenta(assembly, s, &s.v)
}

/// Momenta of a free rod with initial velocity and spin: exact at the start, conserved in the motion.
#[test]
fn free_rod_conserves_its_momenta() {
    let motion = InitialMotion { velocity: VELOCITY, spin: SPIN, about: Some([0.5, 0.0, 0.0]), axial: 0.0 };
    let assembly = weightless(moving(rod::free(4), motion)).assemble().unwrap();
    let model = weightless(moving(rod::free(4), motion));
    let start = assembly.start(&model);
    let [linear, angular] = momenta_of(&assembly, &start);
    let area = std::f64::consts::PI * 0.01_f64.powi(2);
    let mass = 8030.0 * area * rod::LENGTH;
    assert!((linear - Vector3::from(VELOCITY) * mass).norm() < 1e-12 * linear.norm());
    let across = mass * (rod::LENGTH.powi(2) / 12.0 + 0.01_f64.powi(2) / 4.0);
    let along = mass * 0.01_f64.powi(2) / 2.0;
    let centre = Vector3::new(0.5, 0.0, 0.0);
    let own = Vector3::new(along * SPIN[0], across * SPIN[1], across * SPIN[2]);
    let expected = own + centre.cross(&(Vector3::from(VELOCITY) * mass));
    assert!((angular - expected).norm() < 1e-12 * expected.norm(), "{angular} {expected}");
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
    let mut dynamics =
        TimeStepper::new(&assembly.system, SchemeCoefficients::AVERAGE_ACCELERATION, newton, 0, start);
    dynamics.restart(0.0).unwrap();
    for step in 1..=50 {
        dynamics.advance(1e-3 * f64::from(step)).unwrap();
        let [p, _] = momenta_of(&assembly, dynamics.state());
        assert!((p - linear).norm() < 1e-9 * linear.norm(), "{}", (p - linear).norm() / linear.norm());
    }
    let [_, turned] = momenta_of(&assembly, dynamics.state());
    assert!(
        (turned - angular).norm() < 1e-3 * angular.norm(),
        "{}",
        (turned - angular).norm() / angular.norm()
    );
}

/// Exact translation without spin; parabola under gravity.
#[test]
fn thrown_rod_follows_the_parabola() {
    for start in [Start::Consistent, Start::Zero] {
        let motion = InitialMotion { velocity: VELOCITY, ..InitialMotion::default() };
        let mut model = moving(rod::free(3), motion);
        rod::settings(&mut model).scheme = ancf::model::Scheme::AverageAcceleration;
        rod::settings(&mut model).start = start;
        if start == Start::Zero {
            model.gravity = [0.0; 3];
        }
        let run = Run::of(&model);
        let g = Vector3::from(model.gravity);
        let expected = run
            .column("t")
            .iter()
            .map(|&t| Vector3::new(rod::LENGTH, 0.0, 0.0) + Vector3::from(VELOCITY) * t + g * (0.5 * t * t));
        assert!(distance(&run.vectors("tip."), &expected.collect::<Vec<_>>()) < 1e-9, "{start:?}");
    }
}

/// Rod on a spherical joint with a translational velocity: the impulse stops the joint and has no moment about it.
///
/// The lost kinetic energy is that of the velocity change (Carnot's theorem).
#[test]
fn impulse_at_a_joint_obeys_carnots_theorem() {
    let motion = InitialMotion { velocity: [0.0, 2.0, 1.0], ..InitialMotion::default() };
    let model = weightless(moving(rod::spherical(4), motion));
    let assembly = model.assemble().unwrap();
    let start = assembly.start(&model);
    let mut s = start.clone();
    consistent_velocities(&assembly.system, &mut assembly.system.matrix(), &mut s).unwrap();
    assert!(assembly.mesh("rod").unwrap().point(0.0).sum(&s.v).norm() < 1e-14);
    let [before, after] = [&start, &s].map(|s| momenta_of(&assembly, s)[1]);
    assert!((after - before).norm() < 1e-12 * before.norm());
    let change = s.v.iter().zip(&start.v).map(|(after, before)| after - before).collect();
    let kinetic = |s: &State| assembly.system.energy(s).kinetic;
    let lost = kinetic(&State { v: change, ..s.clone() });
    assert!((kinetic(&start) - kinetic(&s) - lost).abs() < 1e-12 * kinetic(&start));
    let reported = model.diagnose().unwrap().projection.unwrap();
    assert!((reported - lost / kinetic(&start)).abs() < 1e-12 && reported > 0.01, "{reported}");
    let free = weightless(moving(rod::free(4), motion)).diagnose().unwrap();
    assert_eq!(free.projection, Some(0.0));
    assert!(!free.warnings.iter().any(|warning| warning.contains("velocities")), "{:?}", free.warnings);
}

/// Consistent velocities are unchanged.
#[test]
fn consistent_velocities_are_unchanged() {
    let motion = InitialMotion { spin: [0.0, 0.0, 3.0], ..InitialMotion::default() };
    let model = weightless(moving(rod::revolute(4), motion));
    assert!(model.diagnose().unwrap().projection.unwrap() < 1e-24);
}

/// Clamped rod of linked elements along x whose end is attached to a point of the ground.
fn with_gap(to: [f64; 3]) -> Model {
    let mut model = weightless(rod::clamped(4, ancf::model::ClampedGradients::Section));
    let beam = rod::beam(&mut model);
    beam.formulation = ancf::model::Formulation::Linked;
    let b = End::Point(Ground { point: to });
    model.joints.push(Joint::spherical("far", rod::end(), b));
    Model { assemble: true, ..model }
}

/// Closing a lateral gap δ at the end of a cantilever stores the energy of the stiffness 3EI/L³; the state is at rest.
#[test]
fn closed_gap_of_a_cantilever_is_at_rest() {
    let delta = 1e-3;
    let mut model = with_gap([rod::LENGTH, delta, 0.0]);
    let assembly = model.assemble().unwrap();
    let closed = assembly.closed().unwrap();
    assert_eq!((closed.gaps.len(), &*closed.gaps[0].0), (1, "far"));
    assert!((closed.gaps[0].1 - delta).abs() < 1e-15);
    let bending = 193e9 * std::f64::consts::PI * 0.01_f64.powi(4) / 4.0;
    let initial = assembly.initial();
    let tip = assembly.probes[0].1.value(&initial);
    assert!((tip - Vector3::new(rod::LENGTH, delta, 0.0)).norm() < 1e-12, "{tip}");
    // The axis is stretched by 0.6 δ²/L, and its tension N makes the rod stiffer by 1.2 N/L.
    let (stretch, axial) = (0.6 * delta * delta, 193e9 * std::f64::consts::PI * 1e-4);
    let expected = 0.5 * 3.0 * bending * delta * delta + 0.5 * axial * stretch * stretch;
    let energy = assembly.system.energy(&initial).strain;
    assert!((energy - expected).abs() < 2e-3 * expected, "{energy} instead of {expected}");
    let expected = 3.0 * bending * delta + 1.2 * axial * stretch * delta;
    for start in [Start::Consistent, Start::Zero] {
        rod::settings(&mut model).start = start;
        rod::settings(&mut model).duration = 0.05;
        let run = Run::of(&model);
        let kinetic = run.largest("kinetic");
        assert!(kinetic < 1e-9 * energy, "{start:?}: {kinetic} of {energy}");
        let force = run.last_vector("far.f").y;
        assert!((force - expected).abs() < 2e-3 * expected, "{force} instead of {expected}");
    }
}

/// A loose body is moved to close the gap without strain; clamped bodies stay.
#[test]
fn loose_bodies_are_moved_without_strain() {
    let mut model = rod::cantilever(2);
    let (from, to) = ([1.0, 0.03, 0.0], [1.4, 0.03, 0.3]);
    let second = Beam { name: "second".into(), from, to, ..rod::beam(&mut model).clone() };
    model.bodies.push(Body::Beam(second));
    let a = Place::new("second", At::Named(NamedPosition::Start));
    model.joints.push(Joint::spherical("elbow", a, End::Place(rod::end())));
    let refused = model.check().unwrap_err();
    assert!(refused[0].hint.as_ref().unwrap().ends_with("; `assemble = true` closes the gap"), "{refused}");
    model.assemble = true;
    let diagnosis = model.diagnose().unwrap();
    assert_eq!(diagnosis.gaps.len(), 1);
    assert!((diagnosis.gaps[0].1 - 0.03).abs() < 1e-12);
    assert_eq!(diagnosis.moved.len(), 1, "{:?}", diagnosis.moved);
    assert!(diagnosis.moved[0].0 == "second" && (0.025..0.035).contains(&diagnosis.moved[0].1));
    let assembly = model.assemble().unwrap();
    let initial = assembly.initial();
    let [end, start] = [("rod", 1.0), ("second", 0.0)]
        .map(|(body, s)| assembly.mesh(body).unwrap().point(s).value(&initial));
    assert!((end - start).norm() < 1e-12);
    // Compared with the energy of bending the clamped rod by the gap.
    let bent = 0.5 * 3.0 * 193e9 * std::f64::consts::PI * 0.01_f64.powi(4) / 4.0 * 0.03_f64.powi(2);
    let strain = assembly.system.energy(&initial).strain;
    assert!(strain < 1e-9 * bent, "{strain} of {bent}");
}

/// Gaps of assembled joints are closed at the start; points of the ground are approached by the load factor.
#[test]
fn statics_starts_with_closed_gaps() {
    let mut model = with_gap([rod::LENGTH, 0.01, 0.0]);
    let a = Place::new("rod", At::Length(0.5));
    let hanger = Beam {
        name: "hanger".into(),
        from: [0.5, 0.002, 0.0],
        to: [0.5, 0.402, 0.0],
        ..rod::beam(&mut model).clone()
    };
    model.bodies.push(Body::Beam(hanger));
    let hanger = Place::new("hanger", At::Named(NamedPosition::Start));
    model.joints.push(Joint::Clamp(Clamp { name: "hang".into(), a: hanger, b: End::Place(a), fix: None }));
    model.analysis = Analysis::Statics(Statics::default());
    model.probes.push(Probe::of_motion("foot", Place::new("hanger", At::Named(NamedPosition::Start))));
    model.probes.push(Probe::of_motion("middle", Place::new("rod", At::Length(0.5))));
    let run = Run::of(&model);
    assert!(distance(&run.vectors("foot."), &run.vectors("middle.")) < 1e-12);
    let tip = run.vectors("tip.");
    assert!((tip[0] - Vector3::new(1.0, 0.0, 0.0)).norm() < 1e-12);
    assert!((tip.last().unwrap() - Vector3::new(1.0, 0.01, 0.0)).norm() < 1e-12);
}

/// Initial velocities of slopes do not depend on slope coordinates and scales.
#[test]
fn initial_velocities_do_not_depend_on_scales() {
    let motion = InitialMotion { velocity: VELOCITY, spin: SPIN, about: Some([0.2, 0.3, -0.1]), axial: 0.0 };
    let model = moving(rod::free(3), motion);
    let mut other = model.clone();
    other.scales = ancf::model::ScaleChoice::Given { length: 0.25, force: 8.0, time: Some(0.125) };
    rod::beam(&mut other).slopes = ancf::model::Slopes::Length;
    let (a, b) = (Run::of(&model), Run::of(&other));
    assert!(distance(&a.vectors("tip."), &b.vectors("tip.")) < 1e-9);
    let v = a.vectors("tip.v")[0];
    let expected = Vector3::from(VELOCITY) + Vector3::from(SPIN).cross(&Vector3::new(0.8, -0.3, 0.1));
    assert!((v - expected).norm() < 1e-12 * expected.norm(), "{v} {expected}");
}

/// Momentum of a straight rod that moves along its axis, in every formulation.
#[test]
fn axial_motion_of_a_straight_rod_is_a_translation() {
    for formulation in crate::common::models::beams::FORMULATIONS {
        let mut model = moving(rod::free(3), InitialMotion { axial: 2.5, ..InitialMotion::default() });
        rod::beam(&mut model).formulation = formulation;
        let assembly = weightless(model.clone()).assemble().unwrap();
        let [axial, translation] = [
            assembly.start(&model),
            assembly.start(&moving(
                model,
                InitialMotion { velocity: [2.5, 0.0, 0.0], ..InitialMotion::default() },
            )),
        ];
        for (a, b) in axial.v.iter().zip(&translation.v) {
            assert!((a - b).abs() < 1e-12, "{formulation:?}: {a} {b}");
        }
    }
}

/// The motion of a circular arc along its axis is the rotation about its centre. The difference is of second order in the length of
/// the elements.
#[test]
fn axial_motion_of_an_arc_is_a_rotation() {
    let (radius, spin) = (0.5, 3.0);
    let end = |angle: f64| [radius * angle.sin(), radius * (1.0 - angle.cos()), 0.0];
    for formulation in crate::common::models::beams::FORMULATIONS {
        let difference = |elements: u32| {
            let arc = |motion: InitialMotion| {
                let mut model = moving(rod::free(elements), motion);
                let beam = rod::beam(&mut model);
                (beam.to, beam.formulation) = (end(1.4), formulation);
                beam.shape = ancf::model::Shape::Arc { through: end(0.7) };
                model
            };
            let along = arc(InitialMotion { axial: radius * spin, ..InitialMotion::default() });
            let about = Some([0.0, radius, 0.0]);
            let around = arc(InitialMotion { spin: [0.0, 0.0, spin], about, ..InitialMotion::default() });
            let assembly = along.assemble().unwrap();
            let [a, b] = [assembly.start(&along), assembly.start(&around)];
            let largest = b.v.iter().fold(0.0_f64, |largest, v| largest.max(v.abs()));
            a.v.iter().zip(&b.v).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
        };
        let [coarse, fine] = [6, 24].map(difference);
        assert!(coarse < 0.05 && fine < coarse / 8.0, "{formulation:?}: {coarse:e} {fine:e}");
    }
}
