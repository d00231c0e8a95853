use ancf::Model;
use ancf::model::{Body, End, Joint, Place, Rigid};
use nalgebra::Vector3;

/// Rigid arm from the centre of mass of a rigid body to the end of a joint.
#[derive(Clone, Debug, PartialEq)]
pub struct Arm {
    /// Name of the joint.
    pub joint: String,
    /// Vector from the centre of mass to the end of the joint in the undeformed state, in global axes.
    ///
    /// Axes of a rigid body coincide with the global axes in the undeformed state. In another state, the arm is Σ offset_k d_k
    /// with the directors d_k of the body.
    pub offset: [f64; 3],
}

/// Returns the arms of a rigid body, one for each joint end off its centre of mass, in the order of the joints.
///
/// The unit of length is that of the model. Other bodies have no arms.
pub fn arms(model: &Model, body: &str) -> Vec<Arm> {
    let of_joint = |joint: &Joint| {
        let own = places(joint).into_iter().flatten().filter(|place| place.body == body);
        let arm = |place: &Place| arm_to(model, place).map(|(_, offset)| offset.into());
        let offsets: Vec<[f64; 3]> = own.filter_map(arm).collect();
        offsets.into_iter().map(|offset| Arm { joint: joint.name().to_owned(), offset }).collect::<Vec<_>>()
    };
    model.joints.iter().flat_map(of_joint).collect()
}

/// Returns the places of both ends of a joint; the ground has none.
pub(crate) fn places(joint: &Joint) -> [Option<&Place>; 2] {
    let (a, b) = joint.ends();
    [Some(a), if let End::Place(place) = b { Some(place) } else { None }]
}

/// Returns the rigid body of a place and the vector from its centre to the place; `None` if the vector is zero.
pub(crate) fn arm_to<'a>(model: &'a Model, place: &Place) -> Option<(&'a Rigid, Vector3<f64>)> {
    let body = model.bodies.iter().find(|body| body.name() == place.body)?;
    let Body::Rigid(rigid) = body else { return None };
    let end = body.point(&place.at)? + Vector3::from(place.offset);
    let arm = end - Vector3::from(rigid.center);
    (arm != Vector3::zeros()).then_some((rigid, arm))
}
