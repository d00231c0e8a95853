//! HTML pages: layout, number formats, machine, output folder.

mod layout;
mod machine;
pub mod number;
mod report_folder;

pub use layout::{HtmlPage, PageSection, figure};
pub use machine::MachineInfo;
pub use report_folder::ReportFolder;
