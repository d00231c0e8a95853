use ancf::mechanics::bodies::normals_to;
use ancf::mechanics::contact::ObstacleShape;
use ancf::mechanics::kinematics::{Attachment, BodyVector};
use ancf::model::ContactSurface;
use ancf::solver::equations::State;
use nalgebra::Vector3;

use super::attachments::Attachments;
use super::stations::Placement;
use super::triad::{Triad, triad, unit};

/// Length by which a drawn cylinder extends beyond the bodies, relative to the size of the model.
const OVERHANG: f64 = 0.04;

/// Obstacle of a contact.
pub(crate) struct Obstacle {
    pub name: String,
    pub kind: DrawnShape,
    /// Radius in the user's units; 0 for a plane.
    pub radius: f64,
    /// True if the bodies are inside.
    pub inside: bool,
    /// True if a body carries the obstacle.
    pub moves: bool,
    point: BodyVector,
    axis: BodyVector,
    second: BodyVector,
    length: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DrawnShape {
    Plane,
    Sphere,
    Cylinder,
}

impl DrawnShape {
    /// Word in the scene.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Plane => "plane",
            Self::Sphere => "sphere",
            Self::Cylinder => "cylinder",
        }
    }
}

impl Obstacle {
    /// Point in the user's units and three directors. The first director is the axis or the normal.
    pub fn pose(&self, s: &State) -> (Vector3<f64>, Triad) {
        (self.point.value(s) * self.length, triad(self.axis.value(s), self.second.value(s)))
    }

    /// Centre and length of the drawn part of a cylinder along its axis, measured from its point.
    ///
    /// Cylinders are infinite. The drawn part is the range of the bodies in the `reference` placement, with some overhang.
    pub fn drawn_part(&self, initial: &State, reference: &Placement, size: f64) -> Option<[f64; 2]> {
        let (point, [axis, ..]) = self.pose(initial);
        let along = reference.centres.iter().map(|x| (x - point).dot(&axis)).filter(|x| x.is_finite());
        let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        let is_bounded = self.kind == DrawnShape::Cylinder && low <= high;
        is_bounded.then_some([0.5 * (low + high), high - low + 2.0 * OVERHANG * size])
    }
}

/// Returns the obstacles of a model.
pub(crate) fn obstacles(attachments: Attachments<'_>) -> Vec<Obstacle> {
    let contacts = attachments.model.contacts.iter().enumerate();
    contacts.filter_map(|(number, contact)| obstacle(attachments, number, &contact.with)).collect()
}

fn obstacle(attachments: Attachments<'_>, number: usize, with: &ContactSurface) -> Option<Obstacle> {
    let obstacle = with.obstacle()?;
    let (kind, radius, inside) = match obstacle.shape() {
        ObstacleShape::Plane => (DrawnShape::Plane, 0.0, false),
        ObstacleShape::Sphere { radius, inside } => (DrawnShape::Sphere, radius, inside),
        ObstacleShape::Cylinder { radius, inside } => (DrawnShape::Cylinder, radius, inside),
    };
    let axis = obstacle.axis().map_or([1.0, 0.0, 0.0], |(_, axis)| axis);
    let point = Vector3::from(obstacle.point());
    let carrier = match obstacle.on() {
        None => Attachment::ground(point),
        Some(place) => {
            let attachment = attachments.of(place)?;
            let arm = point - attachment.point.reference();
            attachment.offset(arm)
        }
    };
    let axis = unit(Vector3::from(axis))?;
    Some(Obstacle {
        name: format!("contacts[{number}]"),
        kind,
        radius: radius * attachments.length,
        inside,
        moves: obstacle.on().is_some(),
        axis: carrier.direction(axis),
        second: carrier.direction(normals_to(axis)[0]),
        point: carrier.point,
        length: attachments.length,
    })
}
