use std::f64::consts::TAU;

use ancf_mechanics::kinematics::{Curve, Spline};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the axis of a beam goes from its start to its end in the reference state, which is free of stress.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Shape {
    /// Along a line.
    #[default]
    Straight,
    /// Along the arc of a circle.
    Arc {
        /// A point between start and end.
        through: [f64; 3],
    },
    /// Along a helix.
    Helix {
        /// A point of the helix's axis.
        center: [f64; 3],
        /// Direction of the helix's axis; the helix turns about it by the right hand.
        axis: [f64; 3],
        /// Number of turns.
        #[schemars(extend("exclusiveMinimum" = 0))]
        turns: f64,
    },
    /// Along a natural cubic spline.
    Spline {
        /// The points between start and end.
        #[schemars(length(min = 1))]
        through: Vec<[f64; 3]>,
    },
}

impl Shape {
    /// Whether it is a line.
    pub const fn is_straight(&self) -> bool {
        matches!(self, Self::Straight)
    }

    /// The curve from start to end, with the start as its origin; `None` if there is none: points coincide or are on a
    /// line, a radius vanishes.
    pub fn curve(&self, start: Vector3<f64>, end: Vector3<f64>) -> Option<Curve> {
        let (from, to) = (Vector3::zeros(), end - start);
        let seen = |point: &[f64; 3]| Vector3::from(*point) - start;
        match self {
            Self::Straight => {
                let length = to.norm();
                (length > 0.0 && length.is_finite()).then_some(Curve::Line { from, to })
            }
            Self::Arc { through } => Curve::arc(from, seen(through), to),
            Self::Helix { center, axis, turns } => {
                let (center, axis) = (seen(center), Vector3::from(*axis).try_normalize(0.0)?);
                let center = center - axis * axis.dot(&center);
                let radius = -center;
                let rise = axis.dot(&to);
                radius.norm().is_normal().then_some(Curve::Helix {
                    center,
                    radius,
                    axis,
                    angle: TAU * turns,
                    rise,
                })
            }
            Self::Spline { through } => {
                let through = through.iter().map(seen);
                Spline::new([from].into_iter().chain(through).chain([to]).collect()).map(Curve::Spline)
            }
        }
    }
}
