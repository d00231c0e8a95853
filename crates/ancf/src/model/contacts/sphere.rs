use ancf_mechanics::contact::ObstacleShape;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::obstacle::ObstacleKind;
use crate::model::bodies::Place;
use crate::units::Scaled;

/// Sphere, solid or hollow.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// Centre in the undeformed state, length.
    #[unit(length)]
    pub center: [f64; 3],
    /// Radius, length.
    #[unit(length)]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: f64,
    /// True if the bodies are inside.
    #[serde(default)]
    pub inside: bool,
    /// Place that carries the obstacle; the ground by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub on: Option<Place>,
}

impl ObstacleKind for Sphere {
    fn shape(&self) -> ObstacleShape {
        ObstacleShape::Sphere { radius: self.radius, inside: self.inside }
    }

    fn point(&self) -> [f64; 3] {
        self.center
    }

    fn axis(&self) -> Option<(&'static str, [f64; 3])> {
        None
    }

    fn on(&self) -> Option<&Place> {
        self.on.as_ref()
    }
}
