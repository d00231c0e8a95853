//! Contacts with deep penetration, active for all small random states.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::contact::{
    BallContact, BeamContact, ContactGeometry, ContactLaw, ContactPoint, FaceContact, Obstacle,
    ObstacleContact, ObstacleShape, ThinContact,
};
use ancf::mechanics::kinematics::Attachment;
use ancf::mechanics::shells::{
    Face, LocalSection, SectionField, ShearShellMesh, ShellMedium, ShellMesh, ShellSection,
};
use ancf::solver::equations::Term;
use nalgebra::Vector3;

use super::shear_shells::medium;

/// Mechanism of energy loss.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Loss {
    None,
    Damping,
    Friction,
}

/// Contact pressure, linear or quadratic in the depth.
fn law(linear: bool, loss: Loss) -> ContactLaw {
    ContactLaw {
        stiffness: 3.0,
        transition: if linear { 0.1 } else { 30.0 },
        damping: if loss == Loss::Damping { 0.4 } else { 0.0 },
        friction: if loss == Loss::Friction { 0.5 } else { 0.0 },
        slip_speed: 2.0,
    }
}

/// Relative thickness that varies in both directions.
fn tapered() -> SectionField {
    SectionField::new(|element, [x, y]| LocalSection {
        scale: 1.0 + 0.1 * element as f64 + 0.1 * x * x - 0.15 * y + 0.08 * x * y,
        ..LocalSection::WHOLE
    })
}

/// Curved thin shell of 2 × 1 elements with the first element about a point in the direction (x, y) from it and 1 below it.
fn shell(at: Vector3<f64>, [x, y]: [f64; 2], sections: Option<SectionField>) -> ShellMesh {
    let section = ShellSection::isotropic(1e6, 0.3, 1.0, 0.1);
    let medium =
        ShellMedium { section, axis: None, retardation: 0.0, mass_damping: 0.0, gravity: Vector3::zeros() };
    let map = |[u, v]: [f64; 2]| {
        let [a, b] = [Vector3::new(6.0, 0.5, 0.8 - 1.6 * u), Vector3::new(-0.3, 3.0, 0.3)];
        let corner = Vector3::new(x - 1.5, y - 1.5, -1.3);
        [
            corner + Vector3::new(6.0, 0.5, 0.8) * u - Vector3::z() * (0.8 * u * u) + b * v,
            a,
            b,
            Vector3::zeros(),
        ]
    };
    ShellMesh::varying(120, [2, 1], at, map, (&medium, sections))
}

/// Returns contacts of a point of a beam, and of one of a shell, with the interior, an edge and a corner of a thin shell.
fn surface_contacts(point: &ContactPoint, at: Vector3<f64>, law: ContactLaw) -> Vec<(String, Box<dyn Term>)> {
    let places = [("interior", [0.0, 0.0]), ("edge", [0.0, 2.0]), ("corner", [2.0, 2.0])];
    let on_shell = shell(at - Vector3::new(0.1, 0.1, -1.2), [0.0, 0.0], None);
    let other = on_shell.point([0.2, 0.4]);
    let of = |(name, shift): (&str, [f64; 2])| -> Vec<(String, Box<dyn Term>)> {
        let target = ContactGeometry::shell(&shell(at, shift, None), 1.0, 5);
        let contact = |point: &ContactPoint| {
            ThinContact::new(std::slice::from_ref(point), (&target, 0), 3.0, law).expect("an element")
        };
        // Both shells have the same coordinates.
        let own = ContactPoint::new(other.clone(), 0.02);
        vec![
            (format!("beam on the {name} of a shell"), Box::new(contact(point))),
            (format!("shell on the {name} of a shell"), Box::new(contact(&own))),
        ]
    };
    places.into_iter().flat_map(of).collect()
}

/// Shear-deformable shell over the surface of [`shell`], of 2 × 2 quadrilaterals, or of triangles.
fn faceted_shell(at: Vector3<f64>, [x, y]: [f64; 2], is_split: bool) -> ShearShellMesh {
    let point = |i: usize, j: usize| {
        let [u, v] = [i, j].map(|k| k as f64 / 2.0);
        at + Vector3::new(x - 1.5, y - 1.5, -1.3)
            + Vector3::new(8.0, 0.5, 0.8 - 0.8 * u) * u
            + Vector3::new(-0.3, 6.0, 0.3 + 0.5 * u) * v
    };
    let nodes: Vec<_> = (0..3).flat_map(|j| (0..3).map(move |i| point(i, j))).collect();
    let split = |k: usize| match is_split {
        false => vec![Face::Quad([k, k + 1, k + 4, k + 3])],
        true => vec![Face::Triangle([k, k + 1, k + 4]), Face::Triangle([k, k + 4, k + 3])],
    };
    let faces = [0, 1, 3, 4].into_iter().flat_map(split).collect();
    ShearShellMesh::new(120, &nodes, &[Vector3::z(); 9], faces, &medium(false, [0.0; 2]))
}

