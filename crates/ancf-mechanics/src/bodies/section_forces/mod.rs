//! Section forces between the nodes of elements, and gaps to the exact rod under them.

mod element_forces;
mod resultants;
mod rod_gaps;

pub use rod_gaps::RodGap;
