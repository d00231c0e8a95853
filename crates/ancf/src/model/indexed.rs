//! Model with an index of its names.

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};
use std::ops::Deref;

use nalgebra::Vector3;

use crate::joints::{Coupled, End, Joint, JointContext, JointCoordinate};
use crate::loads::LoadContext;
use crate::model::Model;
use crate::model::bodies::{Body, Place};
use crate::model::functions::LawSignal;
use crate::model::sections::{Material, Section};

/// Model with an index of its names: bodies and joints are found in constant time.
///
/// Of equal names the first one counts.
pub(crate) struct IndexedModel<'m> {
    model: &'m Model,
    bodies: HashMap<&'m str, usize>,
    joints: HashMap<&'m str, usize>,
    /// Free coordinates of joints that are parts of couplings.
    coupled: OnceCell<HashSet<(usize, JointCoordinate)>>,
    length: OnceCell<f64>,
}

impl Model {
    /// Reference length: length of the longest flexible body.
    ///
    /// Without flexible bodies, twice the largest distance of rigid bodies and joints from their mean, or the largest radius of
    /// gyration. For a single point mass without a joint elsewhere, the distance that it moves freely during the analysis; 1 if it
    /// is at rest.
    pub fn length(&self) -> f64 {
        IndexedModel::new(self).length()
    }
}

impl Deref for IndexedModel<'_> {
    type Target = Model;

    fn deref(&self) -> &Model {
        self.model
    }
}

impl<'m> IndexedModel<'m> {
    /// Indexes the names of a model.
    pub(crate) fn new(model: &'m Model) -> Self {
        Self {
            model,
            bodies: indices(model.bodies.iter().map(Body::name)),
            joints: indices(model.joints.iter().map(|joint| joint.name())),
            coupled: OnceCell::new(),
            length: OnceCell::new(),
        }
    }

    /// Returns the number of the body of a name.
    pub(crate) fn body_number(&self, name: &str) -> Option<usize> {
        self.bodies.get(name).copied()
    }

    /// Returns the number of the joint of a name.
    pub(crate) fn joint_number(&self, name: &str) -> Option<usize> {
        self.joints.get(name).copied()
    }

    /// Returns the body of a name, with its path.
    pub(crate) fn named(&self, name: &str) -> Option<(String, &'m Body)> {
        let number = self.body_number(name)?;
        Some((format!("bodies[{number}]"), &self.model.bodies[number]))
    }

    /// Point of a place in the reference state; `None` if the place does not exist.
    pub(crate) fn point(&self, place: &Place) -> Option<Vector3<f64>> {
        let body = &self.model.bodies[self.body_number(&place.body)?];
        Some(body.point(&place.at)? + Vector3::from(place.offset))
    }

    /// Point of the second end of a joint in the reference state; `None` for the ground without a point, and if the place does not
    /// exist.
    pub(crate) fn end_point(&self, end: &End) -> Option<Vector3<f64>> {
        match end {
            End::Ground => None,
            End::Place(place) => self.point(place),
            End::Point(ground) => Some(Vector3::from(ground.point)),
        }
    }

    /// Reference length ([`Model::length`]), computed once.
    pub(crate) fn length(&self) -> f64 {
        *self.length.get_or_init(|| self.computed_length())
    }

    fn computed_length(&self) -> f64 {
        let longest = self.bodies().map(Body::length).fold(0.0, f64::max);
        if longest > 0.0 {
            return longest;
        }
        let gyration = self.bodies().filter_map(|body| match body {
            Body::Rigid(rigid) => Some((rigid.tensor().trace() / rigid.mass).sqrt()),
            _ => None,
        });
        let extent = gyration.fold(self.extent(), f64::max);
        if extent > 0.0 {
            return extent;
        }
        let distance = self.free_distance();
        if distance > 0.0 { distance } else { 1.0 }
    }

