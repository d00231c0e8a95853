//! Data of a model as its user states it: plain values in the user's units.

mod analyses;
mod bodies;
mod contacts;
mod functions;
mod loads;
mod queries;
mod sections;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use analyses::{
    About, Analysis, Buckling, Dynamics, Modes, NewtonMethod, Output, Path, Probe, Quantity, Scheme, Sense,
    Start, Statics, Step, Stop,
};
pub use bodies::{
    At, Beam, Body, Cable, Formulation, InitialMotion, Named, Place, PointMass, Rigid, Shape, Slopes,
};
pub use contacts::{Against, Contact};
pub use functions::{TimeFunction, Varying};
pub use loads::{Fluid, Load};
pub use sections::{Damping, Material, MaterialLaw, Section};

pub use crate::errors::{ModelError, ModelErrors, Position};
pub use crate::joints::{
    AngularDrive, AngularFriction, AngularSpring, Bushing, Clamp, Clamped, Coupled, Coupling, Cylindrical,
    Distance, DrivenClamp, End, Freed, Ground, Joint, LinearDrive, LinearFriction, LinearSpring, Planar,
    PointOnLine, PointSpring, Prismatic, Revolute, Slide, Spherical, Universal,
};
pub use crate::units::{ScaleChoice, Units};
pub(crate) use bodies::ON_AXIS;
pub(crate) use functions::Clock;
pub(crate) use loads::Stretch;
pub(crate) use queries::{beams_of, bodies_of, joints_of, loads_of};

// TEMPORARY FACADE
#[doc(hidden)]
pub use crate::errors::nearest;
pub use crate::{assembly::*, diagnosis::*, reading::*, schema::*, units::*};
// END

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
