use ancf_surface::Triangles;

use super::grid::Cell;
use super::mesh::{Mesh, Point};
use crate::geometry::{BodyKind, BodyShape, Geometry, Outline, SurfaceGrid};

impl Mesh {
    /// Mesh of the closed surfaces of all bodies, with cells counter-clockwise as seen from outside.
    pub fn surfaces(geometry: &Geometry<'_>) -> Self {
        let mut mesh = Self::default();
        for (number, shape) in geometry.bodies.iter().enumerate() {
            if let Some(triangles) = &shape.surface {
                mesh.triangles(number, shape, triangles);
                continue;
            }
            match (&shape.outline, shape.half_edges) {
                (Some(outline), _) => mesh.sweep(number, shape, outline),
                _ if let Some(grid) = &shape.grid => mesh.plate(number, shape, grid),
                (None, Some(half)) if shape.kind == BodyKind::PointMass => {
                    mesh.octahedron(number, shape, half);
                }
                (None, half) => mesh.cuboid(number, shape, half.unwrap_or_default()),
            }
        }
        mesh
    }

    /// Adds both faces and the edges of a shell.
    fn plate(&mut self, number: usize, shape: &BodyShape, grid: &SurfaceGrid) {
        let first = self.points.len();
        for half in [grid.half, -grid.half] {
            let point = |(k, station)| Point { station, arm: [half * shape.scale_at(k)[0], 0.0, 0.0] };
            self.points.extend(shape.stations.clone().enumerate().map(point));
        }
        let below = first + shape.stations.len();
        for corners in grid.cells() {
            self.quad(number, corners.map(|k| first + k), false);
            self.quad(number, corners.map(|k| below + k), true);
        }
        let boundary = grid.boundary();
        let stride = grid.counts[0] * grid.counts[1];
        let edges = (0..grid.patches * boundary.len()).map(|k| {
            let start = k / boundary.len() * stride;
            [k, k + 1].map(|k| start + boundary[k % boundary.len()])
        });
        for [a, b] in edges {
            self.quad(number, [below + a, below + b, first + b, first + a], false);
        }
    }

    /// Adds an outline swept along the stations of a body, closed at both ends.
    fn sweep(&mut self, number: usize, shape: &BodyShape, outline: &Outline) {
        let rings = shape.stations.len();
        let ends = [0, rings.saturating_sub(1)];
        let (outer, sides) = self.rings(shape, &outline.outer, |k| shape.scale_at(k));
        self.wall(number, outer, sides, rings, false);
        let Some(inner) = &outline.inner else {
            let [start, end] = ends.map(|k| outer + k * sides..outer + (k + 1) * sides);
            self.cells.push(Cell::Polygon, start.rev(), number);
            self.cells.push(Cell::Polygon, end, number);
            return;
        };
        // Both outlines of a tube have the same number of points, so that quads close the ring between them.
        let (inner, sides) = self.rings(shape, inner, |k| [shape.bore_at(k); 2]);
        self.wall(number, inner, sides, rings, true);
        for (k, reversed) in ends.into_iter().zip([true, false]) {
            let (outer, inner) = (outer + k * sides, inner + k * sides);
            for i in 0..sides {
                let j = (i + 1) % sides;
                self.quad(number, [outer + i, outer + j, inner + j, inner + i], reversed);
            }
        }
    }

    /// Adds the points of an outline at each station with its factors of y and z. Returns the index of the first point and the
    /// number of points per station.
    fn rings(
        &mut self,
        shape: &BodyShape,
        outline: &[[f64; 4]],
        scale: impl Fn(usize) -> [f64; 2],
    ) -> (usize, usize) {
        let corners = corners(outline);
        let first = self.points.len();
        for (k, station) in shape.stations.clone().enumerate() {
            let [sy, sz] = scale(k);
            let at = |[y, z]: &[f64; 2]| Point { station, arm: [0.0, y * sy, z * sz] };
            self.points.extend(corners.iter().map(at));
        }
        (first, corners.len())
    }

    fn wall(&mut self, number: usize, first: usize, sides: usize, rings: usize, reversed: bool) {
        for k in 1..rings {
            let (before, after) = (first + (k - 1) * sides, first + k * sides);
            for i in 0..sides {
                let j = (i + 1) % sides;
                self.quad(number, [before + i, before + j, after + j, after + i], reversed);
            }
        }
    }

    fn quad(&mut self, number: usize, mut corners: [usize; 4], reversed: bool) {
        if reversed {
            corners.reverse();
        }
        self.cells.push(Cell::Quad, corners, number);
    }

    /// Adds the triangles of a body.
    fn triangles(&mut self, number: usize, shape: &BodyShape, triangles: &Triangles) {
        let (first, station) = (self.points.len(), shape.stations.start);
        self.points.extend(triangles.points.iter().map(|&arm| Point { station, arm }));
        for corners in &triangles.corners {
            self.cells.push(Cell::Triangle, corners.map(|corner| first + corner as usize), number);
        }
    }

    /// Adds a box around the first station of a body.
    fn cuboid(&mut self, number: usize, shape: &BodyShape, [a, b, c]: [f64; 3]) {
        let (first, station) = (self.points.len(), shape.stations.start);
        for x in [-a, a] {
            for [y, z] in [[-b, -c], [b, -c], [b, c], [-b, c]] {
                self.points.push(Point { station, arm: [x, y, z] });
            }
        }
        self.quad(number, [0, 1, 2, 3].map(|k| first + k), true);
        self.quad(number, [4, 5, 6, 7].map(|k| first + k), false);
        self.wall(number, first, 4, 2, false);
    }

    /// Adds an octahedron around the first station of a body.
    fn octahedron(&mut self, number: usize, shape: &BodyShape, half: [f64; 3]) {
        let (first, station) = (self.points.len(), shape.stations.start);
        for (k, half) in half.into_iter().enumerate() {
            for along in [-half, half] {
                let mut arm = [0.0; 3];
                arm[k] = along;
                self.points.push(Point { station, arm });
            }
        }
        for octant in 0..8 {
            let [x, y, z] = [octant & 1, (octant >> 1) & 1, (octant >> 2) & 1];
            let mut corners = [first + x, first + 2 + y, first + 4 + z];
            // Each reflection reverses the orientation of the triangle.
            if (x + y + z) % 2 == 0 {
                corners.reverse();
            }
            self.cells.push(Cell::Triangle, corners, number);
        }
    }
}

/// Points of an outline without duplicates.
fn corners(outline: &[[f64; 4]]) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = outline.iter().map(|[y, z, ..]| [*y, *z]).collect();
    corners.dedup();
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    corners
}
