//! Contact pairs of a model as searches for contact.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::contact::{
    BeamContacts, ContactGeometry, ContactLaw, FaceContacts, Obstacle, ObstacleContacts, ThinContacts,
};
use ancf_mechanics::kinematics::{Attachment, Marker};
use ancf_solver::equations::{ContactSearch, State};
use nalgebra::Vector3;

use crate::model::{Contact, IndexedModel, Model, ObstacleKind};

/// Depth of the transition, relative to the smallest radius.
const TRANSITION: f64 = 0.02;
/// Default slip speed, relative to length divided by duration.
const SLIP: f64 = 1e-3;

/// Properties of the bodies in contact with each other.
#[derive(Debug, Default)]
pub(crate) struct MutualGeometry {
    /// Pairs of different bodies that overlap, so that parts of them have no contact.
    pub(crate) overlapping: BTreeSet<[usize; 2]>,
    /// Shells whose thickness varies, with the largest relative deviation of their surfaces from half the thickness.
    pub(crate) deviations: BTreeMap<usize, f64>,
}

impl Contact {
    /// Contact law with a stiffness. `radius` is the smallest radius of the bodies.
    fn law(&self, model: &Model, stiffness: f64, radius: f64) -> ContactLaw {
        let creep = model.analysis.dynamics().map_or(1.0, |d| SLIP * model.length() / d.duration);
        ContactLaw {
            stiffness,
            transition: self.transition.unwrap_or(TRANSITION * radius),
            damping: self.damping,
            friction: self.friction,
            slip_speed: self.slip_speed.unwrap_or(creep),
        }
    }
}

