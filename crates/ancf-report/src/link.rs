use ancf::mechanics::Attachment;
use ancf::model::{Body, Joint, PointSpring};
use ancf::system::State;
use nalgebra::Vector3;

use crate::place::Places;

/// A line between two points: what a joint without a body of its own is seen as.
pub(crate) struct Link {
    pub name: String,
    pub kind: &'static str,
    ends: [Attachment; 2],
}

impl Link {
    /// Where its ends are, in the solver's units.
    pub fn ends(&self, s: &State) -> [Vector3<f64>; 2] {
        self.ends.each_ref().map(|end| end.point.value(s))
    }
}

/// Springs, dampers, ropes, rods, mounts, and the arms by which rigid bodies reach their joints.
pub(crate) fn links(places: Places<'_>) -> Vec<Link> {
    let mut all = Vec::new();
    for joint in &places.model.joints {
        let kind = match joint {
            Joint::Spring(PointSpring { tension_only: true, .. }) => "rope",
            Joint::Spring(PointSpring { stiffness: 0.0, .. }) => "damper",
            Joint::Spring(_) => "spring",
            Joint::Distance(_) => "rod",
            Joint::Bushing(_) => "bushing",
            _ => "",
        };
        let Some(ends) = places.ends(joint) else { continue };
        all.extend(arms(places, joint, &ends));
        if !kind.is_empty() {
            all.push(Link { name: joint.name().to_owned(), kind, ends });
        }
    }
    all
}

/// Lines from the centres of rigid bodies to the ends of a joint that are elsewhere.
fn arms(places: Places<'_>, joint: &Joint, ends: &[Attachment; 2]) -> Vec<Link> {
    let (a, b) = joint.ends();
    let places_of = [Some(a), if let ancf::model::End::Place(place) = b { Some(place) } else { None }];
    let arm = |(place, end): (Option<&ancf::model::Place>, &Attachment)| {
        let body =
            places.model.bodies.iter().find(|body| Some(body.name()) == place.map(|p| p.body.as_str()));
        let Some(Body::Rigid(rigid)) = body else { return None };
        let number = places.model.bodies.iter().position(|body| body.name() == rigid.name)?;
        let centre = places.assembly.body_of(number).attachment(0.0, Vector3::from(rigid.center));
        let apart = (centre.point.reference() - end.point.reference()).norm() > 0.0;
        apart.then(|| Link { name: rigid.name.clone(), kind: "arm", ends: [centre, end.clone()] })
    };
    places_of.into_iter().zip(ends).filter_map(arm).collect()
}
