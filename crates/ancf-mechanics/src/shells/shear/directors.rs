//! Directors of the nodes of a mesh from its geometry.

use nalgebra::{Matrix2, Matrix2x3, Vector3};

use super::faces::{Face, MeshTopology};

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
///
/// The slope is that of least squares. It is zero in directions without extent.
fn extrapolated(point: &Vector3<f64>, samples: &[[Vector3<f64>; 2]], normal: &Vector3<f64>) -> Vector3<f64> {
    let count = samples.len() as f64;
    let middle = samples.iter().map(|[x, _]| x).sum::<Vector3<f64>>() / count;
    let mean = samples.iter().map(|[_, n]| n).sum::<Vector3<f64>>() / count;
    let across = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
    let plane = Matrix2x3::from_rows(&[across.transpose(), normal.cross(&across).transpose()]);
    // Normal equations of two columns: a decomposition of all three has a column without extent.
    let (mut square, mut product) = (Matrix2::zeros(), Matrix2x3::zeros());
    for [x, n] in samples {
        let arm = plane * (x - middle);
        square += arm * arm.transpose();
        product += arm * (n - mean).transpose();
    }
    let (axes, arm) = (square.symmetric_eigen(), plane * (point - middle));
    let least = FLAT * FLAT * axes.eigenvalues.max();
    let mut sum = mean;
    for (axis, value) in axes.eigenvectors.column_iter().zip(axes.eigenvalues.iter()) {
        if *value > least {
            sum += product.transpose() * axis * (axis.dot(&arm) / value);
        }
    }
    sum.normalize()
}

/// Axes of the first direction of stresses: the global ones, and others for surfaces with normals along all of these.
const AXES: [[f64; 3]; 6] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [0.36, 0.48, 0.8],
    [0.8, -0.36, 0.48],
    [-0.48, 0.8, 0.36],
];
/// Smallest sine of the angle between a global axis and the normals for which no other axis is considered.
const DISTINCT: f64 = 1e-2;

/// Returns the axis that is farthest from all unit normals: the first direction of stresses unless an axis is given.
///
/// It is a global axis unless each of these is close to a normal, as on a closed surface. Axes whose smallest angles to the normals
/// differ by rounding only count as equal; the first of them is returned.
pub fn stress_axis(normals: &[Vector3<f64>]) -> Vector3<f64> {
    let sine =
        |axis: &Vector3<f64>| normals.iter().map(|d| d.cross(axis).norm()).fold(f64::INFINITY, f64::min);
    let mut best = (Vector3::from(AXES[0]), sine(&Vector3::from(AXES[0])));
    for (k, axis) in AXES.into_iter().map(Vector3::from).enumerate().skip(1) {
        let own = sine(&axis);
        if own > best.1 + 1e-3 && (k < 3 || best.1 < DISTINCT) {
            best = (axis, own);
        }
    }
    best.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Warped patch of quadrilaterals and triangles.
    fn patch() -> (Vec<Vector3<f64>>, Vec<Face>) {
        let node = |i: u32, j: u32| {
            let (x, y) = (0.13 * f64::from(i), 0.17 * f64::from(j));
            let place = Vector3::new(x + 0.02 * y, y - 0.03 * x * y, 0.7 * x * x - 0.3 * x * y + 0.2 * y * y);
            nalgebra::Rotation3::from_euler_angles(0.4, -1.1, 2.3) * place
        };
        let nodes = (0..3).flat_map(|j| (0..4).map(move |i| node(i, j))).collect();
        let quads = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [4, 5, 9, 8]].map(Face::Quad);
        let triangles = [[5, 6, 10], [5, 10, 9]].map(Face::Triangle);
        let last = [[6, 7, 11, 10]].map(Face::Quad);
        (nodes, quads.into_iter().chain(triangles).chain(last).collect())
    }

    /// Directors do not depend on units, and change by rounding errors with nodes that do.
    #[test]
    fn directors_are_accurate_to_rounding() {
        let (nodes, faces) = patch();
        let expected = directors(&nodes, &faces);
        for scale in [0.3, 1e-3, 0.999_999_9, 7.0] {
            let scaled: Vec<_> = nodes.iter().map(|x| x * scale).collect();
            let found = directors(&scaled, &faces);
            let largest = found.iter().zip(&expected).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            assert!(largest < 1e-14, "{scale}: {largest:e}");
        }
    }

    /// A linear field of normals is extrapolated exactly, up to the normalisation.
    #[test]
    fn linear_fields_are_extrapolated() {
        let normal = Vector3::new(0.48, 0.6, 0.64);
        let [t, s] = [Vector3::new(0.8, 0.0, -0.6), Vector3::new(-0.36, 0.8, -0.48)];
        let field = |x: &Vector3<f64>| normal + t * (0.3 * t.dot(x) - 0.2 * s.dot(x)) + s * (0.1 * t.dot(x));
        let places = [[0.0, 0.0], [1.0, 0.1], [0.2, 0.9], [1.3, 1.1]].map(|[a, b]| t * a + s * b);
        let samples: Vec<_> = places.iter().map(|x| [*x, field(x)]).collect();
        let point = t * -0.7 + s * 1.6 + normal * 0.4;
        let found = extrapolated(&point, &samples, &normal);
        assert!((found - field(&point).normalize()).norm() < 1e-14);
        // Places on a line have no slope across it.
        let line: Vec<_> = [0.0, 0.4, 1.0].map(|a| [t * a, field(&(t * a))]).into();
        let found = extrapolated(&(t * 2.0 + s * 0.5), &line, &normal);
        assert!((found - field(&(t * 2.0)).normalize()).norm() < 1e-14);
    }
}
