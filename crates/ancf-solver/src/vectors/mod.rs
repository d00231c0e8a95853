//! Operations on vectors of all unknowns, by threads if the vectors are long.

mod chunks;
mod products;
mod pseudo_random;

pub(crate) use chunks::{copy, for_each_chunk, for_each_chunk_of, largest_of_chunks, sum_of_chunks};
pub(crate) use products::{dot, norm};
pub(crate) use pseudo_random::PseudoRandom;
