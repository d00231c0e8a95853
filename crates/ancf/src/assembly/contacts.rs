//! Contact pairs of a model as searches for contact.

use std::sync::Arc;

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::contact::{BeamContacts, ContactLaw, ContactTube, Obstacle, ObstacleContacts};
use ancf_mechanics::kinematics::{Attachment, Marker};
use ancf_solver::equations::{ContactSearch, State};
use nalgebra::Vector3;

use crate::model::{Contact, IndexedModel, Model};

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

impl IndexedModel<'_> {
    /// Contact geometry of a body: a tube with a radius, or the balls of a rigid body.
    fn tube(&self, contact: &Contact, body: usize, terms: &BodyTerms) -> Option<ContactTube> {
        let own = &self.bodies[body];
        if let Some(mesh) = terms.mesh() {
            let radius = contact.radius(self, own)?;
            let length = mesh.length() / mesh.count() as f64;
            return Some(ContactTube::new(mesh, radius, contact.points(length, radius)));
        }
        let (surface, [centre, _]) = (own.surface()?, own.span());
        // Points of rigid bodies and masses are linear in the coordinates.
        let marker = |point| terms.attachment(0.0, point).point.linear().clone();
        let points: Vec<Marker> = surface.centres(centre).into_iter().map(marker).collect();
        Some(ContactTube::of_points(points, surface.radius, surface.size(centre)))
    }

    /// Contact searches of a valid model. Bodies that overlap in the initial state are excluded as joined.
    pub(crate) fn encounters(
        &self,
        built: &[(String, BodyTerms)],
        begin: &State,
    ) -> Vec<Arc<dyn ContactSearch>> {
        let of = |contact: &Contact| -> Option<Arc<dyn ContactSearch>> {
            let tubes: Vec<ContactTube> =
                contact.bodies(self).into_iter().filter_map(|i| self.tube(contact, i, &built[i].1)).collect();
            let thinnest = tubes.iter().map(ContactTube::margin).fold(f64::INFINITY, f64::min);
            let law = contact.law(self, thinnest);
            let Some(obstacle) = contact.with.obstacle() else {
                return Some(Arc::new(BeamContacts::new(tubes, law).with_joined_pairs(begin)));
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
            Some(Arc::new(ObstacleContacts::new(&Obstacle::new(shape, place, axis)?, &tubes, law)))
        };
        self.contacts.iter().filter_map(of).collect()
    }
}
