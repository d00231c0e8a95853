use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::kinematics::{ElementAxis, VectorKind};

impl BeamMesh {
    /// Returns the axis of each element.
    pub fn element_axes(&self) -> impl Iterator<Item = ElementAxis> + '_ {
        (0..self.count()).map(|element| {
            let offset = element * self.stride();
            let kinds = self.weights(0.0).into_iter().map(|(kind, ..)| kind).enumerate();
            let (mut vectors, mut reference) = (Vec::new(), Vec::new());
            for (i, kind) in
                kinds.filter(|(_, kind)| matches!(kind, VectorKind::Position | VectorKind::Slope))
            {
                let origin = if kind == VectorKind::Position { self.origin } else { Vector3::zeros() };
                vectors.push(self.first + 3 * (offset + i));
                reference.push(self.reference[offset + i] + origin);
            }
            ElementAxis::new(vectors, reference, [self.length, self.slope], element as f64 * self.length)
        })
    }
}
