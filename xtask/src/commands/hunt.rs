//! Hunt: random models, held to the same physics as their twins.

use crate::system::shell::{Done, cargo};

/// Runs the program of crate `ancf-hunt`.
pub(crate) fn hunt(options: &[String]) -> Done {
    let mut arguments = vec!["run", "--quiet", "-p", "ancf-hunt", "--"];
    arguments.extend(options.iter().map(String::as_str));
    cargo("hunt", &arguments, &[])
}
