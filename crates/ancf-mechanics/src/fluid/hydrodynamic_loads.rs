use std::sync::Arc;

use super::flow_field::{FlowField, HydroCoefficients, HydroSection};
use super::morison::MorisonLoad;
use crate::bodies::BeamMesh;

impl BeamMesh {
    /// Creates the hydrodynamic load of each element, given the section properties at an arc length.
    pub fn hydrodynamic_loads(
        &self,
        fluid: &Arc<FlowField>,
        section: impl Fn(f64) -> HydroSection,
    ) -> Vec<MorisonLoad> {
        let spans = self.element_spans(0.0..self.length()).zip(self.element_axes());
        let of = |(span, axis): (crate::bodies::ElementSpan, crate::kinematics::ElementAxis)| {
            let points = span.fine_points().map(|(s, w)| {
                let tangent = self.axes(s)[0].reference();
                (axis.weights(s), tangent, HydroCoefficients::new(fluid, &section(s), w))
            });
            MorisonLoad::new(&axis, Arc::clone(fluid), points)
        };
        spans.map(of).collect()
    }
}
