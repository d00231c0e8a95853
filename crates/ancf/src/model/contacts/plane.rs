use ancf_mechanics::contact::ObstacleShape;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::obstacle::ObstacleKind;
use crate::model::bodies::Place;
use crate::units::Scaled;

/// Half space behind a plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// Point of the plane in the undeformed state, length.
    #[unit(length)]
    pub point: [f64; 3],
    /// Normal in the undeformed state, towards the bodies, of any length.
    #[unit(none)]
    pub normal: [f64; 3],
    /// Place that carries the obstacle; the ground by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub on: Option<Place>,
}

impl ObstacleKind for Plane {
    fn shape(&self) -> ObstacleShape {
        ObstacleShape::Plane
    }

    fn point(&self) -> [f64; 3] {
        self.point
    }

    fn axis(&self) -> Option<(&'static str, [f64; 3])> {
        Some(("normal", self.normal))
    }

    fn on(&self) -> Option<&Place> {
        self.on.as_ref()
    }
}
