use std::sync::Arc;

use ancf_mechanics::inertia::{FrameInertia, FrameRotation};
use ancf_solver::equations::State;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadContext, LoadKind};
use crate::errors::{Finding, finding};
use crate::model::TimeFunction;
use crate::units::Scaled;

/// Rotation of the ground about a fixed axis: centrifugal, Coriolis and Euler forces on all bodies.
///
/// All positions, velocities, supports, loads and results are relative to the rotating ground. In statics the load factor
/// multiplies the centrifugal forces. Modes require `damped = true`, because Coriolis forces couple them, and
/// `about = "equilibrium"`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct BaseRotation {
    /// Angular velocity Ω of the ground, radians/time.
    #[unit(radian / time)]
    pub angular_velocity: [f64; 3],
    /// Point of the axis, length; the origin by default.
    #[unit(length)]
    #[serde(default)]
    pub point: [f64; 3],
    /// Function of time that multiplies the angular velocity. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

/// Sine of the angle between gravity and the axis that counts as rounding.
const ROUNDING: f64 = 1e-9;

impl LoadKind for BaseRotation {
    fn noun(&self) -> &'static str {
        "base rotation"
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let rotation = Arc::new(FrameRotation {
            velocity: Vector3::from(self.angular_velocity),
            point: Vector3::from(self.point),
            function: builder.function(&self.time),
        });
        let bodies = builder.bodies();
        let last = bodies.iter().map(|(_, body)| body.coordinates()).sum();
        let reference = State::rest(last, 0);
        for (_, body) in bodies {
            body.visit_masses(&reference, &mut |vectors, mass| {
                builder.add(FrameInertia::new(vectors, mass, rotation.clone()));
            });
        }
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }

    /// Euler forces depend on the angular acceleration.
    fn uses_rates(&self) -> bool {
        true
    }

    /// Checks that gravity has a constant direction relative to the ground.
    fn check(&self, path: &str, context: &dyn LoadContext) -> Vec<Finding> {
        let [omega, gravity] = [self.angular_velocity, context.gravity()].map(Vector3::from);
        if omega.cross(&gravity).norm() <= ROUNDING * omega.norm() * gravity.norm() {
            return Vec::new();
        }
        let found = "an axis that is not parallel to gravity";
        let expected = "gravity along the axis, or none: its direction would rotate relative to the ground";
        let error = finding(format!("{path}.angular_velocity"), found, expected);
        vec![error.rests_on(["gravity".into()])]
    }
}
