use nalgebra::{Vector2, Vector3};

use crate::kinematics::BodyVector;

/// Normal forces of a joint by its multipliers.
#[derive(Clone, Debug)]
pub enum Bearing {
    /// Pin: multipliers of the force along the global axes, and of the moments across the axis.
    Pin {
        /// Directions n₁ and n₂ across the axis.
        normals: Box<[BodyVector; 2]>,
        /// Radius of the pin.
        radius: f64,
        /// Distance of two bearings that carry the moments; `None` without friction by moments.
        span: Option<f64>,
        /// Radius of the collar that carries the axial force; 0 without friction by this force.
        collar: f64,
    },
    /// Ball of a radius: multipliers of the force along the global axes.
    Ball {
        /// Radius of the ball.
        radius: f64,
    },
    /// Bearings of one arm of a cross: multipliers of the force along the global axes, and of the angle of both arms.
    Arm {
        /// This arm and the other one.
        arms: Box<[BodyVector; 2]>,
        /// Radius of the pins.
        radius: f64,
        /// Distance of two bearings that carry the moment; `None` without friction by the moment.
        span: Option<f64>,
    },
    /// Straight guide: multipliers of the forces and of the moments across the axis, and of the moment about it.
    Guide {
        /// Distance of two shoes that carry the moments across the axis; `None` without friction by these moments.
        span: Option<f64>,
        /// Lever arm at which the guide carries the moment about the axis; `None` without friction by this moment.
        arm: Option<f64>,
    },
    /// Sleeve of a shaft: multipliers of the forces and of the moments across the axis.
    Sleeve {
        /// Distance of two bearings that carry the moments; `None` without friction by moments.
        span: Option<f64>,
    },
    /// Line: multipliers of the forces across it.
    Line,
    /// Plane: multiplier of the force normal to it.
    Plane,
    /// Curve: multipliers of the force, whose part along the curve is the friction itself.
    Curve,
}

impl Bearing {
    /// Number of multipliers of the joint that the normal force depends on.
    pub(super) const fn multipliers(&self) -> usize {
        match self {
            Self::Plane => 1,
            Self::Line => 2,
            Self::Ball { .. } | Self::Curve => 3,
            Self::Arm { .. } | Self::Sleeve { .. } => 4,
            Self::Pin { .. } | Self::Guide { .. } => 5,
        }
    }

    /// Directions on which the normal force depends.
    pub(super) fn directions(&self) -> &[BodyVector] {
        match self {
            Self::Pin { normals, .. } => &normals[..],
            Self::Arm { arms, .. } => &arms[..],
            _ => &[],
        }
    }

    /// Expresses the directions in places of a list of coordinates.
    pub(super) fn within(mut self, coordinates: &[usize]) -> Self {
        if let Self::Pin { normals: pair, .. } | Self::Arm { arms: pair, .. } = &mut self {
            **pair = pair.each_ref().map(|direction| direction.within(coordinates));
        }
        self
    }

    /// Returns ρ N by the multipliers. `along` is the ratio of the friction to the normal force, for a curve.
    pub(super) fn normal(&self, l: &[f64], q: &[f64], along: f64) -> f64 {
        let force = || Vector3::from_column_slice(&l[..3]);
        match self {
            Self::Pin { normals, radius, span, collar } => {
                let (force, [n1, n2]) = (force(), normals.each_ref().map(|normal| normal.at(q)));
                let across = Vector2::new(force.dot(&n1), force.dot(&n2));
                let axial = force.dot(&n1.cross(&n2)).abs();
                radius * normal_force(across, Vector2::new(l[3], l[4]), *span) + collar * axial
            }
            Self::Ball { radius } => radius * force().norm(),
            Self::Arm { arms, radius, span } => {
                let (force, [arm, other]) = (force(), arms.each_ref().map(|arm| arm.at(q)));
                let normal = arm.cross(&other);
                let (moment, normal) = (l[3] * normal.norm(), normal.normalize());
                let across = Vector2::new(force.dot(&normal), force.dot(&normal.cross(&arm)));
                radius * normal_force(across, Vector2::new(0.0, moment), *span)
            }
            Self::Guide { span, arm } => pair(l, *span) + arm.map_or(0.0, |arm| l[4].abs() / arm),
            Self::Sleeve { span } => pair(l, *span),
            Self::Line => l[0].hypot(l[1]),
            Self::Plane => l[0].abs(),
            Self::Curve => force().norm() / (1.0 + along * along).sqrt(),
        }
    }
}

/// Returns the normal force of two bearings by two forces and two moments across the axis.
fn pair(l: &[f64], span: Option<f64>) -> f64 {
    normal_force(Vector2::new(l[0], l[1]), Vector2::new(l[2], l[3]), span)
}

/// Sum of the normal forces of two bearings at a distance under a force and a moment, m = M × e.
fn normal_force(f: Vector2<f64>, m: Vector2<f64>, span: Option<f64>) -> f64 {
    match span {
        Some(span) => (f * 0.5 + m / span).norm() + (f * 0.5 - m / span).norm(),
        None => f.norm(),
    }
}
