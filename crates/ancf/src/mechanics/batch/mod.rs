//! Elements evaluated side by side, in the lanes of the machine's vectors ([`Batch`](crate::system::Batch)).

mod beam;
mod beam_law;
mod bend;
mod cable;
mod kernel;
mod lane;
mod pass;
mod plan;
mod relative;
mod stiffness;
mod strain;
mod triangle;

use crate::system::Batch;

/// Elements that can be evaluated side by side.
pub(super) trait Batched: Sized {
    /// Batches of elements, each with the number of its first one.
    fn batches(elements: &[Self]) -> Vec<(usize, Box<dyn Batch>)>;
}
