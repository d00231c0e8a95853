//! Elements evaluated side by side, in the lanes of the machine's vectors ([`Batch`](crate::system::Batch)).

mod beam;
mod beam_law;
mod lane;
mod pass;
mod plan;
mod relative;
mod stiffness;
mod strain;
mod triangle;

pub(super) use beam::Batched;
