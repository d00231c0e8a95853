//! Directors of the nodes of a mesh from its geometry.

use nalgebra::{DMatrix, Matrix3, Vector3};

use super::face::Face;
use super::topology::MeshTopology;

/// Singular values, relative to the largest one, below which the elements around a node have no extent in a direction.
const FLAT: f64 = 1e-3;

/// Returns the unit directors of a mesh without defects, by the normals of its elements.
///
/// The director of an inner node is the mean of the normals of the elements there, at the node, weighted by their angles. The
/// director of a node on the boundary is extrapolated by a linear function of the place, which is fitted to the normals in the
/// middle of the elements around the node and of their neighbours: a mean would have an error of the first order there.
pub fn directors(nodes: &[Vector3<f64>], elements: &[Face]) -> Vec<Vector3<f64>> {
    let topology = MeshTopology::new(nodes.len(), elements);
    let boundary = topology.boundary(nodes.len());
    let middles: Vec<[Vector3<f64>; 2]> = (0..elements.len())
        .map(|k| {
            let x = elements[k].points(nodes);
            [x.iter().sum::<Vector3<f64>>() / x.len() as f64, elements[k].normal(nodes)]
        })
        .collect();
    let of_node = |node: usize| {
        let own = topology.at_node(node);
        if !boundary[node] {
            let weighted = own.iter().map(|&k| {
                let [t, s] = elements[k].corner_edges(elements[k].corner(node).unwrap_or(0), nodes);
                t.cross(&s).normalize() * t.cross(&s).norm().atan2(t.dot(&s))
            });
            return weighted.sum::<Vector3<f64>>().normalize();
        }
        let mut around: Vec<usize> = own
            .iter()
            .flat_map(|&k| elements[k].nodes())
            .flat_map(|&n| topology.at_node(n).iter().copied())
            .collect();
        around.sort_unstable();
        around.dedup();
        let samples: Vec<[Vector3<f64>; 2]> = around.iter().map(|&k| middles[k]).collect();
        let mean: Vector3<f64> = own.iter().map(|&k| middles[k][1]).sum();
        extrapolated(&nodes[node], &samples, &mean.normalize())
    };
    (0..nodes.len()).map(of_node).collect()
}

/// Extrapolates normals at places to a point, by a linear function of the components of the place normal to a direction.
fn extrapolated(point: &Vector3<f64>, samples: &[[Vector3<f64>; 2]], normal: &Vector3<f64>) -> Vector3<f64> {
    let count = samples.len() as f64;
    let middle = samples.iter().map(|[x, _]| x).sum::<Vector3<f64>>() / count;
    let mean = samples.iter().map(|[_, n]| n).sum::<Vector3<f64>>() / count;
    let project = Matrix3::identity() - normal * normal.transpose();
    let arms = DMatrix::from_fn(samples.len(), 3, |k, i| (project * (samples[k][0] - middle))[i]);
    let values = DMatrix::from_fn(samples.len(), 3, |k, i| samples[k][1][i] - mean[i]);
    let size = arms.amax();
    let svd = arms.try_svd(true, true, f64::EPSILON, 100);
    let slope = svd.and_then(|svd| svd.solve(&values, FLAT * size).ok()).map(|slope| {
        let arm = project * (point - middle);
        Vector3::from_fn(|i, _| (0..3).map(|j| arm[j] * slope[(j, i)]).sum())
    });
    (mean + slope.unwrap_or_else(Vector3::zeros)).normalize()
}

/// Returns the global axis that is farthest from all directors: the first direction of stresses unless an axis is given.
///
/// Axes whose smallest angles to the directors differ by rounding only count as equal; the first of them is returned.
pub fn stress_axis(directors: &[Vector3<f64>]) -> Vector3<f64> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let sine =
        |axis: &Vector3<f64>| directors.iter().map(|d| d.cross(axis).norm()).fold(f64::INFINITY, f64::min);
    let mut best = axes[0];
    for axis in &axes[1..] {
        if sine(axis) > sine(&best) + 1e-3 {
            best = *axis;
        }
    }
    best
}
