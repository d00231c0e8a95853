//! Equations of motion as a sum of terms: states, local terms and the assembled system.

mod batch;
mod constraint_rows;
mod contact_pairs;
mod law_changes;
mod motion_equations;
mod scatter;
mod stiffness_products;
mod system;
mod system_equations;
mod term_sums;
mod terms;
mod thread_parts;

pub use batch::{Batch, LANES, Lanes, LocalLanes, MAX_UNKNOWNS};
pub use constraint_rows::{REDUNDANCY_TOLERANCE, all_constraint_rows, constraint_rows};
pub use contact_pairs::{ActiveGroup, ActivePair, ContactGroup, ContactPair, ContactSearch, active_terms};
pub use law_changes::LawChanges;
pub use motion_equations::EquationsOfMotion;
pub use scatter::Scatter;
pub use stiffness_products::StiffnessProducts;
pub use system::System;
pub use term_sums::{LocalState, Rotation};
pub use terms::{
    Energy, Inadmissibility, LOCAL, Level, Local, LocalMatrix, LocalStep, Power, ProductColumn, State,
    StepStates, Term, Weights, correct_work, discrete_residual, load_power, middle_residual,
    quadratic_constraints, velocity_forces,
};
