//! Bodies of a model: beams, cables, rigid bodies, their shape and initial motion.

mod body;
mod capability;
mod display;
mod formulation;
mod layer;
mod motion;
mod rigid;
mod shape;
mod shell;
mod shell_body;
mod surface;

pub(crate) use body::ON_AXIS;
pub use body::{At, Beam, Body, Cable, EdgePlace, NamedPosition, Place, Slopes};
pub use capability::Capability;
pub use display::DisplayShape;
pub use formulation::Formulation;
pub use layer::Layer;
pub use motion::InitialMotion;
pub use rigid::{PointMass, Rigid};
pub use shape::Shape;
pub use shell::{EdgeName, Shell, ShellSurface};
pub(crate) use shell_body::shell_body;
pub use surface::BodySurface;
