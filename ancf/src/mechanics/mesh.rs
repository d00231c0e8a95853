use std::array;
use std::sync::Arc;

use nalgebra::Vector3;

use super::{Beam24, BeamShape, Marker, Profile};
use crate::system::State;

/// A vector among the coordinates of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalVector {
    /// The first of its three coordinates.
    pub first: usize,
    /// Whether it is the position of a node, which translations move, or a direction, which only rotations do.
    pub is_position: bool,
    /// Its value in a state.
    pub value: Vector3<f64>,
}

/// The nodes and elements of a straight prismatic beam.
///
/// Node k has the twelve coordinates from `first` + 12 k on: r, ℓ r_x, ℓ r_y, ℓ r_z.
#[derive(Clone, Debug)]
pub struct BeamMesh {
    first: usize,
    elements: usize,
    origin: Vector3<f64>,
    frame: [Vector3<f64>; 3],
    profile: Arc<Profile>,
}

impl BeamMesh {
    /// Coordinates of one node.
    pub const NODE: usize = 12;

    /// Equal elements of a profile from `origin` on along the first direction of an orthonormal frame.
    pub fn new(
        first: usize,
        elements: usize,
        origin: Vector3<f64>,
        frame: [Vector3<f64>; 3],
        profile: Profile,
    ) -> Self {
        Self { first, elements, origin, frame, profile: Arc::new(profile) }
    }

    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        Self::NODE * (self.elements + 1)
    }

    /// Orthonormal directions of x, y and z in the reference state.
    pub fn frame(&self) -> &[Vector3<f64>; 3] {
        &self.frame
    }

    /// All vectors that its coordinates are, in a state, in the order of the coordinates.
    pub fn vectors<'a>(&'a self, s: &'a State) -> impl Iterator<Item = NodalVector> + 'a {
        let shape = self.shape();
        (0..4 * (self.elements + 1)).map(move |k| {
            let (first, is_position) = (self.first + 3 * k, k % 4 == 0);
            let reference = match k % 4 {
                0 => self.origin + self.frame[0] * ((k / 4) as f64 * shape.length),
                along => self.frame[along - 1] * shape.slope,
            };
            let moved = Vector3::from_column_slice(&s.q[first..first + 3]);
            NodalVector { first, is_position, value: reference + moved }
        })
    }

    /// The elements.
    pub fn elements(&self) -> impl Iterator<Item = Beam24> {
        (0..self.elements).map(|k| {
            let first = self.first + Self::NODE * k;
            Beam24::new(array::from_fn(|i| first + i), self.frame, Arc::clone(&self.profile))
        })
    }

    /// The point of the axis at an arc length.
    pub fn point(&self, s: f64) -> Marker {
        let (element, xi) = self.locate(s);
        let weights = self.shape().axis(xi);
        Marker::new(self.axis_vectors(element).into_iter().zip(weights), self.origin + self.frame[0] * s)
    }

    /// The direction of the body at an arc length that is `direction` in the reference state: J d with J = [r_x r_y r_z].
    pub fn direction(&self, s: f64, direction: Vector3<f64>) -> Marker {
        let (element, xi) = self.locate(s);
        let [x, y, z] = self.frame.map(|axis| clean(axis.dot(&direction)));
        let (axis, section) = (self.shape().axis_gradient(xi), self.shape().section(xi));
        let node = self.first + Self::NODE * element;
        let along = self.axis_vectors(element).into_iter().zip(axis.map(|w| w * x));
        let across = (0..2).flat_map(|side| {
            let first = node + Self::NODE * side;
            [(first + 6, section[side] * y), (first + 9, section[side] * z)]
        });
        Marker::new(along.chain(across), direction)
    }

    fn shape(&self) -> BeamShape {
        self.profile.shape()
    }

    /// Element and ξ of an arc length; a node belongs to one of its elements at exactly ξ = 0 or 1.
    fn locate(&self, s: f64) -> (usize, f64) {
        let at = s / self.shape().length;
        let node = at.round();
        let at = if (at - node).abs() < 1e-9 { node } else { at };
        let element = (at.floor().max(0.0) as usize).min(self.elements - 1);
        (element, (at - element as f64).clamp(0.0, 1.0))
    }

    /// First coordinates of r₁, ℓ r_x₁, r₂, ℓ r_x₂ of an element.
    fn axis_vectors(&self, element: usize) -> [usize; 4] {
        let node = self.first + Self::NODE * element;
        [node, node + 3, node + Self::NODE, node + Self::NODE + 3]
    }
}

/// Components that are zero but for rounding, such as those of a frame's own directions, are zero.
fn clean(component: f64) -> f64 {
    if component.abs() < 4.0 * f64::EPSILON { 0.0 } else { component }
}
