//! Nodes and shape functions of an element.

use nalgebra::Vector3;
use smallvec::SmallVec;

use crate::kinematics::simpson_points;

/// Largest number of nodes of an element.
pub const NODES: usize = 4;

/// Values of the shape functions, and their derivatives by ξ and η, at a point. That of the fourth node of a triangle is zero.
pub(crate) type ShapeValues = [[f64; NODES]; 3];

/// Point (ξ, η) of an element with a weight.
pub(crate) type WeightedPoint = ([f64; 2], f64);

/// Nodes of an element, counter-clockwise seen from the side of the normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Face {
    /// Triangle.
    Triangle([usize; 3]),
    /// Quadrilateral.
    Quad([usize; 4]),
}

/// Shape of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Triangle ξ, η ≥ 0, ξ + η ≤ 1 with linear shape functions.
    Triangle,
    /// Unit square with bilinear shape functions.
    Quad,
}

impl Face {
    /// Creates a face of three or four nodes; `None` for other numbers.
    pub fn new(nodes: &[usize]) -> Option<Self> {
        match *nodes {
            [a, b, c] => Some(Self::Triangle([a, b, c])),
            [a, b, c, d] => Some(Self::Quad([a, b, c, d])),
            _ => None,
        }
    }

    /// Returns the nodes.
    pub fn nodes(&self) -> &[usize] {
        match self {
            Self::Triangle(nodes) => nodes,
            Self::Quad(nodes) => nodes,
        }
    }

    /// Returns the number of a node in the element.
    pub(crate) fn corner(&self, node: usize) -> Option<usize> {
        self.nodes().iter().position(|n| *n == node)
    }

    /// Returns the place of a node in the element.
    pub fn place_of(&self, node: usize) -> Option<[f64; 2]> {
        self.corner(node).map(|corner| self.shape().corners()[corner])
    }

    /// Returns the edges in their order around the element.
    pub fn edges(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let nodes = self.nodes();
        (0..nodes.len()).map(|a| [nodes[a], nodes[(a + 1) % nodes.len()]])
    }

    /// Returns the positions of the nodes.
    pub(crate) fn points(&self, nodes: &[Vector3<f64>]) -> SmallVec<[Vector3<f64>; NODES]> {
        self.nodes().iter().map(|node| nodes[*node]).collect()
    }

    /// Returns the unit normal in the middle, for given positions of all nodes.
    pub fn normal(&self, nodes: &[Vector3<f64>]) -> Vector3<f64> {
        match self.points(nodes)[..] {
            [a, b, c] => (b - a).cross(&(c - a)).normalize(),
            [a, b, c, d] => (c - a).cross(&(d - b)).normalize(),
            _ => Vector3::zeros(),
        }
    }

    /// Returns the edges that leave a corner, in the sense of the order of the nodes.
    pub(crate) fn corner_edges(&self, corner: usize, nodes: &[Vector3<f64>]) -> [Vector3<f64>; 2] {
        let (own, count) = (self.nodes(), self.nodes().len());
        [1, count - 1].map(|step| nodes[own[(corner + step) % count]] - nodes[own[corner]])
    }

    /// Returns the unit normals at the nodes.
    pub fn corner_normals(&self, nodes: &[Vector3<f64>]) -> SmallVec<[Vector3<f64>; NODES]> {
        let normal = |corner: usize| {
            let [t, s] = self.corner_edges(corner, nodes);
            t.cross(&s).normalize()
        };
        (0..self.nodes().len()).map(normal).collect()
    }

    /// Returns the area, as integrated in an element.
    pub fn area(&self, nodes: &[Vector3<f64>]) -> f64 {
        let x = self.points(nodes);
        self.shape().points().iter().map(|(at, weight)| weight * self.across(*at, &x).norm()).sum()
    }

    /// Returns r_ξ × r_η at a place, for given positions of the nodes of the face.
    fn across(&self, at: [f64; 2], x: &[Vector3<f64>]) -> Vector3<f64> {
        let [_, of_x, of_y] = self.shape().values(at);
        let sum = |weights: [f64; NODES]| x.iter().zip(weights).map(|(x, w)| x * w).sum::<Vector3<f64>>();
        sum(of_x).cross(&sum(of_y))
    }

    /// Returns the direction of the normal at a place, for given positions of all nodes. Its magnitude is the area per unit of ξ and η.
    pub fn normal_at(&self, at: [f64; 2], nodes: &[Vector3<f64>]) -> Vector3<f64> {
        self.across(at, &self.points(nodes))
    }

    /// Returns the places of an element at which its section is evaluated, with weights of the area, and its corners with the weight 0.
    pub fn section_places(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let corners = self.shape().corners().iter().map(|at| (*at, 0.0));
        let surface = self.shape().surface_points().iter().map(|(at, _)| (*at, 0.0));
        self.shape().points().iter().copied().chain(surface).chain(corners)
    }

