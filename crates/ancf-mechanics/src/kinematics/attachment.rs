use ancf_solver::equations::State;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::frame::section_frame;
use super::marker::Marker;

/// Attachment of a joint, a load or a probe to a body or to the ground: a point and the directions of the body there.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// Point.
    pub point: Marker,
    /// Directions.
    pub directions: Directions,
}

/// Directions of a body at a point.
#[derive(Clone, Debug)]
pub enum Directions {
    /// No directions: the body is a point.
    None,
    /// Tangent only: the body is a line.
    Line(Marker),
    /// Directors r_x, r_y and r_z of a section, which may stretch and shear.
    Section([Marker; 3]),
    /// Directions of a rigid body or of the ground, with constant lengths and angles.
    Rigid([Marker; 3]),
}

impl Attachment {
    /// Creates a point of the ground with the global axes.
    pub fn ground(point: Vector3<f64>) -> Self {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(Marker::fixed);
        Self { point: Marker::fixed(point), directions: Directions::Rigid(axes) }
    }

    /// Returns the three directions, if the body has them.
    pub fn axes(&self) -> Option<&[Marker; 3]> {
        match &self.directions {
            Directions::None | Directions::Line(_) => None,
            Directions::Section(axes) | Directions::Rigid(axes) => Some(axes),
        }
    }

    /// Returns true if the directions have constant lengths and angles.
    pub const fn is_rigid(&self) -> bool {
        matches!(self.directions, Directions::Rigid(_))
    }

    /// Returns the tangent of a line.
    pub const fn line(&self) -> Option<&Marker> {
        match &self.directions {
            Directions::Line(tangent) => Some(tangent),
            _ => None,
        }
    }

    /// Returns the body-fixed direction with the reference value `direction`: J d with J = [r_x r_y r_z].
    ///
    /// For a line, only the component along the tangent is used. A point has no direction.
    pub fn direction(&self, direction: Vector3<f64>) -> Marker {
        match &self.directions {
            Directions::None => Marker::fixed(Vector3::zeros()),
            Directions::Line(tangent) => {
                let along = tangent.reference().dot(&direction) / tangent.reference().norm_squared();
                Marker::combined([(round_to_zero(along), tangent)])
            }
            Directions::Section(axes) | Directions::Rigid(axes) => {
                let reference = Matrix3::from_columns(&axes.each_ref().map(|axis| axis.reference()));
                let inverse = reference.try_inverse().unwrap_or_else(Matrix3::zeros);
                let [x, y, z]: [f64; 3] = (inverse * direction).map(round_to_zero).into();
                Marker::combined([(x, &axes[0]), (y, &axes[1]), (z, &axes[2])])
            }
        }
    }

    /// Returns Euler parameters and angular velocity in the global frame, if the attachment has three directions.
    ///
    /// The Euler parameters (e₀, e₁, e₂, e₃), e₀ ≥ 0, describe the rotation from the reference state. For a section
    /// they belong to the orthonormal frame that divides the skew of r_y and r_z equally. Its spin about the normal is
    /// the mean spin of both directions.
    pub fn rotation(&self, s: &State) -> Option<([f64; 4], Vector3<f64>)> {
        let [a, d, e] = self.axes()?;
        let frame = |d: Vector3<f64>, e: Vector3<f64>| Matrix3::from_columns(&section_frame(d, e));
        let reference = frame(d.reference(), e.reference());
        let turned = frame(d.value(s), e.value(s)) * reference.transpose();
        let quaternion = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(turned));
        let [i, j, k, w]: [f64; 4] = quaternion.coords.into();
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        Some(([w, i, j, k].map(|x| sign * x), spin([a, d, e].map(|axis| (axis.value(s), axis.sum(&s.v))))))
    }

    /// Moves the point by an arm, given in the reference state.
    pub fn offset(self, arm: Vector3<f64>) -> Self {
        let point = Marker::combined([(1.0, &self.point), (1.0, &self.direction(arm))]);
        Self { point, ..self }
    }
}

/// Computes the angular velocity of a frame from its directions and their rates.
///
/// The normal n = d × e and its rate determine the normal component. The mean of d and e determines the component along
/// n.
fn spin([_, (d, d_rate), (e, e_rate)]: [(Vector3<f64>, Vector3<f64>); 3]) -> Vector3<f64> {
    let area = d.cross(&e);
    let normal = area.normalize();
    let rate = (d_rate.cross(&e) + d.cross(&e_rate)) / area.norm();
    let along = |x: Vector3<f64>, rate: Vector3<f64>| x.cross(&rate).dot(&normal) / x.norm_squared();
    normal.cross(&rate) + normal * (0.5 * (along(d, d_rate) + along(e, e_rate)))
}

/// Rounds components to zero that are zero within rounding, such as those along the directions of a frame.
pub(crate) fn round_to_zero(component: f64) -> f64 {
    if component.abs() < 1e-14 { 0.0 } else { component }
}
