use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::Place;
use crate::units::Scaled;

/// Second end of a joint.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// Fixed frame: `"ground"`.
    #[default]
    Ground,
    /// Place on another body.
    #[serde(untagged)]
    Place(Place),
    /// Point of the fixed frame. In statics the load factor moves the first end to it.
    #[serde(untagged)]
    Point(Ground),
}

/// Point of the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Coordinates of the point, length.
    #[unit(length)]
    pub point: [f64; 3],
}
