//! Results of a study: rows in memory and in Parquet files.

mod error;
mod parameter_type;
mod read;
mod results;
mod write;

pub use error::{StudyError, TableError};
pub use parameter_type::ParameterType;
pub use read::read_rows;
pub use results::{ObjectiveRange, StudyOutcome, StudyResults};
pub use write::StudyTable;
