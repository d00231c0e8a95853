//! How motions start: with velocities of rigid bodies, and with gaps closed.
#![cfg(test)]

#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/rod.rs"]
mod rod;
#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "common/run.rs"]
mod run;

use ancf::Model;
use ancf::analysis::{Dynamics, Newton, Scheme, Stop, consistent_velocities};
use ancf::model::{
    Analysis, Assembly, At, AtEnd, Beam, Body, End, Ground, InitialMotion, Joint, Place, Probe, Start,
    Statics,
};
use ancf::system::{EquationsOfMotion, State, Weights};
use nalgebra::Vector3;

use run::{Run, distance};

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
    let vectors: Vec<_> =
        assembly.bodies().flat_map(|(_, mesh)| mesh.vectors(s).collect::<Vec<_>>()).collect();
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

/// A rod that hangs on a ball at its start and is given the velocity u of a translation across it, keeps of it the rotation of
/// the same angular momentum about the ball: ω = m u (L/2) / J.
#[test]
fn a_pinned_rod_turns() {
    let motion = InitialMotion { velocity: [0.0, 2.0, 0.0], ..InitialMotion::default() };
    let model = weightless(moving(rod::spherical(4), motion));
    let assembly = model.assemble().unwrap();
    let mut s = assembly.start(&model);
    consistent_velocities(&assembly.system, &mut assembly.system.matrix(), &mut s).unwrap();
    let stiff = 3.0 * 2.0 / (2.0 * rod::LENGTH);
    let [_, angular] = momenta(&assembly, &s);
    let before = momenta(&assembly, &assembly.start(&model))[1];
    // The impulse of the ball has no moment about it.
    assert!((angular - before).norm() < 1e-12 * before.norm());
    println!("stiff {stiff}, {angular}");
    let change = model.diagnose().unwrap().projection.unwrap();
    println!("{change}");
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
