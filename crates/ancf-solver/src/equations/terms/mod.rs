//! States, energies and the interface of a term of the equations of motion.

mod energy;
mod local;
mod product_column;
mod state;
mod term;

pub use energy::{Energy, Level, Power};
pub use local::{LOCAL, Local, LocalMatrix, LocalStep};
pub use product_column::ProductColumn;
pub use state::{Inadmissibility, State, StepStates, Weights};
pub use term::{
    Term, correct_work, discrete_residual, load_power, middle_residual, quadratic_constraints,
    velocity_forces,
};
