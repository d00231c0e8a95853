//! FLOOR 2: what the user states. Plain data in the user's units and the field's words.

mod analysis;
mod assemble;
mod body;
mod check;
mod check_bodies;
mod check_contacts;
mod contact;
mod cubature;
mod equilibrium;
mod error;
mod function;
mod joint;
mod load;
mod material;
mod mechanism;
mod output;
mod read;
mod redundant;
mod rigidity;
mod scale;
mod schema;
mod scheme;
mod section;
mod shape;
mod survey;
mod syntax;
mod ties;
mod times;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use analysis::{Analysis, Dynamics, Scheme, Start, Step, Stop};
pub use assemble::{Assembly, Measure};
pub use body::{At, AtEnd, Beam, Body, Cable, Formulation, Place, Slopes};
pub use contact::{Against, Contact};
pub use equilibrium::{About, Buckling, Modes, Path, Sense, Statics};
pub use error::{ModelError, ModelErrors, Position};
pub use function::{TimeFunction, Varying};
pub use joint::{Clamped, End, Ground, Joint};
pub use load::Load;
pub use material::{Damping, Material, MaterialLaw};
pub use mechanism::{FreeMotion, Motion};
pub use output::{Output, Probe, Quantity};
pub use scale::{Chosen, ScaleChoice};
pub use schema::{schema, schema_text};
pub use section::Section;
pub use shape::Shape;

/// A flexible multibody model as its user states it.
///
/// Every number is in the user's own coherent units (m-kg-s, mm-t-s, ...). The same type is read from TOML,
/// built in Rust, printed, and rewritten in other units by [`Model::scaled`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "ancf model")]
pub struct Model {
    /// A line that says what this model is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Acceleration of gravity, length/time²; no gravity by default.
    #[serde(default)]
    pub gravity: [f64; 3],
    /// Materials by name.
    pub materials: BTreeMap<String, Material>,
    /// Cross-sections by name.
    pub sections: BTreeMap<String, Section>,
    /// The flexible bodies.
    #[schemars(length(min = 1))]
    pub bodies: Vec<Body>,
    /// Joints that tie bodies to the ground or to each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Joint>,
    /// Loads besides gravity.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Load>,
    /// What bodies may touch: obstacles and each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<Contact>,
    /// Units in which the equations are solved; the user's own by default.
    #[serde(default)]
    pub scales: ScaleChoice,
    /// What to compute.
    pub analysis: Analysis,
    /// Points whose motion is recorded.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub probes: Vec<Probe>,
    /// What is written, and how often.
    #[serde(default)]
    pub output: Output,
}