    /// Twice the largest distance of a centre of a body or an end of a joint from their mean.
    fn extent(&self) -> f64 {
        let centres = self.bodies().map(|body| Vector3::from(body.span()[0]));
        let ends = self.model.joints.iter().map(Joint::ends);
        let ends = ends.flat_map(|(a, b)| [self.point(a), self.end_point(b)]);
        let mut points: Vec<Vector3<f64>> = centres.chain(ends.flatten()).collect();
        // Relative to one of them, equal points have no distance by rounding.
        let origin = points.first().copied().unwrap_or_default();
        points.iter_mut().for_each(|point| *point -= origin);
        let mean = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
        2.0 * points.iter().map(|point| (point - mean).norm()).fold(0.0, f64::max)
    }

    /// Largest distance that a body without loads other than gravity moves during the analysis: |v₀| T or |g| T².
    fn free_distance(&self) -> f64 {
        let duration = self.model.analysis.dynamics().map_or(0.0, |dynamics| dynamics.duration);
        let speeds = self.bodies().map(|body| Vector3::from(body.motion().velocity).norm());
        let fall = Vector3::from(self.model.gravity).norm() * duration;
        speeds.fold(fall, f64::max) * duration
    }

    fn bodies(&self) -> impl Iterator<Item = &'m Body> {
        self.model.bodies.iter()
    }

    /// Number of the joint and free coordinate in a part of a coupling; `None` if they do not exist.
    pub(crate) fn coupled_coordinate(&self, part: &Coupled) -> Option<(usize, JointCoordinate)> {
        let joint = self.joint_number(&part.joint)?;
        let free = self.model.joints[joint].kind().free_coordinates();
        let coordinate = part.of.or_else(|| free.first().copied())?;
        free.contains(&coordinate).then_some((joint, coordinate))
    }

    /// True if a coupling contains a free coordinate of a joint, or a force law reads it as an angle with counted turns.
    pub(crate) fn is_coupled(&self, joint: usize, coordinate: JointCoordinate) -> bool {
        let coupled = self.coupled.get_or_init(|| {
            let parts = self.model.couplings.iter().flat_map(|coupling| &coupling.joints);
            let signals = self.model.laws().flat_map(|(_, one)| one.law.signals());
            let angles = signals.filter_map(|signal| self.angle_of(signal));
            parts.filter_map(|part| self.coupled_coordinate(part)).chain(angles).collect()
        });
        coupled.contains(&(joint, coordinate))
    }

    /// Angle of a joint that is a signal, by its value or rate.
    fn angle_of(&self, signal: &LawSignal) -> Option<(usize, JointCoordinate)> {
        let (name, column) = signal.value.rsplit_once('.')?;
        let joint = self.joint_number(name).filter(|_| matches!(column, "angle" | "rate"))?;
        Some((joint, JointCoordinate::Angle))
    }
}

fn indices<'m>(names: impl Iterator<Item = &'m str>) -> HashMap<&'m str, usize> {
    let mut indices = HashMap::new();
    for (number, name) in names.enumerate() {
        indices.entry(name).or_insert(number);
    }
    indices
}

impl JointContext for IndexedModel<'_> {
    fn body(&self, place: &Place) -> Option<&Body> {
        self.body_number(&place.body).map(|number| &self.model.bodies[number])
    }

    fn point(&self, place: &Place) -> Option<Vector3<f64>> {
        Self::point(self, place)
    }

    fn length(&self) -> f64 {
        Self::length(self)
    }

    fn starts_undeformed(&self) -> bool {
        Model::starts_undeformed(self)
    }

    fn end_time(&self) -> f64 {
        Model::end_time(self)
    }
}

impl LoadContext for IndexedModel<'_> {
    fn body(&self, name: &str) -> Option<(String, &Body)> {
        self.named(name)
    }

    fn section(&self, name: &str) -> Option<&Section> {
        self.sections.get(name)
    }

    fn section_at(&self, body: &Body, fraction: f64) -> Option<Section> {
        Model::section_at(self, body, fraction)
    }

    fn material(&self, name: &str) -> Option<&Material> {
        self.materials.get(name)
    }

    fn gravity(&self) -> [f64; 3] {
        self.gravity
    }

    fn length(&self) -> f64 {
        Self::length(self)
    }
}
