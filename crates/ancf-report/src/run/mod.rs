//! Input of reports: the recording of a run, its summary in words, and the selection of frames.

mod frame_selection;
mod recording;
mod summary_text;

pub use frame_selection::FrameSelection;
pub(crate) use frame_selection::evenly_spaced;
pub use recording::{Ending, Recording, Snapshot};
pub use summary_text::{summary_rows, summary_warnings};
