use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::scales::Scales;

/// How the units of the equations are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ScaleChoice {
    /// The user's own: the dimensional form.
    #[default]
    None,
    /// Of Kim et al. (2017): length of the beam, weight of one element, time by eq. (7). For one beam under gravity.
    Paper,
    /// The longest body's length L; the weight of that body, or E I/L² without gravity; time by eq. (7); each rounded to a
    /// power of two, so that nothing is lost on the way to these units and back.
    Auto,
    /// Given by number.
    Given {
        /// Unit of length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// Unit of force.
        #[schemars(extend("exclusiveMinimum" = 0))]
        force: f64,
        /// Unit of time; by eq. (7) with the ρA of the longest body if left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        time: Option<f64>,
    },
}

/// The units chosen for a model, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The units.
    pub scales: Scales,
    /// How they were chosen, in words.
    pub reason: String,
}
