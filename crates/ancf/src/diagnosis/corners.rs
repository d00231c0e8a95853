use ancf_mechanics::kinematics::ReferenceCurve;
use nalgebra::Vector3;

use crate::joints::{ClampedGradients, End, Joint};
use crate::model::{At, Body, IndexedModel, Model, Place};

/// Sine of the angle beyond which sections meet at an angle: 5°.
const CORNER: f64 = 0.0872;

/// Describes clamps with `fix = "all"` between sections that meet at an angle, one sentence each.
///
/// Equal gradients then equate the axial strain of one beam and the strains of the section of the other one. The reaction on the
/// gradients deforms the end sections by an amount that depends on the mesh.
pub(crate) fn corner_warnings(model: &Model) -> Vec<String> {
    let model = &IndexedModel::new(model);
    let corners = model.joints.iter().filter_map(|joint| {
        let Joint::Clamp(clamp) = joint else { return None };
        let End::Place(b) = &clamp.b else { return None };
        let [a, b] = [section(model, &clamp.a)?, section(model, b)?];
        let is_corner = a.iter().zip(b).any(|(a, b)| (a - b).norm() > CORNER);
        (clamp.fix == Some(ClampedGradients::All) && is_corner).then_some(&clamp.name)
    });
    let text = |name: &String| {
        format!(
            "clamp `{name}`: `fix = \"all\"` equates the strains of sections that meet at an angle, an error that depends on the \
             mesh; `fix = \"section\"` keeps the angle only"
        )
    };
    corners.map(text).collect()
}

/// Directions of the section of a beam at a place; `None` for other bodies.
fn section(model: &IndexedModel<'_>, place: &Place) -> Option<[Vector3<f64>; 3]> {
    let (_, body) = model.named(&place.body)?;
    let Body::Beam(beam) = body else { return None };
    let (curve, up): (ReferenceCurve, _) = (body.curve()?, body.up()?);
    let nodes = curve.nodes(up, beam.twist, &[0.0, body.arc_length(&place.at)]);
    let is_on_axis = !matches!(place.at, At::Point(_));
    nodes.last().filter(|_| is_on_axis).map(|node| node.frame)
}
