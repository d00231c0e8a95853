use ancf::Model;
use ancf::mechanics::Attachment;
use ancf::model::{Assembly, End, Joint, Place};
use nalgebra::Vector3;

/// Where joints, loads, probes and obstacles hold on to bodies.
#[derive(Clone, Copy)]
pub(crate) struct Places<'a> {
    /// The model in the solver's units.
    pub model: &'a Model,
    pub assembly: &'a Assembly,
}

impl Places<'_> {
    /// What a place holds on to; `None` if there is no such place.
    pub fn attachment(&self, place: &Place) -> Option<Attachment> {
        let number = self.model.bodies.iter().position(|body| body.name() == place.body)?;
        let body = &self.model.bodies[number];
        let (s, point) = (body.arc_length(place.at), body.point(place.at)?);
        let held = self.assembly.body_of(number).attachment(s, point);
        Some(if place.offset == [0.0; 3] { held } else { held.offset(Vector3::from(place.offset)) })
    }

    /// The two ends of a joint; the ground is held where the first end is in the undeformed state.
    pub fn ends(&self, joint: &Joint) -> Option<[Attachment; 2]> {
        let (a, b) = joint.ends();
        let a = self.attachment(a)?;
        let b = match b {
            End::Ground => Attachment::ground(a.point.reference()),
            End::Place(place) => self.attachment(place)?,
            End::Point(ground) => Attachment::ground(Vector3::from(ground.point)),
        };
        Some([a, b])
    }
}
