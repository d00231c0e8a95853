//! Results of a study: rows in memory and in Parquet files.

mod error;
mod files;
mod parameter_type;
mod range;
mod read;
mod results;
mod write;

pub use error::{StudyError, TableError};
pub(crate) use files::open_table;
pub use files::table_files;
pub use parameter_type::ParameterType;
pub use range::ObjectiveRange;
pub use read::read_rows;
pub use results::{StudyOutcome, StudyResults};
pub use write::StudyTable;