/// Returns contacts of a point of a beam, and of one of a shell, with places of elements that join with kinks: the interior, a free
/// edge, an inner edge and an inner node.
fn face_contacts(point: &ContactPoint, at: Vector3<f64>, law: ContactLaw) -> Vec<(String, Box<dyn Term>)> {
    let places =
        [("interior", [0.0, 0.6]), ("free edge", [0.2, 2.6]), ("edge", [-3.4, 0.3]), ("node", [-3.4, -2.4])];
    let of = |((name, shift), is_split): ((&str, [f64; 2]), bool)| -> Vec<(String, Box<dyn Term>)> {
        let target = ContactGeometry::shear_shell(&faceted_shell(at, shift, is_split), 1.0, 5);
        // Points of the same shell, beyond the element.
        let on_shell = shell(at - Vector3::new(0.1, 0.1, -1.2), [0.0; 2], None);
        let own = ContactPoint::new(on_shell.point([0.2, 0.4]), 0.02);
        let contact = |point: &ContactPoint| {
            FaceContact::new(std::slice::from_ref(point), (&target, 0), 3.0, law).expect("an element")
        };
        vec![
            (format!("beam on the {name} of a face, triangle: {is_split}"), Box::new(contact(point))),
            (format!("shell on the {name} of a face, triangle: {is_split}"), Box::new(contact(&own))),
        ]
    };
    places.into_iter().flat_map(|place| [(place, false), (place, true)]).flat_map(of).collect()
}

/// Returns contacts of a point of a beam, and of one of a shell, with places of a thin shell whose thickness varies.
pub(super) fn tapered_contacts(a: &BeamMesh, s: f64) -> Vec<(String, Box<dyn Term>, Loss)> {
    let point = a.point(s);
    let at = point.reference();
    let on_shell = shell(at - Vector3::new(0.1, 0.1, -1.2), [0.0, 0.0], None).point([0.2, 0.4]);
    let points =
        [("beam", point), ("shell", on_shell)].map(|(owner, place)| (owner, ContactPoint::new(place, 0.02)));
    let mut cases: Vec<(String, Box<dyn Term>, Loss)> = Vec::new();
    for loss in [Loss::None, Loss::Damping, Loss::Friction] {
        for (name, shift) in [("interior", [0.0, 0.0]), ("edge", [0.0, 2.0]), ("corner", [2.0, 2.0])] {
            let target = ContactGeometry::shell(&shell(at, shift, Some(tapered())), 8.0, 5);
            for (owner, point) in &points {
                let term = ThinContact::new(std::slice::from_ref(point), (&target, 0), 3.0, law(true, loss));
                let name = format!("contact: {owner} on the {name} of a tapered shell, {loss:?}");
                cases.push((name, Box::new(term.expect("an element")), loss));
            }
        }
    }
    cases
}

/// Returns contacts with their names and losses: all obstacle shapes on ground and body, beam on beam, points on shells.
pub(super) fn contacts(a: &BeamMesh, b: &BeamMesh, s: f64) -> Vec<(String, Box<dyn Term>, Loss)> {
    let point = a.point(s);
    let at = point.reference();
    let axis = Vector3::new(0.48, 0.6, -0.64);
    let forms = [
        (ObstacleShape::Plane, at + axis * 1.0),
        (ObstacleShape::Sphere { radius: 3.0, inside: false }, at + Vector3::new(1.0, 1.0, 1.0)),
        (ObstacleShape::Sphere { radius: 0.4, inside: true }, at + Vector3::new(1.0, 1.0, 1.0)),
        (ObstacleShape::Cylinder { radius: 3.0, inside: false }, at + Vector3::new(1.5, 1.0, 1.0)),
        (ObstacleShape::Cylinder { radius: 0.4, inside: true }, at + Vector3::new(1.5, 1.0, 1.0)),
    ];
    let mut cases: Vec<(String, Box<dyn Term>, Loss)> = Vec::new();
    let losses = [Loss::None, Loss::Damping, Loss::Friction];
    for (linear, loss) in losses.into_iter().flat_map(|loss| [(true, loss), (false, loss)]) {
        let (law, what) = (law(linear, loss), format!("linear: {linear}, {loss:?}"));
        for (form, center) in forms {
            let carried = b.attachment(s);
            let arm = center - carried.point.reference();
            for (carrier, place) in [("ground", Attachment::ground(center)), ("body", carried.offset(arm))] {
                let obstacle = Obstacle::new(form, place, axis * 2.0).unwrap();
                let contact =
                    ObstacleContact::new(&obstacle, &ContactPoint::new(point.clone(), 0.02), 0.3, law)
                        .unwrap();
                cases.push((format!("contact: {form:?} on {carrier}, {what}"), Box::new(contact), loss));
                if loss == Loss::Friction {
                    let own = a.attachment(s);
                    let (ball, turning) = (ContactPoint::new(point.clone(), 0.02), own.axes().unwrap());
                    let contact = BallContact::new(&obstacle, (&[ball], turning), 0.3, law);
                    cases.push((
                        format!("contact: {form:?} on {carrier}, ball, {what}"),
                        Box::new(contact),
                        loss,
                    ));
                }
            }
        }
        let contact_point = ContactPoint::new(point.clone(), 0.02);
        let on_shells = surface_contacts(&contact_point, at, law);
        let on_shells = on_shells.into_iter().chain(face_contacts(&contact_point, at, law));
        cases.extend(on_shells.map(|(name, term)| (format!("contact: {name}, {what}"), term, loss)));
        for (place, axis) in ["middle", "end"].into_iter().zip(b.element_axes()) {
            let contact = BeamContact::new(&point, &axis, [true; 2], 2.0, 0.02, law);
            cases.push((format!("contact: beams, {place}, {what}"), Box::new(contact), loss));
        }
    }
    cases
}
