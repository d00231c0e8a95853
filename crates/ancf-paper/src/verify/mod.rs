//! Verification problems: solution, verdicts, report.
//!
//! ```text
//! problems -> verdicts -> observer
//!                |    \-> JSON
//!              page, plots -> HTML
//! ```

mod page;
mod plot;
mod record;
mod report;
mod solve;
mod verdict;

pub use record::VerificationRecord;
pub use report::write_verification;
pub use solve::solve_problems;
pub use verdict::ProblemVerdict;
