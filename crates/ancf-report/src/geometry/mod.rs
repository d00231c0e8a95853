//! Shapes of the bodies of a model: outlines of sections, boxes of rigid bodies, symbols, links and obstacles.
//!
//! Everything is in the user's units and plain data, so that other programs can draw it. Shapes of a model without a run are
//! given by [`outline`], [`outline_at`], [`inertia_box`] and [`arms`]. Positions in a state are given by [`Geometry`] and
//! [`symbols`].

mod arms;
mod attachments;
mod body_shape;
mod bounding_box;
mod inertia_box;
mod link;
mod obstacle;
mod outline;
mod shell_objects;
mod stations;
mod symbol;
mod triad;

pub use arms::{Arm, arms};
pub(crate) use attachments::Attachments;
pub use body_shape::{BodyKind, BodyShape, SurfaceGrid};
pub(crate) use bounding_box::bounding_box;
pub use inertia_box::{BOX_EDGE, InertiaBox, POINT_MASS_RADIUS, inertia_box};
pub(crate) use link::links;
pub use link::{ARM, Link, model_links};
pub(crate) use obstacle::{DrawnShape, Obstacle, obstacles};
pub use outline::{Outline, SIDES, outline, outline_at};
pub(crate) use shell_objects::{ARROWS, EdgeSupport, ShellLoad, edge_supports, shell_loads};
pub use stations::{Geometry, Placement};
pub use symbol::{Symbol, SymbolKind, Symbols, symbols};
pub(crate) use triad::Triad;
