use nalgebra::Vector3;

use super::grid::{Cell, Cells};
use crate::geometry::{Geometry, Placement};

/// Point fixed to the directors of a station.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// Index of the station.
    pub station: usize,
    /// Components from the centre of the station along its three directors.
    pub arm: [f64; 3],
}

/// Points fixed to stations, and cells between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Mesh {
    pub points: Vec<Point>,
    pub cells: Cells,
}

impl Mesh {
    /// Mesh of the axes of beams and cables, and the centres of rigid bodies; `None` without such bodies.
    pub fn lines(geometry: &Geometry<'_>) -> Option<Self> {
        let mut mesh = Self::default();
        for (number, shape) in geometry.bodies.iter().enumerate().filter(|(_, shape)| shape.grid.is_none()) {
            let first = mesh.points.len();
            mesh.points.extend(shape.stations.clone().map(|station| Point { station, arm: [0.0; 3] }));
            let kind = if shape.stations.len() > 1 { Cell::Polyline } else { Cell::Vertex };
            mesh.cells.push(kind, first..mesh.points.len(), number);
        }
        (!mesh.points.is_empty()).then_some(mesh)
    }

    /// Mesh of the middle surfaces of shells; `None` without shells.
    pub fn shells(geometry: &Geometry<'_>) -> Option<Self> {
        let mut mesh = Self::default();
        for (number, shape) in geometry.bodies.iter().enumerate() {
            let Some(grid) = &shape.grid else { continue };
            let first = mesh.points.len();
            mesh.points.extend(shape.stations.clone().map(|station| Point { station, arm: [0.0; 3] }));
            for corners in grid.cells() {
                mesh.cells.push(Cell::Quad, corners.map(|k| first + k), number);
            }
        }
        (!mesh.points.is_empty()).then_some(mesh)
    }
}

/// Evaluates points in a placement: x = c + Σ arm_k d_k. In place of positions, the placement may have their rates.
pub(super) fn positions(points: &[Point], of: &Placement) -> Vec<Vector3<f64>> {
    let at = |point: &Point| {
        let [a, b, c] = of.directors[point.station];
        let [x, y, z] = point.arm;
        of.centres[point.station] + a * x + b * y + c * z
    };
    points.iter().map(at).collect()
}
