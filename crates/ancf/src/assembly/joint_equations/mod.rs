//! Joints as equations between markers.

mod freedom;
mod gap;
mod joint_builder;
mod joint_links;
mod measures;

pub use freedom::Freedom;
pub use gap::Closed;
pub(crate) use gap::Gap;
pub(crate) use joint_builder::{Holds, JointEquations};
