//! Evaluation of elements in the lanes of vector registers ([`Batch`](ancf_solver::equations::Batch)).

mod batched;
mod beam;
mod beam_law;
mod bend;
mod cable;
mod kernel;
mod plan;
mod relative;
mod stiffness;
mod strain;
mod triangle;

pub use batched::TermBatch;
pub(crate) use batched::{BatchTerm, alike};
pub(crate) use kernel::{BatchKernel, KernelBatch};
