use std::f64::consts::{PI, TAU};

use ancf::system::State;
use nalgebra::Vector3;

use super::grid::{Cell, Cells};
use crate::Placement;
use crate::obstacle::Obstacle;
use crate::pack::reach;
use crate::stage::{Stage, bounds};

/// Sides of what is round.
const SIDES: usize = 32;
/// Half of the edge of a plane, over the size of the model.
const HALF: f64 = 0.75;

/// The surfaces of all obstacles: a square of a plane as large as the model, a sphere, a part of a cylinder.
#[derive(Debug, Default)]
pub(super) struct Obstacles {
    /// Numbers of obstacles, and places along their three axes.
    points: Vec<(usize, [f64; 3])>,
    pub cells: Cells,
}

impl Obstacles {
    /// Those of a model whose bodies are here.
    pub fn new(stage: &Stage<'_>, reference: &Placement, s: &State) -> Self {
        let mut all = Self::default();
        for (number, obstacle) in stage.obstacles.iter().enumerate() {
            let radius = obstacle.radius * stage.length();
            match obstacle.kind {
                "plane" => all.plane(number, stage, obstacle, reference, s),
                "sphere" => all.sphere(number, radius),
                _ => {
                    let [middle, length] = reach(stage, obstacle, reference).unwrap_or([0.0, stage.size]);
                    all.cylinder(number, radius, [middle - 0.5 * length, middle + 0.5 * length]);
                }
            }
        }
        all
    }

    /// Where its points are in a state.
    pub fn spread(&self, stage: &Stage<'_>, s: &State) -> Vec<Vector3<f64>> {
        let poses: Vec<_> = stage.obstacles.iter().map(|obstacle| obstacle.pose(s)).collect();
        let at = |(number, [x, y, z]): &(usize, [f64; 3])| {
            let (point, [a, b, c]) = poses[*number];
            point * stage.length() + a * *x + b * *y + c * *z
        };
        self.points.iter().map(at).collect()
    }

    /// A square about the foot of the model's middle.
    fn plane(&mut self, n: usize, stage: &Stage<'_>, of: &Obstacle, reference: &Placement, s: &State) {
        let [low, high] = bounds(reference.centres.iter().copied());
        let (point, [_, y, z]) = of.pose(s);
        let apart = 0.5 * (low + high) - point * stage.length();
        let (y, z, half) = (apart.dot(&y), apart.dot(&z), HALF * stage.size);
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

    /// Quads from a ring to the next one.
    fn wall(&mut self, number: usize, first: usize) {
        for i in 0..SIDES {
            let (i, j) = (first + i, first + (i + 1) % SIDES);
            self.cells.push(Cell::Quad, [i, j, j + SIDES, i + SIDES], number);
        }
    }
}
