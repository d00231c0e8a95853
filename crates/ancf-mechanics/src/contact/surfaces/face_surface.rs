use nalgebra::{Matrix2, Vector3};
use smallvec::SmallVec;

use super::target::TargetSurface;
use crate::contact::parts::{FaceNodes, FacePart, Foot, PartWeights};
use crate::kinematics::{SurfaceValues, gap_slopes};
use crate::shells::{NODES, Shape, along_offset_edge};

/// Middle surface of an element of a shear-deformable shell in a state, linear or bilinear between its nodes.
#[derive(Clone, Debug)]
pub struct FaceSurface {
    shape: Shape,
    nodes: SmallVec<[Vector3<f64>; NODES]>,
    /// Radius at the nodes, half the thickness, less the smallest one, if it varies.
    excess: Option<SmallVec<[f64; NODES]>>,
}

/// Distance from the third edge of a triangle that counts as rounding.
const ON_EDGE: f64 = 8.0 * f64::EPSILON;

/// Sum of weights below which it is a rounding error.
const NO_WEIGHT: f64 = 1e-12;

impl FaceSurface {
    /// Evaluates the surface for coordinates q, relative to an origin. `excess` is the radius at the nodes less the smallest one.
    pub(super) fn new(
        (shape, excess): (Shape, Option<&SmallVec<[f64; NODES]>>),
        nodes: &FaceNodes,
        q: &[f64],
        origin: &Vector3<f64>,
    ) -> Self {
        let node = |(first, reference): &(usize, Vector3<f64>)| {
            reference - origin + Vector3::new(q[*first], q[*first + 1], q[*first + 2])
        };
        Self { shape, nodes: nodes.iter().map(node).collect(), excess: excess.cloned() }
    }

    /// Returns r and its derivatives at (ξ, η).
    fn values(&self, at: [f64; 2]) -> SurfaceValues {
        self.shape.surface_values(at, &self.nodes)
    }

    /// Returns (ξ, η) of the closest point of a part.
    fn closest(&self, part: FacePart, point: &Vector3<f64>) -> [f64; 2] {
        let corners = self.shape.corners();
        match part {
            FacePart::Surface => match &self.excess {
                None => self.shape.nearest(point, &self.nodes),
                Some(excess) => self.shape.nearest_of_offset(point, &self.nodes, excess),
            },
            FacePart::Edge(k) => {
                let [a, b] = [k, (k + 1) % self.nodes.len()];
                let excess = self.excess.as_ref().map_or([0.0; 2], |excess| [excess[a], excess[b]]);
                let along = along_offset_edge(point, [&self.nodes[a], &self.nodes[b]], excess);
                [0, 1].map(|i| corners[a][i] + (corners[b][i] - corners[a][i]) * along)
            }
            FacePart::Node(k) => corners[k],
        }
    }

    /// Returns the radius less the smallest one at (ξ, η).
    fn excess_at(&self, at: [f64; 2]) -> f64 {
        self.excess.as_ref().map_or(0.0, |excess| self.shape.offset_values(at, excess)[0])
    }

    /// Returns the distance of a point from (ξ, η), relative to the sum of the radii.
    fn relative(&self, at: [f64; 2], point: &Vector3<f64>, radius: f64) -> f64 {
        (point - self.values(at)[0]).norm() / (radius + self.excess_at(at))
    }

    /// Returns the smallest part that contains the closest point, and its distance relative to the sum of the radii.
    pub(super) fn closest_part(&self, point: &Vector3<f64>, radius: f64) -> (FacePart, f64) {
        let at = self.closest(FacePart::Surface, point);
        (self.part_at(at), self.relative(at, point, radius))
    }

    /// Returns the parts nearer to a point than a multiple of the sum of the radii, without those whose weights at a common closest point
    /// have the sum 0.
    pub(super) fn acting_parts(
        &self,
        weights: &PartWeights,
        point: &Vector3<f64>,
        (radius, multiple): (f64, f64),
    ) -> SmallVec<[FacePart; FacePart::COUNT]> {
        let (mut sums, mut near) = ([0.0; FacePart::COUNT], SmallVec::<[_; FacePart::COUNT]>::new());
        for (number, weight) in weights.iter().enumerate().filter(|(_, weight)| **weight != 0.0) {
            let part = FacePart::new(number);
            let at = self.closest(part, point);
            if self.relative(at, point, radius) < multiple {
                let place = self.part_at(at).number();
                sums[place] += weight;
                near.push((part, place));
            } else if part == FacePart::Surface {
                break;
            }
        }
        near.into_iter().filter(|(_, place)| sums[*place].abs() > NO_WEIGHT).map(|(part, _)| part).collect()
    }

    /// Returns the smallest part that contains a place.
    fn part_at(&self, at: [f64; 2]) -> FacePart {
        match self.edges_at(at)[..] {
            [] => FacePart::Surface,
            [edge] => FacePart::Edge(edge),
            // The first and the last edge meet at the first node.
            [first, second, ..] => FacePart::Node(if first + 1 == second { second } else { 0 }),
        }
    }

    /// Finds the foot of a point on a part of the element.
    pub(super) fn foot(&self, part: FacePart, point: &Vector3<f64>) -> Foot<2> {
        let at = self.closest(part, point);
        let values = self.values(at);
        let d = point - values[0];
        let offset = self.excess.as_ref().map(|excess| self.shape.offset_values(at, excess));
        let ((_, bent, _), [x, y]) = gap_slopes(&d, &values, offset);
        let compliance = match self.edges_at(at)[..] {
            [] => bent.try_inverse().unwrap_or_else(Matrix2::zeros),
            [edge] => {
                // Edges are straight.
                let [from, to] = [edge, (edge + 1) % self.nodes.len()].map(|k| self.shape.corners()[k]);
                let edge = [to[0] - from[0], to[1] - from[1]];
                let slope = x * edge[0] + y * edge[1];
                Matrix2::from_fn(|a, b| edge[a] * edge[b]) / slope.norm_squared()
            }
            _ => Matrix2::zeros(),
        };
        let compliance = [0, 1].map(|a| [0, 1].map(|b| compliance[(a, b)]));
        Foot { at, share: 1.0, d, excess: self.excess_at(at), slopes: [x, y], compliance }
    }

    /// Returns the edges on which a place is: none inside, two at a node.
    fn edges_at(&self, [x, y]: [f64; 2]) -> SmallVec<[usize; 2]> {
        let edges: &[bool] = match self.shape {
            Shape::Triangle => &[y <= 0.0, 1.0 - x - y <= ON_EDGE, x <= 0.0],
            Shape::Quad => &[y <= 0.0, x >= 1.0, y >= 1.0, x <= 0.0],
        };
        (0..edges.len()).filter(|k| edges[*k]).collect()
    }
}

impl TargetSurface for FaceSurface {
    fn hull_points(&self) -> &[Vector3<f64>] {
        &self.nodes
    }

    fn largest_excess(&self) -> f64 {
        self.excess.iter().flatten().copied().fold(0.0, f64::max)
    }

    fn between(&self, to: &Self, part: f64) -> Self {
        let nodes = self.nodes.iter().zip(&to.nodes).map(|(a, b)| a + (b - a) * part).collect();
        Self { shape: self.shape, nodes, excess: self.excess.clone() }
    }

    fn relative_distance(&self, point: &Vector3<f64>, radius: f64) -> f64 {
        self.closest_part(point, radius).1
    }
}
