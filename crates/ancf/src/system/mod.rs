//! FLOOR 0: equations of motion without mechanics. Coordinates, multipliers, sums of local terms, sparse matrices.

mod assembly;
mod batch;
mod branches;
mod dense;
mod dependence;
mod elimination;
mod encounter;
mod equations;
mod factor;
mod front;
mod kernel;
mod ldlt;
mod lists;
mod matrix;
mod order;
mod panel;
mod parts;
mod pattern;
mod scatter;
mod state;
mod substitution;
mod term;

pub use assembly::System;
pub use batch::{Batch, LANES, Lanes, LocalLanes};
pub use dependence::{Dependence, INDEPENDENT, all_constraint_rows, constraint_rows, dependences};
pub use encounter::{Encounters, Met, Pair};
pub use equations::{Energy, EquationsOfMotion, Level, Power};
pub use factor::{Course, Factor, SingularMatrix};
pub use kernel::{Kernel, Sparse};
pub use matrix::SparseMatrix;
pub use pattern::Pattern;
pub use scatter::Scatter;
pub use state::{State, Weights};
pub use term::{LOCAL, Local, LocalMatrix, Term, dissipated, supplied};
