use ancf_solver::equations::State;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use super::body_vector::BodyVector;
use super::marker::Marker;
use super::section_frame::SectionFrame;

/// Attachment of a joint, a load or a probe to a body or to the ground: a point and the directions of the body there.
#[derive(Clone, Debug)]
pub struct Attachment {
    /// Point.
    pub point: BodyVector,
    /// Directions.
    pub directions: Directions,
}

/// Directions of a body at a point.
#[derive(Clone, Debug)]
#[expect(clippy::large_enum_variant, reason = "markers are stored in place, and attachments are few")]
pub enum Directions {
    /// No directions: the body is a point.
    None,
    /// Tangent only: the body is a line.
    Line(Marker),
    /// Directors r_x, r_y and r_z of a section, which may stretch and shear, and the frame of the section.
    Section([Marker; 3], SectionFrame),
    /// Frame of a surface: its normal and two tangents, which may stretch and shear.
    Surface(SectionFrame),
    /// Directions of a rigid body or of the ground, with constant lengths and angles.
    Rigid([Marker; 3]),
}

/// Distance of unit vectors below which directions are parallel.
const PARALLEL: f64 = 1e-9;

impl Attachment {
    /// Creates a point of the ground with the global axes.
    pub fn ground(point: Vector3<f64>) -> Self {
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()].map(Marker::fixed);
        Self { point: BodyVector::fixed(point), directions: Directions::Rigid(axes) }
    }

    /// Returns the three directions, if the body has them.
    pub fn axes(&self) -> Option<&[Marker; 3]> {
        match &self.directions {
            Directions::None | Directions::Line(_) | Directions::Surface(_) => None,
            Directions::Section(axes, _) | Directions::Rigid(axes) => Some(axes),
        }
    }

    /// Returns true if the directions of both attachments are the same in the reference state.
    pub fn is_parallel(&self, other: &Self) -> bool {
        let (Some(here), Some(there)) = (self.axes(), other.axes()) else { return false };
        let unit = |axis: &Marker| axis.reference().normalize();
        here.iter().zip(there).all(|(a, b)| (unit(a) - unit(b)).norm() < PARALLEL)
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

    /// Returns the orthonormal frame of a section or of a rigid body.
    pub fn frame(&self) -> Option<SectionFrame> {
        match &self.directions {
            Directions::None | Directions::Line(_) => None,
            Directions::Section(_, frame) | Directions::Surface(frame) => Some(frame.clone()),
            Directions::Rigid([_, d, e]) => Some(SectionFrame::new([d, e], 0.5)),
        }
    }

    /// Returns the direction with the reference value `direction` that rotates with the body.
    ///
    /// For a section it rotates with the [`SectionFrame`]. For a line, only the component along the tangent is used, and
    /// its length follows the stretch. A point has no direction.
    pub fn direction(&self, direction: Vector3<f64>) -> BodyVector {
        match &self.directions {
            Directions::Section(_, frame) | Directions::Surface(frame) => {
                BodyVector::turned(frame, direction)
            }
            _ => self.material_direction(direction).into(),
        }
    }

    /// Returns the material direction with the reference value `direction`: J d with J = [r_x r_y r_z].
    ///
    /// It stretches and shears with the section. For a line, only the component along the tangent is used.
    pub fn material_direction(&self, direction: Vector3<f64>) -> Marker {
        match &self.directions {
            // A surface has no material direction along its normal: only its tangents are vectors of the coordinates.
            Directions::None | Directions::Surface(_) => Marker::fixed(Vector3::zeros()),
            Directions::Line(tangent) => {
                let along = tangent.reference().dot(&direction) / tangent.reference().norm_squared();
                Marker::combined([(round_to_zero(along), tangent)])
            }
            Directions::Section(axes, _) | Directions::Rigid(axes) => {
                let reference = Matrix3::from_columns(&axes.each_ref().map(|axis| axis.reference()));
                let inverse = reference.try_inverse().unwrap_or_else(Matrix3::zeros);
                let [x, y, z]: [f64; 3] = (inverse * direction).map(round_to_zero).into();
                Marker::combined([(x, &axes[0]), (y, &axes[1]), (z, &axes[2])])
            }
        }
    }

    /// Returns the material point: an arm stretches and shears with the section.
    pub fn material_point(&self) -> Marker {
        let axis = self.point.linear();
        let arm = self.material_direction(self.point.reference() - axis.reference());
        if self.point.is_linear() { axis.clone() } else { Marker::combined([(1.0, axis), (1.0, &arm)]) }
    }

    /// Returns Euler parameters and angular velocity in the global frame, if the attachment has three directions.
    ///
    /// The Euler parameters (e₀, e₁, e₂, e₃), e₀ ≥ 0, describe the rotation of the frame from the reference state.
    pub fn rotation(&self, s: &State) -> Option<([f64; 4], Vector3<f64>)> {
        let frame = self.frame()?;
        let turned = Rotation3::from_matrix_unchecked(frame.at(&s.q).rotation());
        let [i, j, k, w]: [f64; 4] = UnitQuaternion::from_rotation_matrix(&turned).coords.into();
        let sign = if w < 0.0 { -1.0 } else { 1.0 };
        let spin = self.spin(s)?;
        Some(([w, i, j, k].map(|x| sign * x), spin))
    }

    /// Returns the angular velocity in the global frame, if the attachment has three directions.
    ///
    /// All three directors of a rigid body have equal shares in it. Their rates violate the constraints by the error of a
    /// step, so a part of them depends on the choice of the directors.
    pub fn spin(&self, s: &State) -> Option<Vector3<f64>> {
        match &self.directions {
            Directions::None | Directions::Line(_) => None,
            Directions::Section(_, frame) | Directions::Surface(frame) => {
                Some(frame.at(&s.q).spin(frame.rates(&s.v)))
            }
            Directions::Rigid(axes) => {
                let sum: Vector3<f64> = axes.iter().map(|axis| axis.value(s).cross(&axis.sum(&s.v))).sum();
                Some(sum * 0.5)
            }
        }
    }

    /// Returns the frames on which a moment acts with equal shares: that of a section, or three of a rigid body.
    ///
    /// The frames of a rigid body are those of its pairs of directors. The mean of their angular velocities is
    /// [`spin`](Self::spin).
    pub fn moment_frames(&self) -> Vec<SectionFrame> {
        match &self.directions {
            Directions::None | Directions::Line(_) => Vec::new(),
            Directions::Section(_, frame) | Directions::Surface(frame) => vec![frame.clone()],
            Directions::Rigid([x, y, z]) => {
                [[y, z], [z, x], [x, y]].map(|pair| SectionFrame::new(pair, 0.5)).into()
            }
        }
    }

    /// Moves the point by a rigid arm, given in the reference state.
    pub fn offset(self, arm: Vector3<f64>) -> Self {
        let point = BodyVector::combined([(1.0, &self.point), (1.0, &self.direction(arm))]);
        Self { point, ..self }
    }
}

/// Rounds components to zero that are zero within rounding, such as those along the directions of a frame.
pub(crate) fn round_to_zero(component: f64) -> f64 {
    if component.abs() < 1e-14 { 0.0 } else { component }
}
