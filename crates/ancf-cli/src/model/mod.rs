//! Commands about model files: `ancf new`, `check`, `fmu`, `scaled`, `schema`.

mod check;
mod display;
mod fmu;
mod new;
mod scaled;
mod schema;
mod sequence;
mod start;

pub use check::{CHECK_EXAMPLES, CheckArguments};
pub use display::surfaces_of;
pub use fmu::{FMU_EXAMPLES, FmuArguments};
pub use new::{NEW_EXAMPLES, NewArguments};
pub use scaled::{SCALED_EXAMPLES, ScaledArguments};
pub use schema::{SCHEMA_EXAMPLES, print_schema};
pub use sequence::check_stages;
pub use start::start_of;
