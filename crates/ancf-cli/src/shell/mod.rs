//! Commands about the program: `ancf completions`, `ancf man`.

mod completions;
mod man;

pub use completions::{COMPLETIONS_EXAMPLES, CompletionsArguments};
pub use man::{MAN_EXAMPLES, ManArguments};
