//! Bodies of a model: beams, cables, shells, rigid bodies, their shape and initial motion.

mod body;
mod capability;
mod display;
mod formulation;
mod parts;
mod rigid;
mod shape;
mod shell_body;
mod shells;
mod surface;

pub(crate) use body::ON_AXIS;
pub use body::{Beam, Body, Cable, Slopes};
pub use capability::Capability;
pub use display::DisplayShape;
pub use formulation::Formulation;
pub use parts::{At, EdgeName, EdgePlace, InitialMotion, NamedPosition, NodePlace, Place, PointPlace};
pub use rigid::{PointMass, Rigid};
pub use shape::Shape;
pub(crate) use shell_body::{
    axis_on_shell, edge_of_shell, elements_of, named, no_projection, region_of_shell, shell_body,
};
pub use shells::{
    AngleField, AxisField, ElementMesh, ElementNodes, FibreAngle, FibreAxis, Layer, Layup, Membrane,
    MembraneKind, MeshGroup, ShearShell, Shell, ShellSurface, ShellThickness, ThicknessField,
};
pub(crate) use shells::{FieldDefect, FieldShell, SurfaceGeometry};
pub use surface::BodySurface;
