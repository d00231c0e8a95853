//! The folder of a run: written while the run goes on, readable while it does, after it, and after a crash.
//!
//! | file | what |
//! |---|---|
//! | `model.toml` | the text of the model that was run |
//! | `results.parquet` | the columns of the run, one row an instant, with their units |
//! | `states.parquet` | coordinates, velocities, accelerations and multipliers of some of its instants |
//! | `probes.csv` | the columns once more, as text |
//! | `summary.json` | how the run ended and what it did; there is none before |
//! | `checkpoint` | from where the run can be continued |
//!
//! While the run goes on, rows stand in `results.parquet.parts/` and `states.parquet.parts/`: Parquet files of so many rows
//! each, of which the last one is replaced by a longer one about once a second. At the end they become one file, a row group
//! each. Whatever moment a run is killed at, all files are whole.
//!
//! Parquet files say where they come from, as key-value metadata: `program`, `model` (its text), `sha256` (of that text),
//! `units` (JSON, by column; of a model that does not name its units, dimensions in words).
//!
//! [`Recorder`] observes a run and writes; [`Results`] reads. The same floor as a sink: it knows models, rows and states, and
//! no mechanics.

mod checkpoint;
mod conclusion;
mod folder;
mod frames;
mod layout;
mod merge;
mod provenance;
mod read;
mod recorder;
mod results;
mod table;
mod thinned;

pub use checkpoint::{CheckpointError, Every};
pub use conclusion::Conclusion;
pub use folder::{Folder, whole};
pub use recorder::Recorder;
pub use results::{Frame, KILLED, OpenError, Results, Status};
