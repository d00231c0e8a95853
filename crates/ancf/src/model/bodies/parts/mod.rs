//! Places on bodies and their initial motion.

mod edge_name;
mod motion;
mod place;

pub use edge_name::EdgeName;
pub use motion::InitialMotion;
pub use place::{At, EdgePlace, NamedPosition, NodePlace, Place, PointPlace};
