use std::f64::consts::{PI, TAU};

use ancf::solver::equations::State;
use nalgebra::Vector3;

use super::grid::{Cell, Cells};
use crate::geometry::{DrawnShape, Obstacle, Placement, bounding_box};
use crate::scene::SceneLayout;

/// Number of sides of spheres and cylinders.
const SIDES: usize = 32;
/// Half of the edge of a plane, relative to the size of the model.
const HALF_EDGE: f64 = 0.75;

/// Surfaces of all obstacles: squares for planes, spheres, and parts of cylinders.
#[derive(Debug, Default)]
pub(super) struct ObstacleSurfaces {
    /// Index of the obstacle and components along its three directors.
    points: Vec<(usize, [f64; 3])>,
    pub cells: Cells,
}

impl ObstacleSurfaces {
    /// Surfaces of a model, given the placement of its bodies in a state.
    pub fn new(layout: &SceneLayout<'_>, reference: &Placement, s: &State) -> Self {
        let mut all = Self::default();
        for (number, obstacle) in layout.obstacles.iter().enumerate() {
            match obstacle.kind {
                DrawnShape::Plane => all.plane(number, layout, obstacle, reference, s),
                DrawnShape::Sphere => all.sphere(number, obstacle.radius),
                DrawnShape::Cylinder => {
                    let part = obstacle.drawn_part(s, reference, layout.size);
                    let [middle, length] = part.unwrap_or([0.0, layout.size]);
                    all.cylinder(number, obstacle.radius, [middle - 0.5 * length, middle + 0.5 * length]);
                }
            }
        }
        all
    }

    /// Positions of the points in a state.
    pub fn positions(&self, layout: &SceneLayout<'_>, s: &State) -> Vec<Vector3<f64>> {
        let poses: Vec<_> = layout.obstacles.iter().map(|obstacle| obstacle.pose(s)).collect();
        let at = |(number, [x, y, z]): &(usize, [f64; 3])| {
            let (point, [a, b, c]) = poses[*number];
            point + a * *x + b * *y + c * *z
        };
        self.points.iter().map(at).collect()
    }

    /// Adds a square around the projection of the centre of the model onto a plane.
    fn plane(&mut self, n: usize, layout: &SceneLayout<'_>, of: &Obstacle, reference: &Placement, s: &State) {
        let [low, high] = bounding_box(reference.centres.iter().copied());
        let (point, [_, y, z]) = of.pose(s);
        let apart = 0.5 * (low + high) - point;
        let (y, z, half) = (apart.dot(&y), apart.dot(&z), HALF_EDGE * layout.size);
        let first = self.points.len();
        for [v, w] in [[-half, -half], [half, -half], [half, half], [-half, half]] {
            self.points.push((n, [0.0, y + v, z + w]));
        }
        self.cells.push(Cell::Quad, first..first + 4, n);
    }

    fn cylinder(&mut self, number: usize, radius: f64, ends: [f64; 2]) {
        let first = self.points.len();
        for x in ends {
            self.ring(number, x, radius);
        }
        self.wall(number, first);
    }

    fn sphere(&mut self, number: usize, radius: f64) {
        let first = self.points.len();
        let rows = SIDES / 2;
        for k in 1..rows {
            let (sin, cos) = (PI * k as f64 / rows as f64).sin_cos();
            self.ring(number, -radius * cos, radius * sin);
        }
        for k in 0..rows - 2 {
            self.wall(number, first + k * SIDES);
        }
        for (x, ring, reversed) in [(-radius, first, true), (radius, first + (rows - 2) * SIDES, false)] {
            let pole = self.points.len();
            self.points.push((number, [x, 0.0, 0.0]));
            for i in 0..SIDES {
                let mut corners = [pole, ring + i, ring + (i + 1) % SIDES];
                if reversed {
                    corners.reverse();
                }
                self.cells.push(Cell::Triangle, corners, number);
            }
        }
    }

    fn ring(&mut self, number: usize, x: f64, radius: f64) {
        let at = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / SIDES as f64).sin_cos();
            (number, [x, radius * cos, radius * sin])
        };
        self.points.extend((0..SIDES).map(at));
    }

    /// Adds quads between a ring and the next one.
    fn wall(&mut self, number: usize, first: usize) {
        for i in 0..SIDES {
            let (i, j) = (first + i, first + (i + 1) % SIDES);
            self.cells.push(Cell::Quad, [i, j, j + SIDES, i + SIDES], number);
        }
    }
}
