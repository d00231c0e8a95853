//! How motions start: with velocities of rigid bodies, and with gaps closed.

use ancf::Model;
use ancf::analysis::{Dynamics, Newton, Scheme, Stop, consistent_velocities};
use ancf::model::{
    Analysis, Assembly, At, Beam, Body, End, Ground, InitialMotion, Joint, Named, Place, Probe, Start,
    Statics,
};
use ancf::system::{EquationsOfMotion, State, Weights};
use nalgebra::Vector3;

use crate::common::models::rod;
use crate::common::solutions::{Run, distance};

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

/// ∑ M v and ∑ r × M v over the nodes: with g the coordinates of a translation, gᵀ M v.
fn momenta(assembly: &Assembly, s: &State) -> [Vector3<f64>; 2] {
    let (system, n) = (&assembly.system, s.q.len());
    let mut mass = system.matrix();
    system.tangent(s, Weights::MASS, &mut mass);
    let mut v = s.v.clone();
    v.resize(n + s.lambda.len(), 0.0);
    let p = mass.times(&v);
    let of = |vector: &ancf::mechanics::NodalVector| {
        Vector3::from_column_slice(&p[vector.first..vector.first + 3])
    };
    let vectors: Vec<_> = assembly.bodies().flat_map(|(_, mesh)| mesh.vectors(s)).collect();
    let linear = vectors.iter().filter(|vector| vector.is_position()).map(of).sum();
    [linear, vectors.iter().map(|vector| vector.value.cross(&of(vector))).sum()]
}

/// A free rod that flies and spins keeps its momenta, and its centre moves uniformly.
#[test]
fn a_free_rod_keeps_its_momenta() {
    let motion = InitialMotion { velocity: VELOCITY, spin: SPIN, about: Some([0.5, 0.0, 0.0]) };
    let assembly = weightless(moving(rod::free(4), motion)).assemble().unwrap();
    let model = weightless(moving(rod::free(4), motion));
    let start = assembly.start(&model);
    let [linear, angular] = momenta(&assembly, &start);
    let area = std::f64::consts::PI * 0.01_f64.powi(2);
    let mass = 8030.0 * area * rod::LENGTH;
    assert!((linear - Vector3::from(VELOCITY) * mass).norm() < 1e-12 * linear.norm());
    let across = mass * (rod::LENGTH.powi(2) / 12.0 + 0.01_f64.powi(2) / 4.0);
    let along = mass * 0.01_f64.powi(2) / 2.0;
    let centre = Vector3::new(0.5, 0.0, 0.0);
    let own = Vector3::new(along * SPIN[0], across * SPIN[1], across * SPIN[2]);
    let wanted = own + centre.cross(&(Vector3::from(VELOCITY) * mass));
    assert!((angular - wanted).norm() < 1e-12 * wanted.norm(), "{angular} {wanted}");
    let newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 50).unwrap();
    let mut dynamics = Dynamics::new(&assembly.system, Scheme::AVERAGE_ACCELERATION, newton, 0, start);
    dynamics.restart(0.0).unwrap();
    for step in 1..=50 {
        dynamics.advance(1e-3 * f64::from(step)).unwrap();
        let [p, _] = momenta(&assembly, dynamics.state());
        assert!((p - linear).norm() < 1e-9 * linear.norm(), "{}", (p - linear).norm() / linear.norm());
    }
    let [_, turned] = momenta(&assembly, dynamics.state());
    assert!(
        (turned - angular).norm() < 1e-3 * angular.norm(),
        "{}",
        (turned - angular).norm() / angular.norm()
    );
}

/// Without spin the motion is a translation, exactly; under gravity every point follows the parabola.
#[test]
fn a_thrown_rod_follows_the_parabola() {
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
        let wanted = run
            .column("t")
            .iter()
            .map(|&t| Vector3::new(rod::LENGTH, 0.0, 0.0) + Vector3::from(VELOCITY) * t + g * (0.5 * t * t));
        assert!(distance(&run.vectors("tip."), &wanted.collect::<Vec<_>>()) < 1e-9, "{start:?}");
    }
}

/// A rod on a ball that is given a translation: the impulse of the ball stops its point, has no moment about it, and takes away
/// what the change of the velocities has in kinetic energy, as Carnot's theorem says.
#[test]
fn a_pinned_rod_turns() {
    let motion = InitialMotion { velocity: [0.0, 2.0, 1.0], ..InitialMotion::default() };
    let model = weightless(moving(rod::spherical(4), motion));
    let assembly = model.assemble().unwrap();
    let start = assembly.start(&model);
    let mut s = start.clone();
    consistent_velocities(&assembly.system, &mut assembly.system.matrix(), &mut s).unwrap();
    assert!(assembly.mesh("rod").unwrap().point(0.0).sum(&s.v).norm() < 1e-14);
    let [before, after] = [&start, &s].map(|s| momenta(&assembly, s)[1]);
    assert!((after - before).norm() < 1e-12 * before.norm());
    let change = s.v.iter().zip(&start.v).map(|(after, before)| after - before).collect();
    let kinetic = |s: &State| assembly.system.energy(s).kinetic;
    let lost = kinetic(&State { v: change, ..s.clone() });
    assert!((kinetic(&start) - kinetic(&s) - lost).abs() < 1e-12 * kinetic(&start));
    let told = model.diagnose().unwrap().projection.unwrap();
    assert!((told - lost / kinetic(&start)).abs() < 1e-12 && told > 0.01, "{told}");
    let free = weightless(moving(rod::free(4), motion)).diagnose().unwrap();
    assert_eq!((free.projection, free.warnings().len()), (Some(0.0), 0));
}

