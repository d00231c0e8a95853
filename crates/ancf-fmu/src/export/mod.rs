//! Writing of FMUs.

mod archive;
mod description;
mod library;
mod options;
mod parameters;
mod units;
mod xml;

pub use archive::{Exported, export};
pub use library::library_name;
pub use options::{ExportError, Fmi, Options};
