//! Checks of the shapes of rigid bodies in pictures.

use crate::errors::{Finding, finding, number, quoted};
use crate::model::{Body, DisplayShape, IndexedModel, bodies_of};

/// Checks the sizes of shapes and the endings of mesh files. The files themselves are read by the program that draws them.
pub(crate) fn shapes(model: &IndexedModel<'_>) -> Vec<Finding> {
    let of_body = |(path, body): (String, &Body)| {
        let Body::Rigid(rigid) = body else { return Vec::new() };
        let rule = |(k, shape)| rule_of_shape(&format!("{path}.display[{k}]"), shape);
        rigid.display.iter().enumerate().filter_map(rule).collect()
    };
    bodies_of(model).flat_map(of_body).collect()
}

fn rule_of_shape(path: &str, shape: &DisplayShape) -> Option<Finding> {
    match shape {
        DisplayShape::Box { edges, .. } if edges.iter().any(|edge| *edge <= 0.0) => {
            let found = format!("[{}]", edges.map(number).join(", "));
            Some(finding(format!("{path}.edges"), found, "three numbers > 0"))
        }
        DisplayShape::Cylinder { from, to, .. } if from == to => Some(
            finding(format!("{path}.to"), "a cylinder of length 0", "an end away from the other one")
                .rests_on([format!("{path}.from")]),
        ),
        DisplayShape::Mesh { file, .. } if !DisplayShape::is_mesh_file(file) => Some(finding(
            format!("{path}.file"),
            quoted(file),
            "a file name that ends in .stl, .gltf or .glb",
        )),
        _ => None,
    }
}
