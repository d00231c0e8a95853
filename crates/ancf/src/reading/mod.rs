//! Reading of models from text, checks of models and parts, and supplied functions.

mod check;
mod meshes;
mod model_file;
mod part;
mod read;
mod sequence;
mod substitute;
mod supply;
mod valid_model;

pub use meshes::embed_mesh_files;
pub use model_file::ModelFile;
pub use part::check_part;
pub use read::{parse_as, with_places};
pub use sequence::{AnalysisSequence, SequenceStage};
pub use substitute::{substitute, values_at};
pub use valid_model::ValidModel;
