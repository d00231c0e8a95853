//! Results folder: written during the run, readable during the run, afterwards and after a crash.
//!
//! | file | content |
//! |---|---|
//! | `model.toml` | text of the model file |
//! | `results.parquet` | columns of the run, one row per instant, with their units |
//! | `states.parquet` | coordinates, velocities, accelerations and multipliers at some instants |
//! | `probes.csv` | columns as text |
//! | `summary.json` | outcome and counts of the run, written at its end |
//! | `display` | surfaces of rigid bodies that contain meshes of files |
//! | `checkpoint` | state from which the run can be resumed |
//!
//! The results folder of a sequence of analyses has the model file `sequence.toml` and a results folder of each analysis, such as
//! `1-hang`.
//!
//! During the run, rows are stored in `results.parquet.parts/` and `states.parquet.parts/`. Each part is a Parquet file with a
//! fixed number of rows. About once a second, the last part is replaced by a longer one. At the end, the parts become the row
//! groups of one file. All files are complete at any time, even if the run is killed.
//!
//! Parquet files contain their origin as key-value metadata: `program`, `model` (its text), `sha256` (of that text) and `units`
//! (JSON, by column; dimensions in words if the model does not name its units).
//!
//! [`Recorder`] observes a run and writes its folder. [`Results`] reads the folder.
//!
//! ```text
//!   record   read       selection of rows and states, checkpoints; results
//!        \   /
//!        table          Parquet files in parts
//!          |
//!        folder         paths, lock, summary, whole files
//! ```

mod folder;
mod read;
mod record;
mod table;

pub use folder::{Folder, SummaryFile, sequence_file, write_atomically, write_sequence};
pub use read::{KILLED, OpenError, Results, RunStatus, StoredState, given_state};
pub use record::{CheckpointError, CheckpointInterval, ExpectedSize, Recorder};
pub use table::{checksum_placeholder, verify_checksums, write_checksums};
