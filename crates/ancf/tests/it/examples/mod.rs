//! The models of `models/`, each with a line of physics: what its comment promises.

mod machines;
mod ropes;