    /// Returns the point of a grid over the unit square, mapped to the element. A triangle has the upper side of the square
    /// in its third node.
    pub fn grid_point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        match self {
            Self::Triangle(_) => [x * (1.0 - y), y],
            Self::Quad(_) => [x, y],
        }
    }

    /// Returns a grid of (2 `cells` + 1)² points with their weights, line by line, on the element and its edges.
    ///
    /// The rule is Simpson's on a quadrilateral. On a triangle it is exact for linear functions: the trapezoidal rule along lines, and
    /// across them the integrals of piecewise linear functions over the width 1 − y of the triangle.
    pub(crate) fn grid_rule(&self, cells: usize) -> Vec<WeightedPoint> {
        if let Self::Quad(_) = self {
            return simpson_points(cells).collect();
        }
        let last = 2 * cells;
        let h = 1.0 / last as f64;
        let along = |i: usize| if i == 0 || i == last { 0.5 * h } else { h };
        let across = |j: usize| {
            let width = 1.0 - j as f64 * h;
            match j {
                0 => 0.5 * h - h * h / 6.0,
                j if j == last => h * h / 6.0,
                _ => h * width,
            }
        };
        let points = (0..=last).flat_map(|j| (0..=last).map(move |i| (i, j)));
        points.map(|(i, j)| (self.grid_point([i as f64 * h, j as f64 * h]), along(i) * across(j))).collect()
    }

    /// Returns the weights of the nodes at a place.
    pub fn weights(&self, at: [f64; 2]) -> [f64; NODES] {
        self.shape().values(at)[0]
    }

    pub(crate) fn shape(&self) -> Shape {
        match self {
            Self::Triangle(_) => Shape::Triangle,
            Self::Quad(_) => Shape::Quad,
        }
    }
}

/// Coordinates of the Gauss points with two points along a side, from 0 to 1.
const NEAR: f64 = 0.211_324_865_405_187_13;
const FAR: f64 = 1.0 - NEAR;

const QUAD_POINTS: [WeightedPoint; 4] =
    [([NEAR, NEAR], 0.25), ([FAR, NEAR], 0.25), ([NEAR, FAR], 0.25), ([FAR, FAR], 0.25)];

/// Exact for polynomials of the second degree.
const TRIANGLE_POINTS: [WeightedPoint; 3] = [
    ([1.0 / 6.0, 1.0 / 6.0], 1.0 / 6.0),
    ([2.0 / 3.0, 1.0 / 6.0], 1.0 / 6.0),
    ([1.0 / 6.0, 2.0 / 3.0], 1.0 / 6.0),
];

/// Middle of the triangle, with its area.
const CENTROID: [WeightedPoint; 1] = [([1.0 / 3.0, 1.0 / 3.0], 0.5)];

impl Shape {
    /// Returns the number of nodes.
    pub(crate) const fn nodes(self) -> usize {
        match self {
            Self::Triangle => 3,
            Self::Quad => 4,
        }
    }

    /// Returns the places of the nodes.
    pub(crate) const fn corners(self) -> &'static [[f64; 2]] {
        match self {
            Self::Triangle => &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
            Self::Quad => &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        }
    }

    /// Returns the point in the middle.
    pub(crate) const fn middle(self) -> [f64; 2] {
        match self {
            Self::Triangle => CENTROID[0].0,
            Self::Quad => [0.5, 0.5],
        }
    }

    /// Returns integration points of area, mass and loads.
    pub(crate) const fn points(self) -> &'static [WeightedPoint] {
        match self {
            Self::Triangle => &TRIANGLE_POINTS,
            Self::Quad => &QUAD_POINTS,
        }
    }

    /// Returns integration points of the membrane strains and curvatures, which are constant on a triangle.
    pub(crate) const fn surface_points(self) -> &'static [WeightedPoint] {
        match self {
            Self::Triangle => &CENTROID,
            Self::Quad => &QUAD_POINTS,
        }
    }

    /// Returns the places at which sections are evaluated: the points of the surface, then those of area, mass and shear.
    pub(crate) fn section_places(self) -> impl Iterator<Item = [f64; 2]> {
        self.surface_points().iter().chain(self.points()).map(|(at, _)| *at)
    }

    /// Returns the shape functions and their derivatives at a point.
    pub(crate) fn values(self, [x, y]: [f64; 2]) -> ShapeValues {
        match self {
            Self::Triangle => [[1.0 - x - y, x, y, 0.0], [-1.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 1.0, 0.0]],
            Self::Quad => [
                [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y],
                [-(1.0 - y), 1.0 - y, y, -y],
                [-(1.0 - x), -x, x, 1.0 - x],
            ],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rules are exact for linear functions, and all corners have weights.
    #[test]
    fn grid_rules_are_exact_for_linear_functions() {
        for (face, moments) in [
            (Face::Triangle([0, 1, 2]), [0.5, 1.0 / 6.0, 1.0 / 6.0]),
            (Face::Quad([0, 1, 2, 3]), [1.0, 0.5, 0.5]),
        ] {
            let rule = face.grid_rule(2);
            assert_eq!(rule.len(), 25);
            let sum = |f: &dyn Fn([f64; 2]) -> f64| rule.iter().map(|(at, w)| w * f(*at)).sum::<f64>();
            let found = [sum(&|_| 1.0), sum(&|at| at[0]), sum(&|at| at[1])];
            for (found, exact) in found.into_iter().zip(moments) {
                assert!((found - exact).abs() < 1e-15, "{face:?}: {found} not {exact}");
            }
            for corner in face.shape().corners() {
                let weight: f64 = rule.iter().filter(|(at, _)| at == corner).map(|(_, w)| w).sum();
                assert!(weight > 0.005, "{face:?}: {corner:?} has the weight {weight}");
            }
        }
    }
}
