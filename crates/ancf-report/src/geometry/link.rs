use ancf::joints::JointSymbol;
use ancf::mechanics::kinematics::{Attachment, BodyVector};
use ancf::model::Place;
use ancf::solver::equations::State;
use ancf::{Model, Simulation};
use ancf_surface::BodySurfaces;
use nalgebra::Vector3;

use super::arms::{arm_to, places};
use super::attachments::Attachments;

/// Line between two attached points: a massless joint, or the arm of a rigid body.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name of the joint; of an arm, name of the rigid body.
    pub name: String,
    /// Kind in the scene, such as `"spring"`; arms have the kind `"arm"`.
    pub kind: &'static str,
    ends: [BodyVector; 2],
    length: f64,
}

/// Kind of the line from the centre of a rigid body to the end of a joint.
pub const ARM: &str = "arm";

impl Link {
    fn new(name: &str, kind: &'static str, ends: [Attachment; 2], length: f64) -> Self {
        Self { name: name.to_owned(), kind, ends: ends.map(|end| end.point), length }
    }

    /// Positions of both ends in the user's units.
    pub fn ends(&self, s: &State) -> [Vector3<f64>; 2] {
        self.ends.each_ref().map(|end| end.value(s) * self.length)
    }
}

/// Returns the links of a model that is stated in the user's units.
pub fn model_links(model: &Model, simulation: &Simulation) -> Vec<Link> {
    links(Attachments::new(&model.scaled(&simulation.scales()), simulation), &BodySurfaces::default())
}

/// Returns the links of a model: springs, dampers, ropes, rods, bushings, and the arms of rigid bodies without a surface.
pub(crate) fn links(attachments: Attachments<'_>, surfaces: &BodySurfaces) -> Vec<Link> {
    let mut all = Vec::new();
    for joint in &attachments.model.joints {
        let Some(ends) = attachments.ends(joint) else { continue };
        let arm = |(place, end): (Option<&Place>, &Attachment)| arm(attachments, surfaces, place?, end);
        all.extend(places(joint).into_iter().zip(&ends).filter_map(arm));
        if let JointSymbol::Line(kind) = joint.kind().symbol() {
            all.push(Link::new(joint.name(), kind, ends, attachments.length));
        }
    }
    all
}

/// Link from the centre of a rigid body to the end of a joint elsewhere on it.
fn arm(
    attachments: Attachments<'_>,
    surfaces: &BodySurfaces,
    place: &Place,
    end: &Attachment,
) -> Option<Link> {
    let (rigid, _) = arm_to(attachments.model, place)?;
    let body = attachments.model.bodies.iter().position(|body| body.name() == place.body)?;
    if surfaces.get(body).is_some() {
        return None;
    }
    let centre = attachments.assembly.body_of(body).attachment(0.0, Vector3::from(rigid.center));
    Some(Link::new(&rigid.name, ARM, [centre, end.clone()], attachments.length))
}
