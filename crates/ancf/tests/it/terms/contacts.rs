//! Contacts with deep penetration, active for all small random states.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::contact::{
    BeamContact, ContactLaw, ContactPoint, Obstacle, ObstacleContact, ObstacleShape, SurfaceContact,
};
use ancf::mechanics::kinematics::Attachment;
use ancf::mechanics::shells::{ShellMedium, ShellMesh, ShellSection};
use ancf::solver::equations::Term;
use nalgebra::Vector3;

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

/// Curved thin shell of 2 × 1 elements with the first element about a point in the direction (x, y) from it and 1 below it.
fn shell(at: Vector3<f64>, [x, y]: [f64; 2]) -> ShellMesh {
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
    ShellMesh::new(120, [2, 1], at, map, &medium)
}

/// Returns contacts of a point of a beam, and of one of a shell, with the interior, an edge and a corner of a thin shell.
fn surface_contacts(point: &ContactPoint, at: Vector3<f64>, law: ContactLaw) -> Vec<(String, Box<dyn Term>)> {
    let places = [("interior", [0.0, 0.0]), ("edge", [0.0, 2.0]), ("corner", [2.0, 2.0])];
    let on_shell = shell(at - Vector3::new(0.1, 0.1, -1.2), [0.0, 0.0]);
    let other = on_shell.point([0.2, 0.4]);
    let of = |(name, shift): (&str, [f64; 2])| -> Vec<(String, Box<dyn Term>)> {
        let target = shell(at, shift);
        let (surface, free) = target.element_surfaces().next().unwrap();
        let contact =
            |point: &ContactPoint| SurfaceContact::new(std::slice::from_ref(point), &surface, free, 3.0, law);
        // Both shells have the same coordinates.
        let own = ContactPoint::new(other.clone(), 0.02);
        vec![
            (format!("beam on the {name} of a shell"), Box::new(contact(point))),
            (format!("shell on the {name} of a shell"), Box::new(contact(&own))),
        ]
    };
    places.into_iter().flat_map(of).collect()
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
            }
        }
        let contact_point = ContactPoint::new(point.clone(), 0.02);
        let on_shells = surface_contacts(&contact_point, at, law).into_iter();
        cases.extend(on_shells.map(|(name, term)| (format!("contact: {name}, {what}"), term, loss)));
        for (place, axis) in ["middle", "end"].into_iter().zip(b.element_axes()) {
            let contact = BeamContact::new(&point, &axis, [true; 2], 2.0, 0.02, law);
            cases.push((format!("contact: beams, {place}, {what}"), Box::new(contact), loss));
        }
    }
    cases
}
