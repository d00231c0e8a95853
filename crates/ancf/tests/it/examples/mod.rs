//! Models of `models/` against the results stated in their comments.

mod machines;
mod ropes;
mod shells;
