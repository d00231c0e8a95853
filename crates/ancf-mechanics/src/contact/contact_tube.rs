use crate::bodies::BeamMesh;
use crate::kinematics::{ElementAxis, Marker};

/// Contact geometry of a body: a round tube about its axis, with equidistant points on it, or the balls of a rigid body.
#[derive(Clone, Debug)]
pub struct ContactTube {
    pub(super) axes: Vec<ElementAxis>,
    pub(super) points: Vec<Marker>,
    /// Number of points per element.
    pub(super) count: usize,
    /// Length of beam that each point represents.
    pub(super) length: f64,
    pub(super) radius: f64,
    /// Search margin.
    pub(super) margin: f64,
}

/// Search margin of points without a radius, relative to the size of their body.
const POINT_MARGIN: f64 = 0.05;

impl ContactTube {
    /// Creates the tube of a body with a radius and a number of points per element.
    pub fn new(mesh: &BeamMesh, radius: f64, count: usize) -> Self {
        let all = mesh.count() * count;
        let length = mesh.length() / all as f64;
        let points = (0..all).map(|i| mesh.point((i as f64 + 0.5) * length)).collect();
        Self { axes: mesh.element_axes().collect(), points, count, length, radius, margin: radius }
    }

    /// Creates the balls of a rigid body about its points. They share the size of the body as the length.
    pub fn of_points(points: Vec<Marker>, radius: f64, size: f64) -> Self {
        let length = size / points.len() as f64;
        let count = points.len();
        Self { axes: Vec::new(), points, count, length, radius, margin: radius.max(POINT_MARGIN * size) }
    }

    /// Returns the radius, or the search margin of points without a radius.
    pub const fn margin(&self) -> f64 {
        self.margin
    }
}
