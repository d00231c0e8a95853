use nalgebra::{Matrix2, Vector2, Vector3};

use super::faces::{Face, NODES, Shape};
use super::mesh::SurfacePlace;
use crate::kinematics::{OffsetValues, SurfaceValues, closest_offset_point, closest_point};

/// Point of a mesh nearest to a given point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPoint {
    /// Place on the mesh.
    pub place: SurfacePlace,
    /// Distance from the given point.
    pub distance: f64,
}

/// Sum of the nodes with the weights of a shape function.
fn sum(shape: &[f64; NODES], x: &[Vector3<f64>]) -> Vector3<f64> {
    x.iter().zip(shape).map(|(x, weight)| x * *weight).sum()
}

/// Bound of 1 − s² for an offset that rises by s per length. A steeper one has its closest point at the larger end.
const STEEP: f64 = 1e-12;

/// Point of a triangle with the least distance |d| − e from its offset: below the point at e = 0, moved up the slope of e, or on an edge.
fn project_on_offset(point: &Vector3<f64>, x: &[Vector3<f64>], e: &[f64]) -> [f64; 2] {
    let (t, s, gap) = (x[1] - x[0], x[2] - x[0], point - x[0]);
    let gram = Matrix2::new(t.dot(&t), t.dot(&s), t.dot(&s), s.dot(&s));
    let slopes = Vector2::new(e[1] - e[0], e[2] - e[0]);
    if let Some(inverse) = gram.try_inverse() {
        let foot = inverse * Vector2::new(gap.dot(&t), gap.dot(&s));
        let rise = inverse * slopes;
        let height = (gap - t * foot.x - s * foot.y).norm();
        let at = foot + rise * (height / (1.0 - rise.dot(&slopes)).max(STEEP).sqrt());
        if at.min() >= 0.0 && at.sum() <= 1.0 {
            return [at.x, at.y];
        }
    }
    let corners = Shape::Triangle.corners();
    let on_edge = |a: usize| {
        let b = (a + 1) % 3;
        let along = along_offset_edge(point, [&x[a], &x[b]], [e[a], e[b]]);
        let at = [0, 1].map(|i| corners[a][i] + (corners[b][i] - corners[a][i]) * along);
        (at, (x[a] + (x[b] - x[a]) * along - point).norm() - e[a] - (e[b] - e[a]) * along)
    };
    let edges = [on_edge(0), on_edge(1), on_edge(2)];
    edges.into_iter().min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or([0.0; 2], |(at, _)| at)
}

/// Returns the place on an edge, from 0 to 1, with the least distance |d| − e from its offset, a cone.
pub(crate) fn along_offset_edge(
    point: &Vector3<f64>,
    [a, b]: [&Vector3<f64>; 2],
    [from, to]: [f64; 2],
) -> f64 {
    let (edge, d) = (b - a, point - a);
    let square = edge.norm_squared();
    let foot = d.dot(&edge) / square;
    // Sine of the slope of the cone.
    let sine = (to - from) / square.sqrt();
    let height = (d - edge * foot).norm();
    (foot + height * sine / ((1.0 - sine * sine).max(STEEP) * square).sqrt()).clamp(0.0, 1.0)
}

impl Shape {
    /// Finds (ξ, η) with the least distance |d| − e from the offset of an element, for the positions and the offsets e of its nodes.
    pub(crate) fn nearest_of_offset(self, point: &Vector3<f64>, x: &[Vector3<f64>], e: &[f64]) -> [f64; 2] {
        match self {
            Self::Triangle => project_on_offset(point, x, e),
            Self::Quad => {
                let values = |at| (self.surface_values(at, x), self.offset_values(at, e));
                closest_offset_point(point, [0.5; 2], values)
            }
        }
    }

    /// Computes an offset and its derivatives at (ξ, η), for the offsets of the nodes.
    pub(crate) fn offset_values(self, at: [f64; 2], e: &[f64]) -> OffsetValues {
        let sum = |weights: [f64; NODES]| e.iter().zip(weights).map(|(e, weight)| e * weight).sum();
        let [value, x, y] = self.values(at).map(sum);
        let twist = match self {
            Self::Triangle => 0.0,
            Self::Quad => e[0] - e[1] + e[2] - e[3],
        };
        [value, x, y, 0.0, 0.0, twist]
    }

    /// Finds (ξ, η) of the nearest point of an element, for the positions of its nodes.
    pub(crate) fn nearest(self, point: &Vector3<f64>, x: &[Vector3<f64>]) -> [f64; 2] {
        match self {
            Self::Triangle => project_on_offset(point, x, &[0.0; 3]),
            Self::Quad => closest_point(point, [0.5; 2], |at| self.surface_values(at, x)),
        }
    }

    /// Computes r, its derivatives and its second derivatives at (ξ, η), for the positions of the nodes.
    pub(crate) fn surface_values(self, at: [f64; 2], x: &[Vector3<f64>]) -> SurfaceValues {
        let [n, of_x, of_y] = self.values(at);
        let zero = Vector3::zeros();
        let twist = match self {
            Self::Triangle => zero,
            Self::Quad => x[0] - x[1] + x[2] - x[3],
        };
        [sum(&n, x), sum(&of_x, x), sum(&of_y, x), zero, zero, twist]
    }
}

impl NearestPoint {
    /// Finds the nearest point of a mesh. `None` for a mesh without elements.
    pub fn of(nodes: &[Vector3<f64>], elements: &[Face], point: &Vector3<f64>) -> Option<Self> {
        let mut best: Option<Self> = None;
        for (element, own) in elements.iter().enumerate() {
            let x = own.points(nodes);
            let middle = x.iter().sum::<Vector3<f64>>() / x.len() as f64;
            let radius = x.iter().map(|x| (x - middle).norm()).fold(0.0, f64::max);
            if best.is_some_and(|best| (point - middle).norm() - radius > best.distance) {
                continue;
            }
            let at = own.shape().nearest(point, &x);
            let distance = (sum(&own.weights(at), &x) - point).norm();
            if best.is_none_or(|best| distance < best.distance) {
                best = Some(Self { place: SurfacePlace { element, at: at.map(snapped) }, distance });
            }
        }
        best
    }
}

/// Distance from a coordinate line of a node that counts as rounding.
const ON_EDGE: f64 = 1e-9;

/// Rounds a coordinate to 0 or 1 if it is nearly there.
fn snapped(x: f64) -> f64 {
    if x < ON_EDGE {
        0.0
    } else if x > 1.0 - ON_EDGE {
        1.0
    } else {
        x
    }
}
