use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::Place;

/// What a joint ties its first end to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum End {
    /// The fixed frame: `"ground"`.
    #[default]
    Ground,
    /// A place on another body.
    #[serde(untagged)]
    Place(Place),
    /// A point of the fixed frame, to which statics draws the first end by the load.
    #[serde(untagged)]
    Point(Ground),
}

/// A point of the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// The point, length.
    pub point: [f64; 3],
}
