//! Points, directions and attachments along a beam or cable.

use nalgebra::Vector3;

use super::mesh::BeamMesh;
use crate::kinematics::{Attachment, Directions, Marker, SectionFrame, VectorKind, round_to_zero};

impl BeamMesh {
    /// Returns the point of the axis at an arc length.
    pub fn point(&self, s: f64) -> Marker {
        self.material_point(s, 0.0, 0.0)
    }

    /// Returns the point of the body at an arc length and (y, z) in its section.
    pub fn material_point(&self, s: f64, y: f64, z: f64) -> Marker {
        self.marker(s, |kind, value, _| match kind {
            VectorKind::Position | VectorKind::Slope | VectorKind::Twist => value,
            VectorKind::Y => y * value,
            VectorKind::Z => z * value,
        })
    }

    /// Returns the attachment of joints, loads and probes at an arc length.
    pub fn attachment(&self, s: f64) -> Attachment {
        let directions = match self.frame(s) {
            Some(frame) => Directions::Section(self.axes(s), frame),
            None => {
                let [tangent, ..] = self.axes(s);
                Directions::Line(tangent)
            }
        };
        Attachment { point: self.point(s).into(), directions }
    }

    /// Returns the frame of the section at an arc length. A cable has none.
    pub fn frame(&self, s: f64) -> Option<SectionFrame> {
        let [_, d, e] = self.axes(s);
        self.has_sections().then(|| SectionFrame::new([&d, &e], self.frame_weight(s)))
    }

    /// Returns the weight w_y of the section frame at an arc length, interpolated between the nodes.
    fn frame_weight(&self, s: f64) -> f64 {
        let (element, xi) = self.locate(s);
        self.node_weight(element) * (1.0 - xi) + self.node_weight(element + 1) * xi
    }

    /// Returns the weight w_y of the section frame at an end node of an element.
    pub(super) fn node_weight(&self, node: usize) -> f64 {
        self.frame_weights.get(node).copied().unwrap_or(0.5)
    }

    /// Returns the material direction at an arc length with the reference value `direction`
    /// ([`Attachment::material_direction`]).
    pub fn direction(&self, s: f64, direction: Vector3<f64>) -> Marker {
        self.attachment(s).material_direction(direction)
    }

    /// Returns the directions r_x, r_y and r_z at an arc length in the reference state.
    pub fn reference_axes(&self, s: f64) -> [Vector3<f64>; 3] {
        self.axes(s).map(|axis| axis.reference())
    }

    /// Returns the directors r_x, r_y and r_z at an arc length.
    pub fn axes(&self, s: f64) -> [Marker; 3] {
        [0, 1, 2].map(|axis| {
            self.marker(s, |kind, value, directors| match (kind, axis) {
                (VectorKind::Position | VectorKind::Slope, 0) => directors[0],
                (VectorKind::Y, 1) | (VectorKind::Z, 2) => value,
                _ => 0.0,
            })
        })
    }

    fn marker(&self, s: f64, weight: impl Fn(VectorKind, f64, [f64; 3]) -> f64) -> Marker {
        let (element, xi) = self.locate(s);
        let offset = element * self.stride();
        let of = self.weights(xi);
        let weights: Vec<f64> =
            of.iter().map(|&(kind, value, directors)| weight(kind, value, directors)).collect();
        // The weights of positions sum to one for a point and to zero for a direction.
        let positions = weights.iter().zip(&of).filter(|(_, (kind, ..))| *kind == VectorKind::Position);
        let origin = self.origin * round_to_zero(positions.map(|(weight, _)| weight).sum());
        let vectors = &self.reference[offset..offset + weights.len()];
        let reference =
            weights.iter().zip(vectors).map(|(weight, vector)| vector * *weight).sum::<Vector3<f64>>()
                + origin;
        let parts = weights.iter().enumerate().map(|(i, &w)| (self.first + 3 * (offset + i), w));
        Marker::new(parts, reference)
    }
}
