//! Contact of cables at random positions: the sum over all points, forces and energies, and invariance.

use std::sync::Arc;

use ancf::assembly::Assembly;
use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::contact::ContactLaw;
use ancf::solver::equations::{EquationsOfMotion, Local, State, Term};
use nalgebra::Vector3;

use super::models::{model, rows};
use crate::common::random::Random;

const RADIUS: f64 = 0.01;
const POINTS: usize = 6;
const STIFFNESS: f64 = 1e5;
const TRANSITION: f64 = 1e-3;

/// Cable of a model: ends, number of elements, and a phase of its deformation.
#[derive(Clone, Copy)]
struct Cable {
    ends: [Vector3<f64>; 2],
    elements: usize,
    phase: f64,
}

/// Cables that cross in layers without contact.
fn layers(count: usize) -> Vec<Cable> {
    let mut random = Random(3);
    let cable = |i: usize| {
        let (angle, height) = (2.4 * i as f64, Vector3::z() * (2.2 * RADIUS * i as f64));
        let side = Vector3::new(angle.cos(), angle.sin(), 0.0);
        let offset = Vector3::new(-side.y, side.x, 0.0) * (0.05 * random.number());
        Cable {
            ends: [offset - side * 0.3 + height, offset + side * 0.3 + height],
            elements: 4 + i % 3,
            phase: i as f64,
        }
    };
    (0..count).map(cable).collect()
}

/// Model of cables in a unit of length (in metres) with a given contact.
fn assembled(cables: &[Cable], unit: f64, contact: &str) -> Assembly {
    let point = |p: Vector3<f64>| format!("[{:?}, {:?}, {:?}]", p.x / unit, p.y / unit, p.z / unit);
    let bodies = cables.iter().map(|Cable { ends, elements, phase }| {
        format!(
            "[[bodies]]\nkind = \"cable\"\nname = \"c{phase}\"\nfrom = {}\nto = {}\nelements = {elements}\nsection = \
             \"round\"\nmaterial = \"soft\"\n\n",
            point(ends[0]),
            point(ends[1])
        )
    });
    let contact = format!(
        "with = {{ kind = \"bodies\" }}\nradius = {:?}\npoints = {POINTS}\nstiffness = {:?}\ntransition = {:?}\n{contact}",
        RADIUS / unit,
        STIFFNESS * unit * unit,
        TRANSITION / unit
    );
    model(&bodies.collect::<String>(), &contact).assemble().unwrap()
}

/// State in which each point X of a cable moves by a field u(X) of its phase, with ∂u/∂s in the slopes.
///
/// The state does not depend on numbers or directions of the cables.
fn deformed(assembly: &Assembly, cables: &[Cable], unit: f64, case: f64) -> State {
    let mut s = assembly.rest();
    for cable in cables {
        let mesh = assembly.mesh(&format!("c{}", cable.phase)).unwrap();
        let along = (cable.ends[1] - cable.ends[0]).normalize();
        let mut place = Vector3::zeros();
        for vector in mesh.vectors(&assembly.rest()) {
            let field = |x: &Vector3<f64>| {
                let wave =
                    |k: f64| (9.0 * x.dot(&Vector3::new(1.0, 0.7, 0.2)) + k * cable.phase + case).sin();
                Vector3::new(0.01 * wave(1.3), 0.01 * wave(2.1), 0.02 * wave(3.7)) / unit
            };
            let moved = if vector.is_position() {
                place = vector.value * unit;
                field(&place)
            } else {
                // The size of the slope vector is the unit of its coordinates.
                let h = 1e-5;
                let change = (field(&(place + along * h)) - field(&(place - along * h))) / (2.0 * h);
                change * (vector.value.norm() * unit * vector.value.dot(&along).signum())
            };
            s.q[vector.first..vector.first + 3].copy_from_slice(moved.as_slice());
        }
    }
    s
}

/// Contact energy of a state by the search of the system.
fn energy(assembly: &Assembly, s: &State) -> f64 {
    let Some((complete, _)) = assembly.system.with_active_terms(s) else { return 0.0 };
    let of = |term: &Arc<dyn Term>| {
        let q: Vec<f64> = term.coordinates().iter().map(|&c| s.q[c]).collect();
        let zeros = vec![0.0; q.len()];
        term.energy(&Local { q: &q, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 1.0 }).strain
    };
    complete.terms()[assembly.system.terms().len()..].iter().map(of).sum()
}

/// Residual of all contacts in the rows of all coordinates.
fn residual(assembly: &Assembly, s: &State) -> Vec<f64> {
    let mut sum = vec![0.0; s.q.len()];
    let Some((complete, _)) = assembly.system.with_active_terms(s) else { return sum };
    for term in &complete.terms()[assembly.system.terms().len()..] {
        sum.iter_mut().zip(rows(term.as_ref(), s)).for_each(|(sum, row)| *sum += row);
    }
    sum
}

/// Distance of a point from an axis: dense samples, improved by golden sections.
fn distance(point: &Vector3<f64>, mesh: &BeamMesh, s: &State) -> f64 {
    let samples = 200 * mesh.count();
    let at = |x: f64| (mesh.point(x.clamp(0.0, mesh.length())).value(s) - point).norm();
    let spacing = mesh.length() / samples as f64;
    let nearest = (0..=samples).map(|k| k as f64 * spacing).min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap();
    let (mut low, mut high) = (nearest - spacing, nearest + spacing);
    for _ in 0..60 {
        let third = (high - low) * 0.381_966;
        if at(low + third) < at(high - third) { high -= third } else { low += third }
    }
    at(0.5 * (low + high))
}

