//! Functions of time that multiply loads and drives, and laws of forces of joints.

mod input;
mod joint_law;
mod time_function;

pub use input::Input;
pub use joint_law::{JointLaw, LawKind, LawUse};
pub(crate) use time_function::TimeMode;
pub use time_function::{TimeFunction, Varying};
