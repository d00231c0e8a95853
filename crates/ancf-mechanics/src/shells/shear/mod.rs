//! Shear-deformable shells: four-node elements with a position and a director at each node, on any mesh of quadrilaterals.

mod directors;
mod element;
mod forms;
mod mesh;
mod pressure;
mod profile;
mod rounding;
mod shell_place;
mod stress;
mod surface;
mod topology;

pub use directors::{directors, stress_axis};
pub use element::Shell24;
pub use forms::{NODES, QUAD_VECTORS};
pub use mesh::{ShearShellMesh, SurfacePlace};
pub use pressure::QuadPressure;
pub use profile::{ShearMedium, ShearProfile};
pub use shell_place::ShellPlace;
pub use stress::ShearStressField;
pub use surface::NearestPoint;
pub use topology::{QuadTopology, TopologyDefect};
