//! Functions of time that multiply loads and drives, and laws of forces of joints.

mod input;
mod joint_law;
mod law_signal;
mod law_state;
mod time_function;

pub use input::Input;
pub use joint_law::{JointLaw, LawKind, LawUse};
pub use law_signal::LawSignal;
pub use law_state::LawStateEquation;
pub(crate) use time_function::TimeMode;
pub use time_function::{TimeFunction, Varying};
