use std::fmt::Debug;
use std::sync::Arc;

use super::state::State;
use super::term::Term;

/// Two things that may touch, by numbers that their [`Encounters`] know.
pub type Pair = [u32; 2];

/// Terms that act in some states only, such as contacts: of many pairs few are near each other, and those change.
///
/// A term that acts in a state has a distance of at most 0 there. Which others are told, and in which order they were found,
/// must not matter to a motion: they add nothing.
pub trait Encounters: Debug + Send + Sync {
    /// The pairs that are near in a state, in ascending order, with lower bounds of their distances as parts of a margin:
    /// at most 0 for all that act, at most 1 for all that are told.
    fn near(&self, s: &State) -> Vec<(Pair, f64)>;

    /// Whether it can tell of a pair.
    fn has(&self, pair: Pair) -> bool;

    /// The term of a pair that it has.
    fn term(&self, pair: Pair) -> Arc<dyn Term>;
}

/// A pair of one of several encounters.
pub type Met = (usize, Pair);

/// The pairs of several encounters that are near, in ascending order.
pub(crate) fn near(encounters: &[Arc<dyn Encounters>], s: &State) -> Vec<(Met, f64)> {
    let of = |(i, each): (usize, &Arc<dyn Encounters>)| {
        each.near(s).into_iter().map(move |(pair, distance)| ((i, pair), distance))
    };
    encounters.iter().enumerate().flat_map(of).collect()
}

/// Whether a pair within a distance is not among those that were met, which are in order.
pub(crate) fn lacks(met: &[Met], near: &[(Met, f64)], within: f64) -> bool {
    near.iter().any(|(pair, distance)| *distance <= within && met.binary_search(pair).is_err())
}
