use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{Matrix3, Vector3};

use super::face::{Face, NODES, Shape, ShapeValues};
use super::mesh::ShearShellMesh;
use crate::functions::Function;

/// Pressure on an element of N nodes that follows its normal: adds −s f(t) p ∫ N_a r_ξ × r_η dξ dη.
///
/// A positive pressure acts along r_ξ × r_η. The load has no potential at a free edge. Its derivative is not symmetric there; the
/// tangent contains the symmetric part. The work counts as supplied work.
#[derive(Clone, Debug)]
struct FacePressure<const N: usize> {
    shape: Shape,
    coordinates: Vec<usize>,
    /// Positions of the nodes in the reference state, relative to the first one.
    reference: [Vector3<f64>; N],
    pressure: f64,
    function: Function,
}

fn vectors<const N: usize>(x: &[f64]) -> [Vector3<f64>; N] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

fn sum(weights: &[f64; NODES], x: &[Vector3<f64>]) -> Vector3<f64> {
    x.iter().zip(weights).map(|(x, weight)| x * *weight).sum()
}

/// Returns the pressure, times a function of time, on an element of a mesh.
pub fn face_pressure(
    mesh: &ShearShellMesh,
    element: usize,
    pressure: f64,
    function: &Function,
) -> Box<dyn Term> {
    match mesh.faces()[element] {
        Face::Triangle(nodes) => {
            Box::new(FacePressure::new(mesh, Shape::Triangle, nodes, pressure, function))
        }
        Face::Quad(nodes) => Box::new(FacePressure::new(mesh, Shape::Quad, nodes, pressure, function)),
    }
}

impl<const N: usize> FacePressure<N> {
    fn new(
        mesh: &ShearShellMesh,
        shape: Shape,
        nodes: [usize; N],
        pressure: f64,
        function: &Function,
    ) -> Self {
        let corner = mesh.nodal(nodes[0], 0).1;
        Self {
            shape,
            coordinates: nodes.iter().flat_map(|n| (0..3).map(|i| mesh.nodal(*n, 0).0 + i)).collect(),
            reference: nodes.map(|n| mesh.nodal(n, 0).1 - corner),
            pressure,
            function: function.clone(),
        }
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t) * self.pressure
    }

    /// Calls `visit` with the shape functions, the weight and the tangents of each integration point.
    fn each(&self, q: &[f64], mut visit: impl FnMut(&ShapeValues, f64, [Vector3<f64>; 2])) {
        let q: [Vector3<f64>; N] = vectors(q);
        for (at, weight) in self.shape.points() {
            let shapes = self.shape.values(*at);
            let [t, s] = [1, 2].map(|k| sum(&shapes[k], &self.reference) + sum(&shapes[k], &q));
            visit(&shapes, *weight, [t, s]);
        }
    }

    /// Returns blocks ∂f_a/∂q_b of the force without its sign and factor.
    fn derivative(&self, q: &[f64]) -> [[Matrix3<f64>; N]; N] {
        let mut blocks = [[Matrix3::zeros(); N]; N];
        self.each(q, |[n, x, y], weight, [t, s]| {
            let (t, s) = (t.cross_matrix(), s.cross_matrix());
            for b in 0..N {
                let turned = t * y[b] - s * x[b];
                for a in 0..N {
                    blocks[a][b] += turned * (weight * n[a]);
                }
            }
        });
        blocks
    }
}

impl<const N: usize> Term for FacePressure<N> {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let factor = -self.factor(at);
        self.each(at.q, |[n, ..], weight, [t, s]| {
            let force = t.cross(&s) * (factor * weight);
            for (a, n) in n[..N].iter().enumerate() {
                (0..3).for_each(|i| r[3 * a + i] += n * force[i]);
            }
        });
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (factor, q) = (self.factor(at).abs(), vectors::<N>(at.q));
        for (place, weight) in self.shape.points() {
            let [n, x, y] = self.shape.values(*place);
            let size = |shape: &[f64; NODES]| -> f64 {
                let parts = shape.iter().zip(&q).zip(&self.reference);
                parts.map(|((n, q), x)| n.abs() * (q.norm() + x.norm())).sum()
            };
            let bound = 8.0 * f64::EPSILON * size(&x) * size(&y) * factor * weight;
            for (a, n) in n[..N].iter().enumerate() {
                (0..3).for_each(|i| floor[3 * a + i] += n.abs() * bound);
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let factor = -0.5 * w.q * self.factor(at);
        if factor == 0.0 {
            return;
        }
        let blocks = self.derivative(at.q);
        for row in 0..3 * N {
            for column in 0..=row {
                let (a, i, b, j) = (row / 3, row % 3, column / 3, column % 3);
                k.add(row, column, factor * (blocks[a][b][(i, j)] + blocks[b][a][(j, i)]));
            }
        }
    }

    fn skew_stiffness(&self, at: &Local<'_>, visit: &mut dyn FnMut(usize, usize, f64)) {
        let (factor, blocks) = (-0.5 * self.factor(at), self.derivative(at.q));
        if factor == 0.0 {
            return;
        }
        let largest = blocks.iter().flatten().map(|block| block.amax()).fold(0.0, f64::max);
        for row in 0..3 * N {
            for column in 0..row {
                let (a, i, b, j) = (row / 3, row % 3, column / 3, column % 3);
                let value = blocks[a][b][(i, j)] - blocks[b][a][(j, i)];
                if value.abs() > 1e-14 * largest {
                    visit(row, column, factor * value);
                }
            }
        }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        load_power(self, at)
    }

    fn is_damped(&self) -> bool {
        false
    }
}
