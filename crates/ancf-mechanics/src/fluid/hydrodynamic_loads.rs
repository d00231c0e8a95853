use std::sync::Arc;

use super::flow_field::{Fluid, Hull, HydroCoefficients};
use super::morison::Morison;
use crate::bodies::BeamMesh;

impl BeamMesh {
    /// Creates the hydrodynamic load of each element, given the section properties at an arc length.
    pub fn immersed(&self, fluid: &Arc<Fluid>, hull: impl Fn(f64) -> Hull) -> Vec<Morison> {
        let pieces = self.pieces(0.0..self.length()).zip(self.element_axes());
        let of = |(piece, axis): (crate::bodies::Piece, crate::kinematics::ElementAxis)| {
            let points = piece.many_points().map(|(s, w)| {
                let tangent = self.axes(s)[0].reference();
                (axis.weights(s), tangent, HydroCoefficients::new(fluid, &hull(s), w))
            });
            Morison::new(&axis, Arc::clone(fluid), points)
        };
        pieces.map(of).collect()
    }
}
