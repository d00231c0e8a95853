use ancf::mechanics::{Attachment, Marker};
use ancf::model::{Joint, Place, PointSpring};
use ancf::system::State;
use nalgebra::Vector3;

use super::arms::{arm_to, places};
use super::attachments::Attachments;

/// Line between two attached points: a massless joint, or the arm of a rigid body.
pub(crate) struct Link {
    /// Name of the joint; of an arm, name of the rigid body.
    pub name: String,
    pub kind: LinkKind,
    ends: [Marker; 2],
    length: f64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LinkKind {
    Spring,
    Damper,
    Rope,
    Rod,
    Bushing,
    /// From the centre of a rigid body to the end of a joint.
    Arm,
}

impl LinkKind {
    /// Word in the scene.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Spring => "spring",
            Self::Damper => "damper",
            Self::Rope => "rope",
            Self::Rod => "rod",
            Self::Bushing => "bushing",
            Self::Arm => "arm",
        }
    }

    /// Kind of a joint that is drawn as a line.
    const fn of(joint: &Joint) -> Option<Self> {
        match joint {
            Joint::Spring(PointSpring { tension_only: true, .. }) => Some(Self::Rope),
            Joint::Spring(PointSpring { stiffness: 0.0, .. }) => Some(Self::Damper),
            Joint::Spring(_) => Some(Self::Spring),
            Joint::Distance(_) => Some(Self::Rod),
            Joint::Bushing(_) => Some(Self::Bushing),
            _ => None,
        }
    }
}

impl Link {
    fn new(name: &str, kind: LinkKind, ends: [Attachment; 2], length: f64) -> Self {
        Self { name: name.to_owned(), kind, ends: ends.map(|end| end.point), length }
    }

    /// Positions of both ends in the user's units.
    pub fn ends(&self, s: &State) -> [Vector3<f64>; 2] {
        self.ends.each_ref().map(|end| end.value(s) * self.length)
    }
}

/// Returns the links of a model: springs, dampers, ropes, rods, bushings, and the arms of rigid bodies.
pub(crate) fn links(attachments: Attachments<'_>) -> Vec<Link> {
    let mut all = Vec::new();
    for joint in &attachments.model.joints {
        let Some(ends) = attachments.ends(joint) else { continue };
        let arm = |(place, end): (Option<&Place>, &Attachment)| arm(attachments, place?, end);
        all.extend(places(joint).into_iter().zip(&ends).filter_map(arm));
        all.extend(LinkKind::of(joint).map(|kind| Link::new(joint.name(), kind, ends, attachments.length)));
    }
    all
}

/// Link from the centre of a rigid body to the end of a joint elsewhere on it.
fn arm(attachments: Attachments<'_>, place: &Place, end: &Attachment) -> Option<Link> {
    let (rigid, _) = arm_to(attachments.model, place)?;
    let body = attachments.model.bodies.iter().position(|body| body.name() == place.body)?;
    let centre = attachments.assembly.body_of(body).attachment(0.0, Vector3::from(rigid.center));
    Some(Link::new(&rigid.name, LinkKind::Arm, [centre, end.clone()], attachments.length))
}
