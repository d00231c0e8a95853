use super::grid::Cell;
use super::mesh::{Mesh, Point};
use crate::{Drawn, Outline};

impl Mesh {
    /// An outline swept along the stations of a body, closed at both ends.
    pub(super) fn sweep(&mut self, number: usize, drawn: &Drawn, outline: &Outline) {
        let rings = drawn.stations.len();
        let ends = [0, rings.saturating_sub(1)];
        let (outer, sides) = self.rings(drawn, &outline.outer);
        self.wall(number, outer, sides, rings, false);
        let Some(inner) = &outline.inner else {
            let [start, end] = ends.map(|k| outer + k * sides..outer + (k + 1) * sides);
            self.cells.push(Cell::Polygon, start.rev(), number);
            self.cells.push(Cell::Polygon, end, number);
            return;
        };
        // Outlines of a tube have as many points: quads close the ring between them.
        let (inner, sides) = self.rings(drawn, inner);
        self.wall(number, inner, sides, rings, true);
        for (k, reversed) in ends.into_iter().zip([true, false]) {
            let (outer, inner) = (outer + k * sides, inner + k * sides);
            for i in 0..sides {
                let j = (i + 1) % sides;
                self.quad(number, [outer + i, outer + j, inner + j, inner + i], reversed);
            }
        }
    }

    /// The points of an outline at each station: the number of the first one, and how many they are at each.
    fn rings(&mut self, drawn: &Drawn, outline: &[[f64; 4]]) -> (usize, usize) {
        let corners = corners(outline);
        let first = self.points.len();
        for (k, station) in drawn.stations.clone().enumerate() {
            let [sy, sz] = drawn.scale_at(k);
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

    /// A box about the first station of a body.
    pub(super) fn cuboid(&mut self, number: usize, drawn: &Drawn, [a, b, c]: [f64; 3]) {
        let (first, station) = (self.points.len(), drawn.stations.start);
        for x in [-a, a] {
            for [y, z] in [[-b, -c], [b, -c], [b, c], [-b, c]] {
                self.points.push(Point { station, arm: [x, y, z] });
            }
        }
        self.quad(number, [0, 1, 2, 3].map(|k| first + k), true);
        self.quad(number, [4, 5, 6, 7].map(|k| first + k), false);
        self.wall(number, first, 4, 2, false);
    }

    /// An octahedron about the first station of a body.
    pub(super) fn octahedron(&mut self, number: usize, drawn: &Drawn, half: [f64; 3]) {
        let (first, station) = (self.points.len(), drawn.stations.start);
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
            // Each reflection turns the triangle over.
            if (x + y + z) % 2 == 0 {
                corners.reverse();
            }
            self.cells.push(Cell::Triangle, corners, number);
        }
    }
}

/// The points of an outline, each once.
fn corners(outline: &[[f64; 4]]) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = outline.iter().map(|[y, z, ..]| [*y, *z]).collect();
    corners.dedup();
    if corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    corners
}
