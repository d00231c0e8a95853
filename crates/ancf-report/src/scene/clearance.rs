use nalgebra::Vector3;

use crate::geometry::{BodyShape, Geometry};

/// Maximum change of the gap between two bodies by a shape, relative to the gap.
const CLOSING: f64 = 0.8;
/// Maximum number of points that are compared.
const POINTS: usize = 400;
/// Minimum ratio of the arc length between two points of a body to their distance. Nearer points belong to the same part.
const BEND: f64 = 3.0;
/// Minimum distance of two points relative to the sum of their radii. Nearer points belong to connected bodies.
const APART: f64 = 1.5;

/// Point of a body with its displacement by a shape.
struct Point {
    body: usize,
    /// Arc length from the start of the body; 0 in shells.
    arc: f64,
    radius: f64,
    at: Vector3<f64>,
    moved: Vector3<f64>,
}

/// Returns the largest factor of a shape by which no two bodies cross, or infinity.
///
/// `displacements` has three components of each station. Parts of one body that are far apart along its axis count as two bodies.
pub(super) fn largest_factor(
    geometry: &Geometry<'_>,
    centres: &[Vector3<f64>],
    displacements: &[f64],
) -> f64 {
    let points = points(geometry, centres, displacements);
    let mut factor = f64::INFINITY;
    for (i, a) in points.iter().enumerate() {
        for b in &points[..i] {
            let between = b.at - a.at;
            let (distance, radii) = (between.norm(), a.radius + b.radius);
            let connected = a.body == b.body && (a.arc - b.arc).abs() < BEND * distance;
            if connected || distance <= APART * radii {
                continue;
            }
            let closing = ((b.moved - a.moved).dot(&between) / distance).abs();
            if closing > 0.0 {
                factor = factor.min(CLOSING * (distance - radii) / closing);
            }
        }
    }
    factor
}

/// Evenly spaced stations of all bodies.
fn points(geometry: &Geometry<'_>, centres: &[Vector3<f64>], displacements: &[f64]) -> Vec<Point> {
    let stride = geometry.stations().div_ceil(POINTS).max(1);
    let mut points = Vec::new();
    for (body, shape) in geometry.bodies.iter().enumerate() {
        let mut arc = 0.0;
        for (k, station) in shape.stations.clone().enumerate() {
            // Parts of a shell count as connected.
            if k > 0 && shape.grid.is_none() {
                arc += (centres[station] - centres[station - 1]).norm();
            }
            if k % stride == 0 {
                let moved = Vector3::from_column_slice(&displacements[3 * station..3 * station + 3]);
                points.push(Point { body, arc, radius: radius(shape, k), at: centres[station], moved });
            }
        }
    }
    points
}

/// Half of the largest extent of the section at a station, of the thickness of a shell, or of the box of a rigid body.
fn radius(shape: &BodyShape, station: usize) -> f64 {
    let [sy, sz] = shape.scale_at(station);
    let of_outline = || shape.outline.as_ref().map(|outline| outline.half_extents);
    let of_box = || shape.half_edges.map(|[x, y, z]| [x.max(y), z]);
    if let Some(grid) = &shape.grid {
        return grid.half * sz;
    }
    of_outline().map(|[y, z]| [y * sy, z * sz]).or_else(of_box).map_or(0.0, |[y, z]| y.max(z))
}
