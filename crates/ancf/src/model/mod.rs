//! Data of a model as given by the user, in the user's units.

mod analyses;
mod bodies;
mod contacts;
mod functions;
mod indexed;
mod queries;
mod sections;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

use crate::units::Scaled;

pub use analyses::{
    About, Analysis, Buckling, Dynamics, EndCondition, EnergyGuard, Initial, InitialStatics, Modes,
    NewtonMethod, Origin, Output, Path, Probe, Quantity, Scheme, Sense, Start, Statics, Step, Stop, Unstable,
};
pub use bodies::{
    AngleField, At, AxisField, Beam, Body, BodySurface, Cable, Capability, DisplayShape, EdgeName, EdgePlace,
    ElementMesh, ElementNodes, FibreAngle, FibreAxis, Formulation, InitialMotion, Layer, Layup, Membrane,
    MembraneKind, MeshGroup, NamedPosition, NodePlace, Place, PointMass, PointPlace, Rigid, Shape,
    ShearShell, Shell, ShellSurface, ShellThickness, Slopes, ThicknessField,
};
pub use contacts::{Contact, ContactSurface, Cylinder, ObstacleKind, Plane, Sphere};
pub use functions::{Input, JointLaw, LawKind, LawSignal, LawStateEquation, LawUse, TimeFunction, Varying};
pub use sections::{
    Circle, CustomSection, Damping, Ellipse, GeneralSection, Material, MaterialLaw, Orthotropic,
    OutlineCurve, Rectangle, Section, SectionObject, SectionOutline, SectionShape, Tube,
};

pub use crate::errors::{ModelError, ModelErrors, Position};
pub use crate::joints::{
    AngularDrive, AngularFriction, AngularSpring, AngularStops, Bushing, Clamp, ClampedGradients, Coupled,
    Coupling, Cylindrical, DirectionMotion, Distance, DrivenClamp, End, Generic, Ground, Joint,
    JointCoordinate, LinearDrive, LinearFriction, LinearSpring, LinearStops, MatrixBushing, Measure, Planar,
    PointOnLine, PointSpring, Prismatic, Revolute, Seam, SeamCondition, Sensor, Slide, Spherical, Support,
    SupportCondition, SupportedAxis, Universal,
};
pub use crate::loads::{
    BaseAcceleration, BaseRotation, DistributedForce, DistributedMoment, EdgeForce, EdgeMoment, ExternalLoad,
    Fluid, Load, PointForce, PointMoment, SurfaceFluid, SurfaceForce, SurfacePressure,
};
pub use crate::units::{ScaleChoice, Units};
pub(crate) use bodies::{
    FieldDefect, FieldShell, ON_AXIS, SurfaceGeometry, axis_on_shell, edge_of_shell, elements_of, named,
    no_projection, region_of_shell, shell_body,
};
pub(crate) use functions::TimeMode;
pub(crate) use indexed::IndexedModel;
pub(crate) use queries::{beams_of, bodies_of, joints_of, loads_of, shear_shells_of, shells_of};
pub(crate) use sections::disk_area;

/// Flexible multibody model as given by the user.
///
/// All numbers are in any coherent system of units (m-kg-s, mm-t-s, ...). A model is read from TOML or built in Rust.
/// [`Model::scaled`] converts it to other units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[unit(partial)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "ancf model",
    description = "Flexible multibody model.\n\nAll numbers are in any coherent system of units (m-kg-s, mm-t-s, ...)."
)]
pub struct Model {
    /// Title in one line.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// Names of the units, for axes and result files. Nothing is converted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub units: Option<Units>,
    /// Acceleration of gravity, length/time²; no gravity by default.
    #[serde(default)]
    #[unit(length / time^2)]
    pub gravity: [f64; 3],
    /// Materials by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, Material>,
    /// Cross-sections by name.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty", serialize_with = "stated_sections")]
    pub sections: BTreeMap<String, Section>,
    /// Flexible and rigid bodies.
    #[schemars(length(min = 1))]
    pub bodies: Vec<Body>,
    /// Joints between bodies, or between a body and the ground.
    #[serde(default, skip_serializing_if = "Vec::is_empty", serialize_with = "stated_joints")]
    pub joints: Vec<Joint>,
    /// Couplings of joints, such as gears, racks and belts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[unit(depends)]
    pub couplings: Vec<Coupling>,
    /// Loads in addition to gravity.
    #[serde(default, skip_serializing_if = "Vec::is_empty", serialize_with = "stated_loads")]
    pub loads: Vec<Load>,
    /// Inputs, which a program sets between time steps.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub inputs: Vec<Input>,
    /// True to close gaps of joints before the analysis; false by default. Otherwise gaps are errors.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub assemble: bool,
    /// Contacts of bodies with obstacles and with each other.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<Contact>,
    /// Units in which the equations are solved; automatic units by default.
    #[serde(default)]
    pub scales: ScaleChoice,
    /// State at the start of dynamics; the undeformed state by default.
    #[serde(default, skip_serializing_if = "Initial::is_default")]
    pub initial: Initial,
    /// Analysis to run.
    pub analysis: Analysis,
    /// Places where results are recorded.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub probes: Vec<Probe>,
    /// Content and frequency of the output.
    #[serde(default)]
    pub output: Output,
}

impl Model {
    /// Names of the units, or `length`, `time` and `force` if the model does not name them.
    pub fn unit_names(&self) -> Units {
        self.units.clone().unwrap_or_else(Units::in_words)
    }
}

/// Writes the sections that a model file can state.
fn stated_sections<S: Serializer>(sections: &BTreeMap<String, Section>, to: S) -> Result<S::Ok, S::Error> {
    to.collect_map(sections.iter().filter(|(_, section)| !matches!(section, Section::Custom(_))))
}

/// Writes the joints that a model file can state.
fn stated_joints<S: Serializer>(joints: &[Joint], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(joints.iter().filter(|joint| !matches!(joint, Joint::Custom(_))))
}

/// Writes the loads that model files can contain.
fn stated_loads<S: Serializer>(loads: &[Load], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(loads.iter().filter(|load| !matches!(load, Load::Custom(_))))
}
