//! Recording of a run into its folder.

mod checkpoint;
mod expected_size;
mod recorder;
mod row_selection;
mod run_files;
mod state_selection;

pub use checkpoint::{CheckpointError, CheckpointInterval};
pub use expected_size::ExpectedSize;
pub use recorder::Recorder;
