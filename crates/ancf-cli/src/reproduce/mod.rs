//! Commands that reproduce references: `ancf paper`, `verify`.

mod paper;
mod verify;

pub use paper::{PAPER_EXAMPLES, PaperArguments};
pub use verify::{VERIFY_EXAMPLES, VerifyArguments};
