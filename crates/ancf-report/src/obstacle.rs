use ancf::mechanics::{self, Attachment, across};
use ancf::model::Against;
use ancf::system::State;
use nalgebra::Vector3;

use crate::frame::{Frame, frame, unit};
use crate::place::Places;

/// What bodies may touch besides each other.
pub(crate) struct Obstacle {
    pub name: String,
    pub kind: &'static str,
    /// In the solver's units; 0 of a plane.
    pub radius: f64,
    pub inside: bool,
    pub moves: bool,
    point: mechanics::Marker,
    axis: mechanics::Marker,
    second: mechanics::Marker,
}

impl Obstacle {
    /// Its point and three directors, the first of them its axis or normal, in the solver's units.
    pub fn pose(&self, s: &State) -> (Vector3<f64>, Frame) {
        (self.point.value(s), frame(self.axis.value(s), self.second.value(s)))
    }
}

/// The obstacles of a model.
pub(crate) fn obstacles(places: Places<'_>) -> Vec<Obstacle> {
    let contacts = places.model.contacts.iter().enumerate();
    contacts.filter_map(|(number, contact)| obstacle(places, number, &contact.with)).collect()
}

fn obstacle(places: Places<'_>, number: usize, with: &Against) -> Option<Obstacle> {
    let (kind, point, axis, radius, inside) = match *with {
        Against::Plane { point, normal, .. } => ("plane", point, normal, 0.0, false),
        Against::Sphere { center, radius, inside, .. } => ("sphere", center, [1.0, 0.0, 0.0], radius, inside),
        Against::Cylinder { point, axis, radius, inside, .. } => ("cylinder", point, axis, radius, inside),
        Against::Bodies => return None,
    };
    let point = Vector3::from(point);
    let held = match with.on() {
        None => Attachment::ground(point),
        Some(place) => {
            let held = places.attachment(place)?;
            let arm = point - held.point.reference();
            held.offset(arm)
        }
    };
    let axis = unit(Vector3::from(axis))?;
    Some(Obstacle {
        name: format!("contacts[{number}]"),
        kind,
        radius,
        inside,
        moves: with.on().is_some(),
        axis: held.direction(axis),
        second: held.direction(across(axis)[0]),
        point: held.point,
    })
}
