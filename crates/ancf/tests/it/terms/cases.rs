//! List of the terms under test.

use std::sync::Arc;

use ancf::mechanics::bodies::BodyTerms;
use ancf::mechanics::elements::{CableDamping, Prestrain, RigidBody};
use ancf::mechanics::forces::{ExternalForce, FollowerForce, Moment};
use ancf::mechanics::functions::{ForceFunction, Function};
use ancf::mechanics::inertia::{FrameInertia, FrameRotation};
use ancf::mechanics::kinematics::BodyVector;
use ancf::model::{Damping, MaterialLaw};
use ancf::solver::equations::{State, Term};
use nalgebra::{Matrix3, Rotation3, Vector3};

use super::constraints::{ORIGIN, bodies, constraints_and_loads, mesh};
use super::contacts::{Loss, contacts, tapered_contacts};
use super::frames::frame_terms;
use super::gases::gas_terms;
use super::immersed::{immersed_terms, meshes};
use super::joint_terms::joint_terms;
use super::kind::TermKind;
use super::shear_shells::shear_shell_terms;
use super::shell_prestrains::shell_prestrain_terms;
use super::shells::shell_terms;
use super::surface_flows::surface_flow_terms;
use crate::common::models::beams::{BY_KIND, BeamCase, beam_cases};
use crate::common::models::cables;

/// Term under test.
pub(super) struct TermCase {
    pub(super) name: String,
    pub(super) term: Box<dyn Term>,
    pub(super) kind: TermKind,
}

/// Beams of every formulation, without and with damping.
fn beams(gravity: Vector3<f64>) -> impl Iterator<Item = TermCase> {
    let damped = |case: &BeamCase| BeamCase {
        damping: Damping { strain: 0.2, mass: 0.7, ..Damping::default() },
        ..case.clone()
    };
    let cases = beam_cases();
    let mut damped: Vec<BeamCase> = cases.iter().filter(|case| case.tilted).map(damped).collect();
    let by_kind = |case: &BeamCase| BeamCase { damping: BY_KIND, ..case.clone() };
    damped.extend(cases.iter().filter(|case| case.tilted && case.supports(&BY_KIND)).map(by_kind));
    cases.into_iter().chain(damped).map(move |case| {
        let kind = match (case.damping == Damping::default(), case.law) {
            (true, MaterialLaw::StVenantKirchhoff) => TermKind::Polynomial,
            (true, MaterialLaw::NeoHookean) => TermKind::Smooth,
            (false, _) => TermKind::Retarded,
        };
        let element = case.element(gravity);
        TermCase { name: element.name, term: element.term, kind }
    })
}

/// Cables without and with damping.
fn cable_elements(gravity: Vector3<f64>) -> impl Iterator<Item = TermCase> {
    let by_kind = CableDamping { stretch: 0.1, ..cables::DAMPING };
    let dampings = [
        (CableDamping::default(), TermKind::Smooth),
        (cables::DAMPING, TermKind::IncompleteStiffness),
        (by_kind, TermKind::IncompleteStiffness),
    ];
    dampings.into_iter().flat_map(move |(damping, kind)| {
        let case =
            move |cable: cables::Cable| TermCase { name: cable.name, term: Box::new(cable.term), kind };
        cables::cables(damping, gravity).into_iter().map(case)
    })
}

/// Loads that follow the section, and moments with a fixed direction.
fn followers() -> impl Iterator<Item = TermCase> {
    let (_, mesh) = meshes().swap_remove(0);
    let (frame, vector) = (mesh.frame(1.3).expect("a beam"), Vector3::new(0.3, -2.0, 0.7));
    let along = BodyVector::turned(&frame, frame.composed(&vector));
    let force = FollowerForce::new(mesh.point(1.3), along, Function::ONE);
    let terms: [(&str, Box<dyn Term>); 3] = [
        ("follower force", Box::new(force)),
        ("follower moment", Box::new(Moment::in_section(&frame, vector, Function::ONE))),
        ("moment", Box::new(Moment::new(&frame, vector, Function::ONE))),
    ];
    let kind = TermKind::NonConservative;
    terms.into_iter().map(move |(name, term)| TermCase { name: name.to_owned(), term, kind })
}

/// External force of a program, quadratic in position and velocity.
///
/// With a large model length the differences of the library are exact to rounding.
fn external() -> TermCase {
    let law = |t: f64, x: [f64; 3], v: [f64; 3]| {
        let [x, v] = [x, v].map(Vector3::from);
        let field = Vector3::new(0.3 * t, -2.0, 0.7);
        (field - x * 3.0 - v * 0.4 + field.cross(&v) + x * x.dot(&v) * 0.2 - v * x.y * 0.1).into()
    };
    let term = ExternalForce::new(bodies()[1].point(0.31), ForceFunction::new(law), 1e6);
    TermCase { name: "external force".into(), term: Box::new(term), kind: TermKind::NonConservative }
}

