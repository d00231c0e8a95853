//! Recording of a run into its folder.

mod checkpoint;
mod recorder;
mod row_selection;
mod run_files;
mod state_selection;

pub use checkpoint::{CheckpointError, CheckpointInterval};
pub use recorder::Recorder;
