use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::parts::{LoadBuilder, LoadKind};
use crate::model::TimeFunction;
use crate::units::Scaled;

/// Translational acceleration of the ground. All results are relative to the ground.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct BaseAcceleration {
    /// Acceleration of the ground, length/time².
    #[unit(length / time^2)]
    pub acceleration: [f64; 3],
    /// Function of time that multiplies the load. Statics ignores it, except the value of an input.
    #[serde(default)]
    pub time: TimeFunction,
}

impl LoadKind for BaseAcceleration {
    fn noun(&self) -> &'static str {
        "base acceleration"
    }

    fn is_known_within_elements(&self) -> bool {
        true
    }

    fn build(&self, builder: &mut LoadBuilder<'_>) {
        let function = builder.function(&self.time);
        for marker in builder.mass_markers() {
            builder.force(&marker, -Vector3::from(self.acceleration), function.clone());
        }
    }

    fn time(&self) -> Option<&TimeFunction> {
        Some(&self.time)
    }

    fn time_mut(&mut self) -> Option<&mut TimeFunction> {
        Some(&mut self.time)
    }
}
