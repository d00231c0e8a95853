use ancf::assembly::Assembly;
use ancf::mechanics::kinematics::Attachment;
use ancf::model::{End, Joint, Place};
use ancf::{Model, Simulation};
use nalgebra::Vector3;

/// Resolves places of joints, loads, probes and obstacles to attachments.
#[derive(Clone, Copy)]
pub(crate) struct Attachments<'a> {
    /// Model in the units of the solver.
    pub model: &'a Model,
    pub assembly: &'a Assembly,
    /// Unit of length of the solver in that of the user.
    pub length: f64,
}

impl<'a> Attachments<'a> {
    /// `scaled` is the model in the units of the solver.
    pub fn new(scaled: &'a Model, simulation: &'a Simulation) -> Self {
        Self { model: scaled, assembly: simulation.assembly(), length: simulation.scales().length }
    }

    /// Returns the attachment of a place; `None` if the body has no such place.
    pub fn of(&self, place: &Place) -> Option<Attachment> {
        let number = self.model.bodies.iter().position(|body| body.name() == place.body)?;
        let body = &self.model.bodies[number];
        let (s, mut point) = (body.arc_length(&place.at), body.point(&place.at)?);
        if let Some(at) = body.shell_place(&place.at) {
            point = at.parameters();
        }
        let attachment = self.assembly.body_of(number).attachment(s, point);
        Some(if place.offset == [0.0; 3] {
            attachment
        } else {
            attachment.offset(Vector3::from(place.offset))
        })
    }

    /// Returns both ends of a joint. An end on the ground is at the first end in the undeformed state, unless it has a point.
    pub fn ends(&self, joint: &Joint) -> Option<[Attachment; 2]> {
        let (a, b) = joint.ends();
        let a = self.of(a)?;
        let b = match b {
            End::Ground => Attachment::ground(a.point.reference()),
            End::Place(place) => self.of(place)?,
            End::Point(ground) => Attachment::ground(Vector3::from(ground.point)),
        };
        Some([a, b])
    }
}
