use ancf_solver::equations::{Local, LocalMatrix, Term, Weights, load_power};
use nalgebra::{Matrix3, Vector3};

use super::hermite::{Shape, VECTORS, bicubic};
use super::mesh::ShellMesh;
use super::profile::{POINTS, integration_points, sum};
use crate::functions::Function;

/// Pressure on an element that follows its normal: adds −s f(t) p ∫ N_a r_ξ × r_η dξ dη.
///
/// A positive pressure acts along r_ξ × r_η. The load has no potential at a free edge. Its derivative is not symmetric there; the
/// tangent contains the symmetric part. The work counts as supplied work.
#[derive(Clone, Debug)]
pub struct SurfacePressure {
    coordinates: Vec<usize>,
    /// Reference values of r_ξ and r_η at the integration points.
    reference: Vec<[Vector3<f64>; 2]>,
    pressure: f64,
    function: Function,
}

/// Values of the shape functions at a point: N, N_ξ, N_η.
fn shapes(at: [f64; 2]) -> [Shape; 3] {
    [[0, 0], [1, 0], [0, 1]].map(|order| bicubic(at, order))
}

fn vectors(x: &[f64]) -> [Vector3<f64>; VECTORS] {
    std::array::from_fn(|i| Vector3::new(x[3 * i], x[3 * i + 1], x[3 * i + 2]))
}

impl SurfacePressure {
    /// Creates the pressure, times a function of time, on all elements of a mesh.
    pub fn on(mesh: &ShellMesh, pressure: f64, function: &Function) -> Vec<Self> {
        let of = |element: &super::element::Shell48| Self {
            coordinates: element.coordinates().to_vec(),
            reference: element.profile().points.iter().map(|p| [p.reference[0], p.reference[1]]).collect(),
            pressure,
            function: function.clone(),
        };
        mesh.elements().iter().map(of).collect()
    }

    fn factor(&self, at: &Local<'_>) -> f64 {
        at.load * self.function.value(at.t) * self.pressure
    }

    /// Calls `visit` with the shape functions, the weight and the tangents of each integration point.
    fn each(&self, q: &[f64], mut visit: impl FnMut(&[Shape; 3], f64, [Vector3<f64>; 2])) {
        let q = vectors(q);
        for (k, (at, weight)) in integration_points().into_iter().enumerate().take(POINTS) {
            let shapes = shapes(at);
            let [t, s] = self.reference[k];
            visit(&shapes, weight, [t + sum(&shapes[1], &q), s + sum(&shapes[2], &q)]);
        }
    }

    /// Adds blocks ∂f_a/∂q_b of the force without its sign and factor.
    fn derivative(&self, q: &[f64]) -> Box<[[Matrix3<f64>; VECTORS]; VECTORS]> {
        let mut blocks = Box::new([[Matrix3::zeros(); VECTORS]; VECTORS]);
        self.each(q, |[n, x, y], weight, [t, s]| {
            let (t, s) = (t.cross_matrix(), s.cross_matrix());
            for b in 0..VECTORS {
                let turned = t * y[b] - s * x[b];
                for a in 0..VECTORS {
                    blocks[a][b] += turned * (weight * n[a]);
                }
            }
        });
        blocks
    }
}

impl Term for SurfacePressure {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let factor = -self.factor(at);
        self.each(at.q, |[n, ..], weight, [t, s]| {
            let force = t.cross(&s) * (factor * weight);
            for (a, n) in n.iter().enumerate() {
                (0..3).for_each(|i| r[3 * a + i] += n * force[i]);
            }
        });
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (factor, q) = (self.factor(at).abs(), vectors(at.q));
        for (k, (place, weight)) in integration_points().into_iter().enumerate() {
            let [n, x, y] = shapes(place);
            let size = |shape: &Shape| -> f64 { shape.iter().zip(&q).map(|(n, q)| n.abs() * q.norm()).sum() };
            let [t, s] = self.reference[k];
            let bound = 8.0 * f64::EPSILON * (t.norm() + size(&x)) * (s.norm() + size(&y)) * factor * weight;
            for (a, n) in n.iter().enumerate() {
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
        for row in 0..3 * VECTORS {
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
        for row in 0..3 * VECTORS {
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
