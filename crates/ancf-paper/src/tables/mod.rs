//! Tables of the report.

mod common;
mod comparison;
mod paper_tables;
mod printed;
mod table;

pub use paper_tables::PaperTables;
pub use table::{CellValue, PaperTable};
