use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::mesh::BeamMesh;

/// Frame of a cable at a node, from which the frames at larger arc lengths are carried.
#[derive(Clone, Copy, Debug, Default)]
pub struct CarriedFrame(Option<(usize, [Vector3<f64>; 3])>);

impl BeamMesh {
    /// Returns the axes of the [`SectionFrame`](crate::kinematics::SectionFrame) at an arc length.
    ///
    /// For a cable, it is the tangent and two transverse directions without twist: the frame of the start is carried from
    /// node to node, and from the last node to the arc length, by the smallest rotations of the tangent. The frame of the
    /// start follows from the one of the reference state, with the stated y-axis, by the smallest rotation.
    pub fn section_frame(&self, state: &State, s: f64) -> [Vector3<f64>; 3] {
        self.carried_frame(state, s, &mut CarriedFrame::default())
    }

    /// Returns the [`section_frame`](Self::section_frame). `last` has the frame of an earlier call for the same mesh and
    /// state, which shortens the way of a cable frame to a larger arc length.
    pub fn carried_frame(&self, state: &State, s: f64, last: &mut CarriedFrame) -> [Vector3<f64>; 3] {
        if let Some(frame) = self.frame(s) {
            return frame.at(&state.q).axes;
        }
        let [tangent, ..] = self.axes(s);
        let (element, _) = self.locate(s);
        let (mut node, mut frame) = match last.0 {
            Some((node, frame)) if node <= element => (node, frame),
            _ => {
                let start = self.node_slope(0).normalize();
                let frame = [start, self.up, start.cross(&self.up)];
                (0, carried(frame, self.node_tangent(state, 0)))
            }
        };
        while node < element {
            node += 1;
            frame = carried(frame, self.node_tangent(state, node));
        }
        last.0 = Some((node, frame));
        carried(frame, tangent.value(state).normalize())
    }

    /// Returns the reference slope of a node of a cable.
    fn node_slope(&self, node: usize) -> Vector3<f64> {
        self.reference[node * self.stride() + 1]
    }

    /// Returns the tangent at a node of a cable.
    fn node_tangent(&self, state: &State, node: usize) -> Vector3<f64> {
        let first = self.first + 3 * (node * self.stride() + 1);
        (self.node_slope(node) + Vector3::from_column_slice(&state.q[first..first + 3])).normalize()
    }
}

/// Rotates a frame by the smallest rotation of its first axis to a unit vector. An opposite vector is reached about y.
fn carried([x, y, z]: [Vector3<f64>; 3], tangent: Vector3<f64>) -> [Vector3<f64>; 3] {
    let sum = x + tangent;
    // Twice 1 + cos of the angle.
    let size = sum.norm_squared();
    let y = if size > 1e-24 { y - sum * (2.0 * y.dot(&tangent) / size) } else { y };
    let y = (y - tangent * tangent.dot(&y)).try_normalize(0.5).unwrap_or(z);
    [tangent, y, tangent.cross(&y)]
}

/// Returns two orthonormal vectors normal to a unit vector. Global axes are used where possible.
pub fn normals_to(axis: Vector3<f64>) -> [Vector3<f64>; 2] {
    let least = axis.iamin();
    let guide = Vector3::from_fn(|i, _| if i == least { 1.0 } else { 0.0 });
    let first = (guide - axis * axis.dot(&guide)).normalize();
    [first, axis.cross(&first)]
}
