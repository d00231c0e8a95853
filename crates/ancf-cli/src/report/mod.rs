//! What the reports share: the folder they are written into, the frame of their page, their numbers, the machine.

mod machine;
pub mod number;
mod output;
mod page;

pub use machine::Machine;
pub use output::Output;
pub use page::{Page, Section, figure};
