//! Search of contact pairs, and momenta of contact forces.

use ancf::assembly::Assembly;
use ancf::mechanics::contact::{BeamContacts, ContactGeometry, ContactLaw};
use ancf::solver::equations::{ContactSearch, EquationsOfMotion, Local, State, Term};
use nalgebra::Vector3;

use super::models::{model, rows};
use crate::common::random::Random;

/// Two-node beam, three-node beam and cable that cross without contact.
fn bodies(contact: &str) -> Assembly {
    let beam = |name: &str, from: &str, to: &str, formulation: &str| {
        format!(
            "[[bodies]]\nkind = \"beam\"\nname = \"{name}\"\nfrom = {from}\nto = {to}\nelements = 4\n\
             formulation = \"{formulation}\"\nsection = \"round\"\nmaterial = \"stiff\"\n\n"
        )
    };
    let text = beam("first", "[-0.2, 0, 0]", "[0.2, 0, 0]", "linked")
        + &beam("second", "[0, -0.2, 0.05]", "[0.05, 0.2, 0.04]", "quadratic")
        + "[[bodies]]\nkind = \"cable\"\nname = \"third\"\nfrom = [-0.1, -0.1, 0.1]\nto = [0.1, 0.1, 0.12]\nelements = 5\nsection \
           = \"round\"\nmaterial = \"soft\"\n\n";
    model(&text, contact).assemble().unwrap()
}

/// Random state: bodies are shifted and deformed.
fn random_state(assembly: &Assembly, random: &mut Random) -> State {
    let mut s = assembly.rest();
    for (_, mesh) in assembly.bodies() {
        let shift = random.vector3() * 0.06;
        for vector in mesh.vectors(&assembly.rest()) {
            let moved = if vector.is_position() { shift } else { Vector3::zeros() } + random.vector3() * 0.01;
            s.q[vector.first..vector.first + 3].copy_from_slice(moved.as_slice());
        }
    }
    s.v.iter_mut().for_each(|v| *v = random.number());
    s
}

fn energy(term: &dyn Term, s: &State) -> f64 {
    let q: Vec<f64> = term.coordinates().iter().map(|&c| s.q[c]).collect();
    let zeros = vec![0.0; q.len()];
    term.energy(&Local { q: &q, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 1.0 }).strain
}

/// All active pairs are found, in order.
#[test]
fn search_finds_all_active_pairs() {
    let assembly = bodies("");
    let law = ContactLaw { stiffness: 1e6, transition: 1e-4, damping: 0.0, friction: 0.0, slip_speed: 1.0 };
    let skins: Vec<ContactGeometry> = assembly
        .bodies()
        .filter_map(|(_, body)| Some(ContactGeometry::tube(body.mesh()?, 0.01, 7)))
        .collect();
    let elements: usize = assembly.bodies().filter_map(|(_, body)| Some(body.mesh()?.count())).sum();
    let (rest, mut random, mut acting) = (assembly.rest(), Random(7), 0);
    let contacts = BeamContacts::new(skins, law, &rest);
    for _ in 0..20 {
        let s = random_state(&assembly, &mut random);
        let near = contacts.near(&s);
        assert!(near.is_sorted_by(|a, b| a.0 < b.0));
        for pair in (0..7 * elements as u32).flat_map(|i| (0..elements as u32).map(move |k| [i, k])) {
            let term = contacts.term(pair);
            // Pairs that overlap at rest are a point and its own element.
            if energy(term.as_ref(), &s) > 0.0 && energy(term.as_ref(), &rest) == 0.0 {
                acting += 1;
                assert!(near.iter().any(|(found, d)| *found == pair && *d <= 0.0), "{pair:?}");
            }
        }
    }
    assert!(acting > 50, "{acting}");
}

/// Asserts that contact forces have no resultant and, if `angular` is set, no moment.
fn assert_momenta(contact: &str, angular: bool) {
    let assembly = bodies(contact);
    let (mut random, mut acting) = (Random(11), 0);
    for _ in 0..20 {
        let s = random_state(&assembly, &mut random);
        let Some((complete, _)) = assembly.system.with_active_terms(&s) else { continue };
        for term in &complete.terms()[assembly.system.terms().len()..] {
            let rows = rows(term.as_ref(), &s);
            let (mut force, mut moment, mut size) = (Vector3::zeros(), Vector3::zeros(), 0.0_f64);
            for (_, mesh) in assembly.bodies() {
                for vector in mesh.vectors(&s) {
                    let row = Vector3::from_column_slice(&rows[vector.first..vector.first + 3]);
                    moment += vector.value.cross(&row);
                    if vector.is_position() {
                        force += row;
                        size = size.max(row.norm());
                    }
                }
            }
            acting += usize::from(size > 0.0);
            assert!(force.norm() <= 1e-12 * size, "{force}");
            assert!(!angular || moment.norm() <= 1e-12 * size, "{moment}");
        }
    }
    assert!(acting > 5, "{acting}");
}

/// Friction between bodies has a moment, since it acts at two points.
#[test]
fn contact_forces_conserve_momenta() {
    let drum = "with = { kind = \"cylinder\", point = [0, 0, 0], axis = [0.3, 1, 0], radius = 0.04, on = { body = \"first\", \
                at = 0.17 } }\nstiffness = 1e6\nfriction = 0.4\ndamping = 0.3";
    assert_momenta(drum, true);
    assert_momenta(
        &drum.replace("cylinder", "sphere").replace("point", "center").replace("axis = [0.3, 1, 0], ", ""),
        true,
    );
    let plane = "with = { kind = \"plane\", point = [0, 0, 0.04], normal = [0.1, 0.2, 1], on = { body = \"first\", at = \"end\" \
                 } }\nstiffness = 1e6\nfriction = 0.4";
    assert_momenta(plane, true);
    assert_momenta("with = { kind = \"bodies\" }\nstiffness = 1e6\ndamping = 0.3", true);
    assert_momenta("with = { kind = \"bodies\" }\nstiffness = 1e6\nfriction = 0.3", false);
}
