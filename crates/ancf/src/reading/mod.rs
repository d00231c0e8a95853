//! Models from text, from parts, and with supplied functions.

mod check;
mod part;
mod read;
mod substitute;
mod supply;

pub use part::check_part;
pub use read::parse_as;
pub use substitute::substitute;
