//! Contact pairs of a model as searches for contact.

use std::sync::Arc;

use ancf_mechanics::bodies::{BeamMesh, BodyTerms};
use ancf_mechanics::contact::{BeamContacts, ContactLaw, ContactTube, Obstacle, ObstacleContacts};
use ancf_mechanics::kinematics::Attachment;
use ancf_solver::equations::{ContactSearch, State};
use nalgebra::Vector3;

use crate::model::{Contact, Model};

/// Depth of the transition, relative to the smallest radius.
const TRANSITION: f64 = 0.02;
/// Default slip speed, relative to length divided by duration.
const SLIP: f64 = 1e-3;

impl Contact {
    /// Contact law. `radius` is the smallest radius of the bodies.
    fn law(&self, model: &Model, radius: f64) -> ContactLaw {
        let creep = model.analysis.dynamics().map_or(1.0, |d| SLIP * model.length() / d.duration);
        ContactLaw {
            stiffness: self.stiffness,
            transition: self.transition.unwrap_or(TRANSITION * radius),
            damping: self.damping,
            friction: self.friction,
            slip_speed: self.slip_speed.unwrap_or(creep),
        }
    }
}

impl Model {
    /// Contact searches of a valid model. Bodies that overlap in the initial state are excluded as joined.
    pub(crate) fn encounters(
        &self,
        built: &[(String, BodyTerms)],
        begin: &State,
    ) -> Vec<Arc<dyn ContactSearch>> {
        let of = |contact: &Contact| -> Option<Arc<dyn ContactSearch>> {
            let bodies = contact.bodies(self).into_iter();
            let sized: Vec<_> = bodies
                .filter_map(|i| Some((built[i].1.mesh()?, contact.radius(self, &self.bodies[i])?)))
                .collect();
            let thinnest = sized.iter().map(|(_, radius)| *radius).fold(f64::INFINITY, f64::min);
            let skin = |&(mesh, radius): &(&BeamMesh, f64)| {
                let length = mesh.length() / mesh.count() as f64;
                ContactTube::new(mesh, radius, contact.points(length, radius))
            };
            let (skins, law) = (sized.iter().map(skin).collect::<Vec<_>>(), contact.law(self, thinnest));
            let Some(obstacle) = contact.with.obstacle() else {
                return Some(Arc::new(BeamContacts::new(skins, law).with_joined_pairs(begin)));
            };
            let (shape, point) = (obstacle.shape(), Vector3::from(obstacle.point()));
            let axis = obstacle.axis().map_or_else(Vector3::x, |(_, axis)| axis.into());
            let place = obstacle.on().map_or_else(
                || Attachment::ground(point),
                |place| {
                    let held = self.attachment(built, place);
                    let arm = point - held.point.reference();
                    held.offset(arm)
                },
            );
            Some(Arc::new(ObstacleContacts::new(&Obstacle::new(shape, place, axis)?, &skins, law)))
        };
        self.contacts.iter().filter_map(of).collect()
    }
}
