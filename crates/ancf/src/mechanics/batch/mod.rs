//! Elements evaluated side by side, in the lanes of the machine's vectors ([`Batch`](crate::system::Batch)).

mod batched;
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

pub(super) use batched::Batched;
