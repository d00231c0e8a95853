use std::fmt::Debug;
use std::sync::Arc;

use super::state::State;
use super::term::{LOCAL, Term};
use super::term_sums::LocalState;

/// Pair of possible contact partners, by indices of its [`ContactSearch`].
pub type ContactPair = [u32; 2];

/// Search for terms that are active in some states only, such as contacts.
///
/// A term that is active in a state has a distance of at most 0 there. Pairs at a positive distance contribute zero.
/// Neither their selection nor their order may affect the motion.
pub trait ContactSearch: Debug + Send + Sync {
    /// Returns the near pairs in ascending order, with lower bounds of their distances relative to the search margin.
    ///
    /// The bound is at most 0 for all active pairs and at most 1 for all returned pairs.
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)>;

    /// Returns true if the pair belongs to this search.
    fn contains(&self, pair: ContactPair) -> bool;

    /// Returns a coordinate of a body that passes through its contact partner between two states.
    ///
    /// The states are connected by a straight line. The forces at both ends do not resist such a motion.
    fn crossing(&self, _from: &State, _to: &State) -> Option<usize> {
        None
    }

    /// Returns the position on a straight line between two states, from 0 to 1, at which an inactive pair is active.
    ///
    /// Pairs that are active at an end do not count.
    fn passing(&self, _from: &State, _to: &State) -> Option<f64> {
        None
    }

    /// Creates the term of a pair that belongs to this search.
    fn term(&self, pair: ContactPair) -> Arc<dyn Term>;
}

/// Pair together with the index of its search.
pub type ActivePair = (usize, ContactPair);

/// Returns the near pairs of several searches in ascending order.
pub(crate) fn near_pairs(searches: &[Arc<dyn ContactSearch>], s: &State) -> Vec<(ActivePair, f64)> {
    let of = |(i, each): (usize, &Arc<dyn ContactSearch>)| {
        each.near(s).into_iter().map(move |(pair, distance)| ((i, pair), distance))
    };
    searches.iter().enumerate().flat_map(of).collect()
}

/// Returns the terms of the active pairs of several searches.
pub fn active_terms(searches: &[Arc<dyn ContactSearch>], s: &State) -> Vec<Arc<dyn Term>> {
    let near = near_pairs(searches, s).into_iter();
    near.filter(|(_, distance)| *distance <= 0.0).map(|((i, pair), _)| searches[i].term(pair)).collect()
}

/// Distance, relative to the search margin, below which pairs are included before they become active.
const INCLUSION_DISTANCE: f64 = 0.5;

/// Returns the near pairs together with the active pairs in ascending order.
pub(crate) fn with_pairs(near: &[(ActivePair, f64)], active: &[ActivePair]) -> Vec<ActivePair> {
    let mut all: Vec<ActivePair> = near.iter().map(|(pair, _)| *pair).chain(active.iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all
}

/// Returns the pairs whose terms have a force in a state. The terms of the pairs are the last ones.
pub(crate) fn acting_pairs(terms: &[Arc<dyn Term>], pairs: &[ActivePair], s: &State) -> Vec<ActivePair> {
    let (mut gathered, mut rows) = (LocalState::EMPTY, [0.0; LOCAL]);
    let mut acts = |term: &dyn Term| {
        let local = gathered.gather(s, term);
        let rows = &mut rows[..local.q.len() + local.lambda.len()];
        rows.fill(0.0);
        term.residual(&local, rows);
        rows.iter().any(|row| *row != 0.0)
    };
    let terms = &terms[terms.len() - pairs.len()..];
    terms.iter().zip(pairs).filter(|(term, _)| acts(term.as_ref())).map(|(_, pair)| *pair).collect()
}

/// Returns true if a pair within a distance is missing from the sorted active pairs.
pub(crate) fn is_missing(active: &[ActivePair], near: &[(ActivePair, f64)], within: f64) -> bool {
    near.iter().any(|(pair, distance)| *distance <= within && active.binary_search(pair).is_err())
}

/// Returns true if a pair that may become active soon is missing from the sorted active pairs.
pub(crate) fn is_near_missing(active: &[ActivePair], near: &[(ActivePair, f64)]) -> bool {
    is_missing(active, near, INCLUSION_DISTANCE)
}
