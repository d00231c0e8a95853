//! Tables of a run as Parquet files: written in parts, merged at the end, and read at any time.

mod checksums;
mod collected;
mod growing_table;
mod layout;
mod merge;
mod parts;
mod provenance;
mod reader;
mod state_layout;

pub use checksums::{checksum_placeholder, write_checksums};
pub(crate) use growing_table::GrowingTable;
pub(crate) use layout::Layout;
pub(crate) use provenance::{PROGRAM, Provenance};
pub use reader::verify_checksums;
pub(crate) use reader::{has_checksums, has_column, metadata_of_table, rows_of_part, verify};
pub(crate) use state_layout::{ANGLES, angles, numbers_of_state, state_layout};
