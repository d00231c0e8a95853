use nalgebra::Vector3;

use super::shape::VectorKind;

/// Nodal vector of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalVector {
    /// First of its three coordinates.
    pub first: usize,
    /// Kind of vector.
    pub kind: VectorKind,
    /// Value in a state.
    pub value: Vector3<f64>,
}

impl NodalVector {
    /// Returns true for a position, which translations change, and false for a direction.
    pub fn is_position(&self) -> bool {
        self.kind == VectorKind::Position
    }
}