/// Rigid body and point mass.
fn rigid_bodies(gravity: Vector3<f64>) -> impl Iterator<Item = TermCase> {
    let inertia = Matrix3::new(2.0, 0.1, 0.2, 0.1, 1.5, -0.3, 0.2, -0.3, 1.8);
    let rigid = RigidBody::new([0, 5], Vector3::new(0.3, 0.2, 0.1), 3.0, inertia, gravity).term();
    let point = RigidBody::point(0, Vector3::x(), 3.0, gravity).term();
    [("rigid body", rigid), ("point mass", point)].into_iter().map(|(name, term)| TermCase {
        name: name.to_owned(),
        term,
        kind: TermKind::Polynomial,
    })
}

/// Contacts of two bodies.
fn contact_terms() -> impl Iterator<Item = TermCase> {
    let a = mesh(0, ORIGIN, Rotation3::identity());
    let b = mesh(36, Vector3::new(0.61, -0.68, 0.2), Rotation3::from_euler_angles(0.4, -0.3, 1.1));
    contacts(&a, &b, 0.31).into_iter().map(contact_case)
}

fn contact_case((name, term, loss): (String, Box<dyn Term>, Loss)) -> TermCase {
    let kind = match loss {
        Loss::None => TermKind::Smooth,
        Loss::Damping => TermKind::Damped,
        Loss::Friction => TermKind::IncompleteStiffness,
    };
    TermCase { name, term, kind }
}

/// Forces of inertia in a rotating frame, of an element of each interpolation and of a rigid body.
fn rotating_frames() -> impl Iterator<Item = TermCase> {
    let rotation = Arc::new(FrameRotation {
        velocity: Vector3::new(0.7, -0.4, 1.1),
        point: Vector3::new(0.2, 0.5, -0.3),
        function: Function::Sine { frequency: 0.4, phase: 0.3 },
    });
    let inertia = Matrix3::new(2.0, 0.1, 0.2, 0.1, 1.5, -0.3, 0.2, -0.3, 1.8);
    let rigid = RigidBody::new([0, 5], Vector3::new(0.3, 0.2, 0.1), 3.0, inertia, Vector3::zeros());
    let flexible = meshes().into_iter().map(|(name, mesh)| (name, BodyTerms::Flexible(mesh)));
    flexible.chain([("rigid body", BodyTerms::Rigid(rigid))]).map(move |(name, body)| {
        let mut last = None;
        body.visit_masses(&State::rest(body.coordinates(), 6), &mut |vectors, mass| {
            last = Some(FrameInertia::new(vectors, mass, rotation.clone()));
        });
        let term = Box::new(last.expect("a body with mass"));
        TermCase { name: format!("rotating frame, {name}"), term, kind: TermKind::NonConservative }
    })
}

/// Prescribed strains of an element of each interpolation, varying along it and in time.
fn prestrains() -> impl Iterator<Item = TermCase> {
    meshes().into_iter().map(|(name, mesh)| {
        let length = mesh.length();
        let source = |strain, curvature, function| Prestrain {
            ends: [0.0, length],
            strain,
            curvature: if name == "cable" { [Vector3::zeros(); 2] } else { curvature },
            function,
        };
        let curvature = [Vector3::new(0.3, -0.2, 0.4), Vector3::new(-0.1, 0.5, 0.2)];
        let mesh = mesh.with_prestrains(vec![
            source([0.1, 0.2], curvature, Function::Sine { frequency: 0.4, phase: 0.3 }),
            source([-0.05, 0.1], [Vector3::new(0.1, 0.2, 0.0); 2], Function::ONE),
        ]);
        let term = mesh.terms().pop().expect("a term of the last element");
        TermCase { name: format!("preloaded by prestrain, {name}"), term, kind: TermKind::Smooth }
    })
}

/// Returns all terms under test.
pub(super) fn terms() -> Vec<TermCase> {
    let gravity = Vector3::new(0.3, -2.0, 0.7);
    let constraints = constraints_and_loads().into_iter().map(|(name, term)| TermCase {
        name: name.to_owned(),
        term,
        kind: TermKind::Polynomial,
    });
    let [a, b] = bodies();
    let joints = joint_terms(&a, &b).into_iter().chain(frame_terms(&a, &b));
    let joints = joints.map(|(name, term, kind)| TermCase { name: name.to_owned(), term, kind });
    let immersed = immersed_terms(gravity).into_iter().map(|(name, term, flows)| {
        let kind = if flows { TermKind::NonConservative } else { TermKind::Damped };
        TermCase { name, term: Box::new(term), kind }
    });
    let free = beams(gravity).chain(constraints).chain(followers()).chain(cable_elements(gravity));
    let free = free.chain(immersed).chain(joints).chain(rigid_bodies(gravity));
    free.chain(contact_terms())
        .chain([external()])
        .chain(shell_terms())
        .chain(shear_shell_terms())
        .chain(surface_flow_terms())
        .chain(rotating_frames())
        .chain(prestrains())
        .chain(shell_prestrain_terms())
        .chain(gas_terms())
        .chain(tapered_contacts(&mesh(0, ORIGIN, Rotation3::identity()), 0.31).into_iter().map(contact_case))
        .collect()
}