/// The contact energy is the sum over all points of all cables and their distances from all other cables.
#[test]
fn no_contact_is_missed() {
    let cables = layers(6);
    let assembly = assembled(&cables, 1.0, "");
    let law = ContactLaw {
        stiffness: 0.5 * STIFFNESS,
        transition: TRANSITION,
        damping: 0.0,
        friction: 0.0,
        slip_speed: 1.0,
    };
    let meshes: Vec<&BeamMesh> = assembly.bodies().filter_map(|(_, body)| body.mesh()).collect();
    let mut acting = 0;
    for case in 0..4 {
        let s = deformed(&assembly, &cables, 1.0, f64::from(case));
        let mut sum = 0.0;
        for (i, own) in meshes.iter().enumerate() {
            let length = own.length() / (own.count() * POINTS) as f64;
            for point in (0..own.count() * POINTS).map(|k| own.point((k as f64 + 0.5) * length).value(&s)) {
                for other in meshes.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, other)| other) {
                    let gap = distance(&point, other, &s) - 2.0 * RADIUS;
                    acting += usize::from(gap < 0.0);
                    sum += length * law.energy(gap);
                }
            }
        }
        let found = energy(&assembly, &s);
        assert!((found - sum).abs() <= 1e-8 * sum, "case {case}: {found}, {sum}");
    }
    assert!(acting > 40, "{acting}");
}

/// Forces are the derivatives of the energy, and have neither a resultant nor a moment.
#[test]
fn forces_follow_from_the_energy_and_balance() {
    let cables = layers(6);
    let assembly = assembled(&cables, 1.0, "");
    let (mut random, h) = (Random(5), 1e-7);
    for case in 0..4 {
        let s = deformed(&assembly, &cables, 1.0, f64::from(case));
        let forces = residual(&assembly, &s);
        let size = forces.iter().map(|f| f.abs()).sum::<f64>();
        for _ in 0..4 {
            let direction: Vec<f64> = s.q.iter().map(|_| random.number()).collect();
            let moved = |h: f64| {
                let mut moved = s.clone();
                moved.q.iter_mut().zip(&direction).for_each(|(q, d)| *q += h * d);
                energy(&assembly, &moved)
            };
            let change = (moved(h) - moved(-h)) / (2.0 * h);
            let power: f64 = forces.iter().zip(&direction).map(|(f, d)| f * d).sum();
            assert!((change - power).abs() <= 1e-5 * size, "case {case}: {change}, {power}");
        }
        let (mut resultant, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for vector in assembly.bodies().flat_map(|(_, body)| body.vectors(&s)) {
            let row = Vector3::from_column_slice(&forces[vector.first..vector.first + 3]);
            resultant += if vector.is_position() { row } else { Vector3::zeros() };
            moment += vector.value.cross(&row);
        }
        assert!(size > 0.0 && resultant.norm() <= 1e-12 * size && moment.norm() <= 1e-12 * size);
    }
}

/// The order of the bodies, the directions of their axes and the unit of length do not affect the energy.
#[test]
fn energy_is_independent_of_numbers_and_units() {
    let cables = layers(6);
    let reversed: Vec<Cable> =
        cables.iter().rev().map(|cable| Cable { ends: [cable.ends[1], cable.ends[0]], ..*cable }).collect();
    let shuffled: Vec<Cable> = [3, 0, 5, 1, 4, 2].map(|i| cables[i]).to_vec();
    for case in 0..4 {
        let of = |cables: &[Cable], unit: f64| {
            let assembly = assembled(cables, unit, "");
            energy(&assembly, &deformed(&assembly, cables, unit, f64::from(case))) * unit
        };
        let first = of(&cables, 1.0);
        assert!(first > 0.0);
        // The slopes are differences of the field, with errors of 1e-11.
        for other in [of(&reversed, 1.0), of(&shuffled, 1.0), of(&cables, 1e-3)] {
            assert!((other - first).abs() <= 1e-8 * first, "case {case}: {other}, {first}");
        }
    }
}

/// Contacts with friction and damping have the same forces if the terms of a pair of elements are evaluated one by one.
#[test]
fn groups_are_sums_of_their_pairs() {
    let cables = layers(6);
    let assembly = assembled(&cables, 1.0, "friction = 0.3\ndamping = 0.5\nslip_speed = 0.1");
    let mut random = Random(9);
    for case in 0..4 {
        let mut s = deformed(&assembly, &cables, 1.0, f64::from(case));
        s.v.iter_mut().for_each(|v| *v = random.number());
        let grouped = residual(&assembly, &s);
        let mut single = vec![0.0; s.q.len()];
        for term in assembly.contact_terms(&s) {
            single.iter_mut().zip(rows(term.as_ref(), &s)).for_each(|(sum, row)| *sum += row);
        }
        let size = single.iter().fold(0.0_f64, |size, f| size.max(f.abs()));
        assert!(size > 0.0);
        for (a, b) in grouped.iter().zip(&single) {
            assert!((a - b).abs() <= 1e-10 * size, "case {case}: {a}, {b}");
        }
    }
}
