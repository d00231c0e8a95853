use nalgebra::Vector3;

use super::grid::{Cell, Cells};
use crate::{Geometry, Kind, Placement};

/// A point that goes with the section at a station.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// The number of the station.
    pub station: usize,
    /// From its centre, along its three directors.
    pub arm: [f64; 3],
}

/// Points that go with stations, and cells between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Mesh {
    pub points: Vec<Point>,
    pub cells: Cells,
}

impl Mesh {
    /// The closed surfaces of the bodies, cells counter-clockwise as seen from outside.
    pub fn sections(geometry: &Geometry<'_>) -> Self {
        let mut mesh = Self::default();
        for (number, drawn) in geometry.bodies.iter().enumerate() {
            match (&drawn.outline, drawn.half_edges) {
                (Some(outline), _) => mesh.sweep(number, drawn, outline),
                (None, Some(half)) if drawn.kind == Kind::Point => mesh.octahedron(number, drawn, half),
                (None, half) => mesh.cuboid(number, drawn, half.unwrap_or_default()),
            }
        }
        mesh
    }

    /// The axes of flexible bodies and the centres of rigid ones.
    pub fn lines(geometry: &Geometry<'_>) -> Self {
        let mut mesh = Self::default();
        for (number, drawn) in geometry.bodies.iter().enumerate() {
            let first = mesh.points.len();
            mesh.points.extend(drawn.stations.clone().map(|station| Point { station, arm: [0.0; 3] }));
            let kind = if drawn.stations.len() > 1 { Cell::Polyline } else { Cell::Vertex };
            mesh.cells.push(kind, first..mesh.points.len(), number);
        }
        mesh
    }

    /// Where its points are, of stations with vectors for their centres and three for their directors: of a placement, places.
    pub fn spread(&self, of: &Placement) -> Vec<Vector3<f64>> {
        let at = |point: &Point| {
            let [a, b, c] = of.directors[point.station];
            let [x, y, z] = point.arm;
            of.centres[point.station] + a * x + b * y + c * z
        };
        self.points.iter().map(at).collect()
    }
}
