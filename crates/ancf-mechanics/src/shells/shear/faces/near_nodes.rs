use std::collections::HashMap;

use nalgebra::Vector3;

/// Finds two of the given nodes whose distance is at most `distance`, by a grid of cells of this size: O(n) for few nodes in a cell.
pub(super) fn near_nodes(
    points: &[Vector3<f64>],
    nodes: impl Iterator<Item = usize>,
    distance: f64,
) -> Option<[usize; 2]> {
    let low = points.iter().copied().reduce(|low, point| low.inf(&point))?;
    let cell = |node: usize| <[f64; 3]>::from((points[node] - low) / distance).map(|x| x.floor() as i64);
    let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    for node in nodes {
        let own = cell(node);
        let around =
            (0..27).map(|k| [0, 1, 2].map(|i| own[i].saturating_add([k / 9, k / 3 % 3, k % 3][i] - 1)));
        let is_near = |other: &&usize| (points[node] - points[**other]).norm() <= distance;
        let near = around.filter_map(|cell| cells.get(&cell)?.iter().find(is_near)).next();
        if let Some(&other) = near {
            return Some([other.min(node), other.max(node)]);
        }
        cells.entry(own).or_default().push(node);
    }
    None
}