impl IndexedModel<'_> {
    /// Contact geometry of a body: a tube with a radius, the surface of a shell, or the balls of a rigid body.
    fn contact_geometry(&self, contact: &Contact, body: usize, terms: &BodyTerms) -> Option<ContactGeometry> {
        let own = &self.bodies[body];
        let thickness = own.layup().map_or(0.0, |layup| layup.thickness);
        let points = |size: f64| contact.points(size, 0.5 * thickness, true);
        match terms {
            BodyTerms::Flexible(mesh) => {
                let radius = contact.radius(self, own)?;
                let length = mesh.length() / mesh.count() as f64;
                return Some(ContactGeometry::tube(mesh, radius, contact.points(length, radius, false)));
            }
            BodyTerms::Shell(mesh) => {
                return Some(ContactGeometry::shell(mesh, thickness, points(mesh.largest_side())));
            }
            BodyTerms::ShearShell(mesh) => {
                return Some(ContactGeometry::shear_shell(mesh, thickness, points(mesh.largest_side())));
            }
            BodyTerms::Rigid(_) => {}
        }
        let (surface, [centre, _]) = (own.surface()?, own.span());
        // Points of rigid bodies and masses are linear in the coordinates.
        let marker = |point| terms.attachment(0.0, point).point.linear().clone();
        let points: Vec<Marker> = surface.centres(centre).into_iter().map(marker).collect();
        let turning = terms.attachment(0.0, Vector3::from(centre)).axes().cloned();
        Some(ContactGeometry::of_points(points, turning, surface.radius, surface.size(centre)))
    }

    /// Geometry of the bodies of a contact with their numbers: lines and points, and shells.
    fn contact_bodies(
        &self,
        contact: &Contact,
        built: &[(String, BodyTerms)],
    ) -> [Vec<(usize, ContactGeometry)>; 2] {
        let bodies = contact.bodies(self);
        [false, true].map(|is_shell| {
            let own = bodies.iter().copied().filter(|i| self.bodies[*i].is_shell() == is_shell);
            own.filter_map(|i| Some((i, self.contact_geometry(contact, i, &built[i].1)?))).collect()
        })
    }

    /// Bodies with their names, and their undeformed state.
    fn undeformed(&self) -> (Vec<(String, BodyTerms)>, State) {
        let built = self.meshes();
        let begin = State::rest(built.iter().map(|(_, terms)| terms.coordinates()).sum(), 0);
        (built, begin)
    }

    /// Properties of the bodies in contact with each other, in the undeformed state.
    pub(crate) fn mutual_geometry(&self) -> MutualGeometry {
        let mutual = || self.contacts.iter().filter(|contact| contact.with.obstacle().is_none());
        let mut found = MutualGeometry::default();
        if mutual().next().is_none() {
            return found;
        }
        let (built, begin) = self.undeformed();
        for contact in mutual() {
            let [(lines, tubes), (shells, surfaces)] = self
                .contact_bodies(contact, &built)
                .map(|bodies| bodies.into_iter().unzip::<_, _, Vec<_>, Vec<_>>());
            let law = contact.law(self, 0.0, 1.0);
            let deviations = surfaces.iter().map(ContactGeometry::thickness_deviation);
            found.deviations.extend(shells.iter().copied().zip(deviations).filter(|(_, x)| *x > 0.0));
            let mut add = |joined: Vec<[usize; 2]>, own: &[usize], other: &[usize]| {
                let bodies = joined.into_iter().map(|[a, b]| [own[a], other[b]]).filter(|[a, b]| a != b);
                found.overlapping.extend(bodies.map(|[a, b]| [a.min(b), a.max(b)]));
            };
            for (numbers, sources) in [(&lines, &tubes), (&shells, &surfaces)] {
                let thin = ThinContacts::new(sources, &surfaces, law, &begin).joined_bodies();
                let faces = FaceContacts::new(sources, &surfaces, law, &begin).joined_bodies();
                [thin, faces].into_iter().for_each(|joined| add(joined, numbers, &shells));
            }
            add(BeamContacts::new(tubes, law, &begin).joined_bodies(), &lines, &lines);
        }
        found
    }

    /// Depths of bodies in obstacles in the undeformed state, relative to their radius or half thickness, with the numbers of the contact
    /// and the body.
    pub(crate) fn obstacle_depths(&self) -> Vec<(usize, usize, f64)> {
        if self.contacts.iter().all(|contact| contact.with.obstacle().is_none()) {
            return Vec::new();
        }
        let (built, begin) = self.undeformed();
        let of = |(number, contact): (usize, &Contact)| {
            let bodies: Vec<_> = self.contact_bodies(contact, &built).into_iter().flatten().collect();
            let (numbers, geometry): (Vec<usize>, Vec<ContactGeometry>) = bodies.into_iter().unzip();
            let search = contact.with.obstacle().and_then(|obstacle| {
                self.obstacle_contacts(obstacle, &built, &geometry, contact.law(self, 0.0, 1.0))
            });
            let depths = search.map_or_else(Vec::new, |search| search.depths(&begin));
            numbers.into_iter().zip(depths).map(|(body, depth)| (number, body, depth)).collect::<Vec<_>>()
        };
        self.contacts.iter().enumerate().flat_map(of).collect()
    }

    /// Contact searches of a valid model. Bodies that overlap in the initial state are excluded as joined.
    pub(crate) fn contact_searches(
        &self,
        built: &[(String, BodyTerms)],
        begin: &State,
    ) -> Vec<Arc<dyn ContactSearch>> {
        let of = |contact: &Contact| -> Vec<Arc<dyn ContactSearch>> {
            let [lines, shells] = self.contact_bodies(contact, built);
            let geometry = |bodies: Vec<(usize, ContactGeometry)>| -> Vec<ContactGeometry> {
                bodies.into_iter().map(|(_, geometry)| geometry).collect()
            };
            let (lines, shells) = (geometry(lines), geometry(shells));
            let radii = lines.iter().chain(&shells).map(ContactGeometry::margin);
            let thinnest = radii.fold(f64::INFINITY, f64::min);
            let law = |stiffness: Option<f64>| contact.law(self, stiffness.unwrap_or(0.0), thinnest);
            let laws = [law(contact.stiffness), law(contact.surface_stiffness)];
            let Some(obstacle) = contact.with.obstacle() else {
                return Self::mutual_contacts([lines, shells], laws, begin);
            };
            let parts = [lines, shells].into_iter().zip(laws).filter(|(bodies, _)| !bodies.is_empty());
            let searches =
                parts.filter_map(|(bodies, law)| self.obstacle_contacts(obstacle, built, &bodies, law));
            searches.map(|search| Arc::new(search) as Arc<dyn ContactSearch>).collect()
        };
        self.contacts.iter().flat_map(of).collect()
    }

    /// Contact searches of beams and shells with each other.
    ///
    /// Points of a shell touch the surfaces of all shells. Each shell is source and target, with half of the stiffness each.
    fn mutual_contacts(
        [lines, shells]: [Vec<ContactGeometry>; 2],
        [law, of_surfaces]: [ContactLaw; 2],
        begin: &State,
    ) -> Vec<Arc<dyn ContactSearch>> {
        let mut searches: Vec<Arc<dyn ContactSearch>> = Vec::new();
        let half = ContactLaw { stiffness: 0.5 * of_surfaces.stiffness, ..of_surfaces };
        let parts = [(&shells, half), (&lines, law)];
        for (sources, law) in parts.into_iter().filter(|(sources, _)| !sources.is_empty()) {
            if shells.iter().any(ContactGeometry::is_thin) {
                searches.push(Arc::new(ThinContacts::new(sources, &shells, law, begin)));
            }
            if shells.iter().any(ContactGeometry::has_faces) {
                searches.push(Arc::new(FaceContacts::new(sources, &shells, law, begin)));
            }
        }
        if !lines.is_empty() {
            searches.push(Arc::new(BeamContacts::new(lines, law, begin)));
        }
        searches
    }

    /// Contact search of some bodies with an obstacle.
    fn obstacle_contacts(
        &self,
        obstacle: &dyn ObstacleKind,
        built: &[(String, BodyTerms)],
        bodies: &[ContactGeometry],
        law: ContactLaw,
    ) -> Option<ObstacleContacts> {
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
        Some(ObstacleContacts::new(&Obstacle::new(shape, place, axis)?, bodies, law))
    }
}
