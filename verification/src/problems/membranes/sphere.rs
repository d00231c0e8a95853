//! Eighth of a sphere of quadrilaterals with three planes of symmetry.

use std::f64::consts::FRAC_PI_4;

use crate::problems::shear_shells::mesh::{MeshModel, edge};

/// Eighth of the unit sphere of 3 n² elements, with the edges `e0`, `e1` and `e2` in the planes of symmetry.
pub(super) fn eighth(n: usize, thickness: f64, material: String) -> MeshModel {
    // Square from the middle of a side of the cube to a corner, projected by equal angles.
    let side = |axis: usize| {
        move |place: [f64; 2]| {
            let mut point = [0.0; 3];
            let [u, v] = place.map(|x| (FRAC_PI_4 * x).tan());
            (point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3]) = (1.0, u, v);
            let length = point.iter().map(|x| x * x).sum::<f64>().sqrt();
            let point = point.map(|x| x / length);
            [point, point]
        }
    };
    let mesh = MeshModel::patches(n, thickness, material, &[&side(0), &side(1), &side(2)]);
    (0..3).fold(mesh, |mesh, k| {
        mesh.with_edge(&format!("e{k}"), move |x| (x[k] == 0.0).then_some(x[(k + 1) % 3]))
    })
}

/// Supports by planes of symmetry at named edges.
pub(super) fn planes(edges: &[&str]) -> String {
    edges.iter().map(|name| edge(name, "\"symmetry\"")).collect()
}
