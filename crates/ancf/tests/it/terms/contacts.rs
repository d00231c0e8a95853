//! Contacts with deep penetration, active for all small random states.

use ancf::mechanics::bodies::BeamMesh;
use ancf::mechanics::contact::{BeamContact, ContactLaw, Obstacle, ObstacleContact, ObstacleShape};
use ancf::mechanics::kinematics::Attachment;
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

/// Returns contacts with their names and losses: all obstacle shapes on ground and body, beam on beam.
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
                let contact = ObstacleContact::new(&obstacle, &point, 0.3, 0.02, law).unwrap();
                cases.push((format!("contact: {form:?} on {carrier}, {what}"), Box::new(contact), loss));
            }
        }
        for (place, axis) in ["middle", "end"].into_iter().zip(b.element_axes()) {
            let contact = BeamContact::new(&point, &axis, [true; 2], 2.0, 0.02, law);
            cases.push((format!("contact: beams, {place}, {what}"), Box::new(contact), loss));
        }
    }
    cases
}
