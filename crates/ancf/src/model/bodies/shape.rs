use std::f64::consts::TAU;

use ancf_mechanics::kinematics::{ReferenceCurve, Spline};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Shape of the axis of a beam in the reference state, which is free of stress.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Shape {
    /// Straight line.
    #[default]
    Straight,
    /// Arc of a circle.
    Arc {
        /// Point between start and end, length.
        #[unit(length)]
        through: [f64; 3],
    },
    /// Helix.
    Helix {
        /// Point of the axis of the helix, length.
        #[unit(length)]
        center: [f64; 3],
        /// Direction of the axis of the helix. The rotation from start to end follows the right-hand rule.
        #[unit(none)]
        axis: [f64; 3],
        /// Number of turns.
        #[unit(number)]
        #[schemars(extend("exclusiveMinimum" = 0))]
        turns: f64,
    },
    /// Natural cubic spline.
    Spline {
        /// Points between start and end, length.
        #[unit(length)]
        #[schemars(length(min = 1))]
        through: Vec<[f64; 3]>,
    },
}

impl Shape {
    /// True for a straight line.
    pub const fn is_straight(&self) -> bool {
        matches!(self, Self::Straight)
    }

    /// Curve from start to end, relative to the start.
    ///
    /// `None` if points coincide, points of an arc are collinear, or the radius of a helix is zero.
    pub fn curve(&self, start: Vector3<f64>, end: Vector3<f64>) -> Option<ReferenceCurve> {
        let (from, to) = (Vector3::zeros(), end - start);
        let relative = |point: &[f64; 3]| Vector3::from(*point) - start;
        match self {
            Self::Straight => {
                let length = to.norm();
                (length > 0.0 && length.is_finite()).then_some(ReferenceCurve::Line { from, to })
            }
            Self::Arc { through } => ReferenceCurve::arc(from, relative(through), to),
            Self::Helix { center, axis, turns } => {
                let (center, axis) = (relative(center), Vector3::from(*axis).try_normalize(0.0)?);
                let center = center - axis * axis.dot(&center);
                let radius = -center;
                let rise = axis.dot(&to);
                radius.norm().is_normal().then_some(ReferenceCurve::Helix {
                    center,
                    radius,
                    axis,
                    angle: TAU * turns,
                    rise,
                })
            }
            Self::Spline { through } => {
                let through = through.iter().map(relative);
                Spline::new([from].into_iter().chain(through).chain([to]).collect())
                    .map(ReferenceCurve::Spline)
            }
        }
    }
}
