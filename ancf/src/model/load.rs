use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Place;

/// A load on a body. Gravity is a property of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Load {
    /// A force on a point of the axis, constant in size and in direction.
    Force {
        /// Where it acts.
        on: Place,
        /// The force in the global frame.
        force: [f64; 3],
    },
}
