//! Models with elements of half the size, and the comparison of values on both meshes.

mod convergence;
mod finer_mesh;
mod halved_mesh;
mod halved_model;
mod recorded_values;

pub(crate) use convergence::GIVEN_START;
pub(super) use convergence::{Convergence, has_poisson_locking};
pub use finer_mesh::FinerMesh;
pub(crate) use halved_model::HalvedModel;
pub(super) use halved_model::halved;
pub(super) use recorded_values::{RecordedValues, ValueChange, surface_values};
