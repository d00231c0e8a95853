//! FLOOR 2: what the user states. Plain data in the user's units and the field's words.

mod acting;
mod address;
mod analysis;
mod assemble;
mod body;
mod check;
mod check_abilities;
mod check_bodies;
mod check_contacts;
mod check_joints;
mod check_loads;
mod closing;
mod contact;
mod coupling;
mod cubature;
mod diagnosis;
mod equilibrium;
mod error;
mod fluid;
mod freedom;
mod function;
mod inputs;
mod joint;
mod joint_kinds;
mod joint_rows;
mod link;
mod load;
mod material;
mod mechanism;
mod meshes;
mod motion;
mod output;
mod part;
mod read;
mod redundant;
mod rigid;
mod rigidity;
mod scale;
mod scale_choice;
mod scale_joints;
mod schema;
mod scheme;
mod section;
mod shape;
mod spread;
mod substitute;
mod supply;
mod survey;
mod syntax;
mod ties;
mod times;
mod units;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use acting::{AngularDrive, AngularFriction, AngularSpring, LinearDrive, LinearFriction, LinearSpring};
pub use analysis::{Analysis, Dynamics, NewtonMethod, Scheme, Start, Step, Stop};
pub use assemble::{Assembly, Measure};
pub use body::{At, Beam, Body, Cable, Formulation, Named, Place, Slopes};
pub use closing::Closed;
pub use contact::{Against, Contact};
pub use coupling::{Coupled, Coupling, Freed};
pub use diagnosis::Diagnosis;
pub use equilibrium::{About, Buckling, Modes, Path, Sense, Statics};
pub use error::{ModelError, ModelErrors, Position};
pub use fluid::Fluid;
pub use freedom::Freedom;
pub use function::{TimeFunction, Varying};
pub use joint::{Clamped, End, Ground, Joint};
pub use joint_kinds::{
    Bushing, Cylindrical, Distance, Planar, PointOnLine, PointSpring, Prismatic, Slide, Universal,
};
pub use load::Load;
pub use material::{Damping, Material, MaterialLaw};
pub use mechanism::{FreeMotion, Motion};
pub use motion::InitialMotion;
pub use output::{Output, Probe, Quantity};
pub use part::check_part;
pub use read::parse_as;
pub use redundant::Redundant;
pub use rigid::{PointMass, Rigid};
pub use scale_choice::{Chosen, ScaleChoice};
pub use schema::{nearest, schema, schema_text};
pub use section::Section;
pub use shape::Shape;
pub use substitute::substitute;
pub use survey::join;
pub use units::Units;

/// A flexible multibody model as its user states it.
///
/// Every number is in the user's own coherent units (m-kg-s, mm-t-s, ...). The same type is read from TOML,
/// built in Rust, printed, and rewritten in other units by [`Model::scaled`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "ancf model",
    description = "A flexible multibody model.\n\nEvery number is in your own coherent units (m-kg-s, mm-t-s, ...)."
)]
pub struct Model {
    /// A line that says what this model is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// What its units are called, for axes and result files; nothing is converted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Units>,
    /// Acceleration of gravity, length/time²; no gravity by default.
    #[serde(default)]
    pub gravity: [f64; 3],
    /// Materials by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, Material>,
    /// Cross-sections by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sections: BTreeMap<String, Section>,
    /// The bodies, flexible and rigid.
    #[schemars(length(min = 1))]
    pub bodies: Vec<Body>,
    /// Joints that tie bodies to the ground or to each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<Joint>,
    /// Gears, racks, belts: joints that move together.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub couplings: Vec<Coupling>,
    /// Loads besides gravity.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Load>,
    /// Whether gaps between the places of joints are closed before the analysis begins; they are refused by default.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub assemble: bool,
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

impl Model {
    /// What its units are called, in words if it does not name them.
    pub fn unit_names(&self) -> Units {
        self.units.clone().unwrap_or_else(Units::in_words)
    }
}
