//! Every table and figure of Kim et al. (2017), and the report of the verification problems.
//!
//! ```text
//! cases -> results -> tables -> CSV
//!    \        |   \       \
//!     \       |  figures   \ -> SVG, PNG
//!      \      |       \     \
//!       `-----+-> JSON  sections -> HTML
//! ```
//!
//! `verify` solves the problems of `ancf_verification` and writes a page about them.

mod cases;
mod figures;
mod page;
mod report;
mod results;
mod sections;
mod tables;
mod verify;

pub use cases::PaperRuns;
pub use page::{HtmlPage, PageSection, ReportFolder, figure};
pub use report::write_paper;
pub use results::PaperResults;
pub use verify::{ProblemVerdict, VerificationRecord, solve_problems, write_verification};
