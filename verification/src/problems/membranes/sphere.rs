//! Eighth of a sphere of quadrilaterals with three planes of symmetry.

use std::fmt::Write;

/// Point of the unit sphere in the direction of a point.
fn projected(x: [f64; 3]) -> [f64; 3] {
    let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
    x.map(|x| if x.abs() < 1e-12 { 0.0 } else { x / length })
}

/// Text of the body `s` of radius 1 with 3 n² elements, of a given thickness, and its supports.
pub(super) fn eighth(n: usize, thickness: f64) -> String {
    let (mut nodes, mut elements): (Vec<[f64; 3]>, Vec<[usize; 4]>) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        let mut node = |i: usize, j: usize| {
            // Square from the middle of a side of the cube to a corner, projected by equal angles.
            let [u, v] = [i, j].map(|k| (std::f64::consts::FRAC_PI_4 * k as f64 / n as f64).tan());
            let mut place = [0.0; 3];
            (place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]) = (1.0, u, v);
            let place = projected(place);
            let is_same = |other: &[f64; 3]| (0..3).all(|k| (other[k] - place[k]).abs() < 1e-9);
            nodes.iter().position(is_same).unwrap_or_else(|| {
                nodes.push(place);
                nodes.len() - 1
            })
        };
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            elements.push([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| node(i, j)));
        }
    }
    let mut text = format!(
        "[[bodies]]\nkind = \"shear_shell\"\nname = \"s\"\nthickness = {thickness:?}\nmaterial = \"m\"\n\
         mesh.nodes = {nodes:?}\nmesh.elements = {elements:?}\nmesh.directors = {nodes:?}\n"
    );
    let sides = || elements.iter().flat_map(|cell| (0..4).map(|i| [cell[i], cell[(i + 1) % 4]]));
    let mut supports = String::new();
    for k in 0..3 {
        let edge: Vec<_> = sides().filter(|side| side.iter().all(|i| nodes[*i][k] == 0.0)).collect();
        let _ = writeln!(text, "mesh.groups.e{k} = {{ edges = {edge:?} }}");
        let _ = writeln!(
            supports,
            "[[joints]]\nkind = \"support\"\nname = \"s{k}\"\na = {{ body = \"s\", at = {{ edge = \"e{k}\" }} }}\ncondition = \"symmetry\""
        );
    }
    text + &supports
}
