use nalgebra::Vector3;

use super::shape::Kind;

/// A vector among the coordinates of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalVector {
    /// The first of its three coordinates.
    pub first: usize,
    /// What it is.
    pub kind: Kind,
    /// Its value in a state.
    pub value: Vector3<f64>,
}

impl NodalVector {
    /// Whether it is the position of a node, which translations move, or a direction, which only rotations do.
    pub fn is_position(&self) -> bool {
        self.kind == Kind::Position
    }
}
