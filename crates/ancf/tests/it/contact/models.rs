//! Models of bodies in contact, and the contact forces.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::solver::equations::{EquationsOfMotion, Local, State, Term};
use nalgebra::Vector3;

use crate::common::models::parse;

/// Model of the given bodies with one contact or none, without gravity.
pub(super) fn model(bodies: &str, contact: &str) -> Model {
    let contact = if contact.is_empty() { String::new() } else { format!("[[contacts]]\n{contact}\n\n") };
    let text = format!(
        "[materials]\nstiff = {{ density = 1000, young = 2e9 }}\nsoft = {{ density = 1000, young = 3e7, damping = {{ mass = \
         20, strain = 1e-3 }} }}\n\n[sections.round]\nkind = \"circle\"\ndiameter = 0.02\n\n{bodies}\n{contact}[analysis]\n\
         kind = \"dynamics\"\nduration = 1\nstep = 1e-3\n"
    );
    parse(&text)
}

/// Undeformed state in which bodies translate with given velocities.
pub(super) fn with_velocities(assembly: &Assembly, velocities: &[(&str, Vector3<f64>)]) -> State {
    let mut s = assembly.rest();
    for (body, velocity) in velocities {
        for vector in assembly.mesh(body).unwrap().vectors(&assembly.rest()).filter(|v| v.is_position()) {
            s.v[vector.first..vector.first + 3].copy_from_slice(velocity.as_slice());
        }
    }
    s
}

/// Residual of a term in the rows of all coordinates.
pub(super) fn rows(term: &dyn Term, s: &State) -> Vec<f64> {
    let of = |x: &[f64]| term.coordinates().iter().map(|&c| x[c]).collect::<Vec<_>>();
    let (q, v, a) = (of(&s.q), of(&s.v), of(&s.a));
    let mut local = vec![0.0; q.len()];
    term.residual(&Local { q: &q, v: &v, a: &a, lambda: &[], t: s.t, load: s.load }, &mut local);
    let mut rows = vec![0.0; s.q.len()];
    term.coordinates().iter().zip(local).for_each(|(&c, row)| rows[c] += row);
    rows
}

/// Sum of all contact forces on a body.
pub(super) fn force(assembly: &Assembly, s: &State, body: &str) -> Vector3<f64> {
    let Some((complete, _)) = assembly.system.with_active_terms(s) else { return Vector3::zeros() };
    let permanent = assembly.system.terms().len();
    let mut force = Vector3::zeros();
    for term in &complete.terms()[permanent..] {
        let rows = rows(term.as_ref(), s);
        for vector in assembly.mesh(body).unwrap().vectors(s).filter(|vector| vector.is_position()) {
            force -= Vector3::from_column_slice(&rows[vector.first..vector.first + 3]);
        }
    }
    force
}
