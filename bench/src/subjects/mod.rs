//! Work to be measured, on cantilevers of beam or cable elements and on cables in contact.

mod cantilever;
mod contact_steps;
mod element_evaluation;
mod element_kernels;
mod linear_solution;
mod plant;
mod result;
mod subject;
mod system_evaluation;
mod time_steps;

pub use cantilever::{CantileverKind, STEP, cantilever, read_cantilever};
pub use contact_steps::ContactSteps;
pub use element_evaluation::ElementEvaluation;
pub use element_kernels::ElementKernels;
pub use linear_solution::LinearSolution;
pub use plant::{Plant, step};
pub use result::Result;
pub use subject::{Evaluation, Subject};
pub use system_evaluation::SystemEvaluation;
pub use time_steps::TimeSteps;
