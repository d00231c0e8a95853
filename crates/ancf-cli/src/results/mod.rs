//! Commands about the results of a run: `ancf report`, `view`, `paraview`.

mod paraview;
mod report;
mod run_folder;
mod scene;
#[cfg(feature = "figures")]
mod study;
mod view;

pub use paraview::{PARAVIEW_EXAMPLES, ParaviewArguments};
pub use report::{REPORT, REPORT_EXAMPLES, ReportArguments, write_report};
pub use run_folder::open_run;
pub use view::{VIEW_EXAMPLES, ViewArguments};