/// A rod whose velocities agree with its hinge keeps them all.
#[test]
fn a_turning_rod_is_left_as_it_is() {
    let motion = InitialMotion { spin: [0.0, 0.0, 3.0], ..InitialMotion::default() };
    let model = weightless(moving(rod::revolute(4), motion));
    assert!(model.diagnose().unwrap().projection.unwrap() < 1e-24);
}

/// A linked rod along x, clamped at its start, with its end tied to a point of the ground.
fn tied(to: [f64; 3]) -> Model {
    let mut model = weightless(rod::clamped(4, ancf::model::Clamped::Section));
    let beam = rod::beam(&mut model);
    beam.formulation = ancf::model::Formulation::Linked;
    let b = End::Point(Ground { point: to });
    model.joints.push(Joint::Spherical { name: "far".into(), a: rod::end(), b });
    Model { assemble: true, ..model }
}

/// The end of a cantilever is drawn across by δ: it bends with 3EI/L³, and stays so.
#[test]
fn a_strained_assembly_rests() {
    let delta = 1e-3;
    let mut model = tied([rod::LENGTH, delta, 0.0]);
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
    let wanted = 0.5 * 3.0 * bending * delta * delta + 0.5 * axial * stretch * stretch;
    let energy = assembly.system.energy(&initial).strain;
    assert!((energy - wanted).abs() < 2e-3 * wanted, "{energy} instead of {wanted}");
    let wanted = 3.0 * bending * delta + 1.2 * axial * stretch * delta;
    for start in [Start::Consistent, Start::Zero] {
        rod::settings(&mut model).start = start;
        rod::settings(&mut model).duration = 0.05;
        let run = Run::of(&model);
        let kinetic = run.column("kinetic").iter().copied().fold(0.0, f64::max);
        assert!(kinetic < 1e-9 * energy, "{start:?}: {kinetic} of {energy}");
        let force = run.vectors("far.f").last().unwrap().y;
        assert!((force - wanted).abs() < 2e-3 * wanted, "{force} instead of {wanted}");
    }
}

/// A body that can be moved into place is, without strain; what is clamped stays.
#[test]
fn a_loose_body_is_moved() {
    let mut model = rod::cantilever(2);
    let (from, to) = ([1.0, 0.03, 0.0], [1.4, 0.03, 0.3]);
    let second = Beam { name: "second".into(), from, to, ..rod::beam(&mut model).clone() };
    model.bodies.push(Body::Beam(second));
    let a = Place::new("second", At::Named(Named::Start));
    model.joints.push(Joint::Spherical { name: "elbow".into(), a, b: End::Place(rod::end()) });
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
    // Of the energy that it would take to bend the clamped rod as far, nothing.
    let bent = 0.5 * 3.0 * 193e9 * std::f64::consts::PI * 0.01_f64.powi(4) / 4.0 * 0.03_f64.powi(2);
    let strain = assembly.system.energy(&initial).strain;
    assert!(strain < 1e-9 * bent, "{strain} of {bent}");
}

/// Statics draws points by the load, whether gaps are closed or not; it starts from closed places.
#[test]
fn statics_starts_closed() {
    let mut model = tied([rod::LENGTH, 0.01, 0.0]);
    let a = Place::new("rod", At::Length(0.5));
    let hanger = Beam {
        name: "hanger".into(),
        from: [0.5, 0.002, 0.0],
        to: [0.5, 0.402, 0.0],
        ..rod::beam(&mut model).clone()
    };
    model.bodies.push(Body::Beam(hanger));
    let hanger = Place::new("hanger", At::Named(Named::Start));
    model.joints.push(Joint::Clamp { name: "hang".into(), a: hanger, b: End::Place(a), fix: None });
    model.analysis = Analysis::Statics(Statics::default());
    model.probes.push(Probe::of_motion("foot", Place::new("hanger", At::Named(Named::Start))));
    model.probes.push(Probe::of_motion("middle", Place::new("rod", At::Length(0.5))));
    let run = Run::of(&model);
    assert!(distance(&run.vectors("foot."), &run.vectors("middle.")) < 1e-12);
    let tip = run.vectors("tip.");
    assert!((tip[0] - Vector3::new(1.0, 0.0, 0.0)).norm() < 1e-12);
    assert!((tip.last().unwrap() - Vector3::new(1.0, 0.01, 0.0)).norm() < 1e-12);
}

/// A slope is turned with the section, whatever the slope coordinates and the units.
#[test]
fn units_of_a_start() {
    let motion = InitialMotion { velocity: VELOCITY, spin: SPIN, about: Some([0.2, 0.3, -0.1]) };
    let model = moving(rod::free(3), motion);
    let mut other = model.clone();
    other.scales = ancf::model::ScaleChoice::Given { length: 0.25, force: 8.0, time: Some(0.125) };
    rod::beam(&mut other).slopes = ancf::model::Slopes::Length;
    let (a, b) = (Run::of(&model), Run::of(&other));
    assert!(distance(&a.vectors("tip."), &b.vectors("tip.")) < 1e-9);
    let v = a.vectors("tip.v")[0];
    let wanted = Vector3::from(VELOCITY) + Vector3::from(SPIN).cross(&Vector3::new(0.8, -0.3, 0.1));
    assert!((v - wanted).norm() < 1e-12 * wanted.norm(), "{v} {wanted}");
}
