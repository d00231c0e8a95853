use std::fmt::Debug;
use std::sync::Arc;

use super::term_sums::{LocalState, unknowns};
use super::terms::{LOCAL, State, Term};
use crate::sparse::{IndexLists, Pattern};

/// Pair of possible contact partners, by indices of its [`ContactSearch`].
pub type ContactPair = [u32; 2];

/// Pairs with the same coordinates that one term evaluates, by indices of its [`ContactSearch`].
pub type ContactGroup = [u32; 2];

/// Search for terms that are active in some states only, such as contacts.
///
/// A term that is active in a state has a distance of at most 0 there. Pairs at a positive distance contribute zero.
/// Neither their selection nor their order may affect the motion.
pub trait ContactSearch: Debug + Send + Sync {
    /// Returns the near pairs in ascending order, with lower bounds of their distances relative to the search margin.
    ///
    /// The bound is at most 0 for all active pairs and at most 1 for all returned pairs.
    fn near(&self, s: &State) -> Vec<(ContactPair, f64)>;

    /// Returns the groups of the near pairs in ascending order, with the smallest bound of their pairs.
    ///
    /// Pairs that have no force for another reason than their distance do not count.
    fn near_groups(&self, s: &State) -> Vec<(ContactGroup, f64)>;

    /// Returns true if the group belongs to this search.
    fn contains(&self, group: ContactGroup) -> bool;

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

    /// Creates the term of all pairs of a group that belongs to this search.
    fn group_term(&self, group: ContactGroup) -> Arc<dyn Term>;
}

/// Pair together with the index of its search.
pub type ActivePair = (usize, ContactPair);

/// Group together with the index of its search.
pub type ActiveGroup = (usize, ContactGroup);

/// Returns the terms of the active pairs of several searches, one by one.
pub fn active_terms(searches: &[Arc<dyn ContactSearch>], s: &State) -> Vec<Arc<dyn Term>> {
    active_pairs(searches, s).map(|(_, term)| term).collect()
}

/// Returns the pairs at a distance of at most 0 in ascending order.
fn active_pairs<'a>(
    searches: &'a [Arc<dyn ContactSearch>],
    s: &'a State,
) -> impl Iterator<Item = (ActivePair, Arc<dyn Term>)> + 'a {
    searches.iter().enumerate().flat_map(|(i, search)| {
        let near = search.near(s).into_iter().filter(|(_, distance)| *distance <= 0.0);
        near.map(move |(pair, _)| ((i, pair), search.term(pair)))
    })
}

/// Returns the pairs whose terms have a force in a state, in ascending order.
pub(crate) fn acting_pairs(searches: &[Arc<dyn ContactSearch>], s: &State) -> Vec<ActivePair> {
    let (mut gathered, mut rows) = (LocalState::EMPTY, [0.0; LOCAL]);
    let mut acts = |term: &dyn Term| {
        let local = gathered.gather(s, term);
        let rows = &mut rows[..local.q.len() + local.lambda.len()];
        rows.fill(0.0);
        term.residual(&local, rows);
        rows.iter().any(|row| *row != 0.0)
    };
    active_pairs(searches, s).filter(|(_, term)| acts(term.as_ref())).map(|(pair, _)| pair).collect()
}

/// Contacts of a system: searches, and the groups of the last terms in ascending order.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveContacts {
    pub(crate) searches: Arc<[Arc<dyn ContactSearch>]>,
    pub(crate) groups: Vec<ActiveGroup>,
    /// Pattern of the system without contacts, if they have been replaced.
    lasting: Option<Arc<Pattern>>,
    /// Groups with entries beyond that pattern, on which the pattern of the system depends, if there are no others.
    coupled: Vec<ActiveGroup>,
}

/// Distance, relative to the search margin, below which groups are included before they become active.
const INCLUSION_DISTANCE: f64 = 0.5;

impl ActiveContacts {
    pub(crate) fn new(searches: Vec<Arc<dyn ContactSearch>>) -> Self {
        Self { searches: searches.into(), ..Self::default() }
    }

    /// Replaces the groups. Returns the contacts and the pattern of the system, which depends on the new groups only.
    ///
    /// The pattern is that without contacts if it has the entries of all new terms. Otherwise it is the pattern of the
    /// lasting terms and those with further entries, if it has the entries of all. It is kept while these groups are the
    /// same. `groups` is empty for terms of pairs. `new` creates the pattern of the lasting and the given terms.
    pub(crate) fn replaced(
        &self,
        groups: Vec<ActiveGroup>,
        (terms, coordinates): (&[Arc<dyn Term>], usize),
        own: &Arc<Pattern>,
        new: impl Fn(&[&Arc<dyn Term>]) -> Pattern,
    ) -> (Self, Arc<Pattern>) {
        let blocks: IndexLists = terms.iter().map(|term| unknowns(&**term, coordinates)).collect();
        let lasting = self.lasting.as_ref().unwrap_or(own);
        let further: Vec<usize> = (0..terms.len()).filter(|&i| !lasting.contains(&blocks[i])).collect();
        let coupled: Vec<ActiveGroup> = further.iter().filter_map(|&i| groups.get(i).copied()).collect();
        let fits = |pattern: &Pattern| blocks.iter().all(|block| pattern.contains(block));
        let shared = |mut pattern: Pattern| {
            pattern.mark_as(lasting);
            Arc::new(pattern)
        };
        let (pattern, coupled) = if further.is_empty() {
            (Arc::clone(lasting), coupled)
        } else if !coupled.is_empty() && coupled == self.coupled && fits(own) {
            (Arc::clone(own), coupled)
        } else {
            let least = new(&further.iter().map(|&i| &terms[i]).collect::<Vec<_>>());
            if fits(&least) {
                (shared(least), coupled)
            } else {
                (shared(new(&terms.iter().collect::<Vec<_>>())), Vec::new())
            }
        };
        let (searches, lasting) = (Arc::clone(&self.searches), Some(Arc::clone(lasting)));
        (Self { searches, groups, lasting, coupled }, pattern)
    }

    /// Returns the groups of a step from a state, if a group that may become active soon is missing.
    pub(crate) fn near(&self, s: &State) -> Option<Vec<ActiveGroup>> {
        let near = self.near_groups(s);
        self.is_missing(&near, INCLUSION_DISTANCE).then(|| near.into_iter().map(|(group, _)| group).collect())
    }

    /// Returns the groups of a step to a state, if a group that is active there is missing.
    ///
    /// The groups of the start of the step are kept, so that repetitions of the step terminate.
    pub(crate) fn completed(&self, s: &State) -> Option<Vec<ActiveGroup>> {
        let near = self.near_groups(s);
        self.is_missing(&near, 0.0).then(|| {
            let mut all: Vec<ActiveGroup> = near.into_iter().map(|(group, _)| group).collect();
            all.extend_from_slice(&self.groups);
            all.sort_unstable();
            all.dedup();
            all
        })
    }

    /// Returns the near groups in ascending order.
    fn near_groups(&self, s: &State) -> Vec<(ActiveGroup, f64)> {
        let of = |(i, search): (usize, &Arc<dyn ContactSearch>)| {
            search.near_groups(s).into_iter().map(move |(group, distance)| ((i, group), distance))
        };
        self.searches.iter().enumerate().flat_map(of).collect()
    }

    /// Returns true if a group within a distance is missing.
    fn is_missing(&self, near: &[(ActiveGroup, f64)], within: f64) -> bool {
        near.iter().any(|(group, distance)| *distance <= within && self.groups.binary_search(group).is_err())
    }

    /// Returns true if all groups belong to the searches and are in ascending order.
    pub(crate) fn accepts(&self, groups: &[ActiveGroup]) -> bool {
        let is_here =
            |(i, group): &ActiveGroup| self.searches.get(*i).is_some_and(|each| each.contains(*group));
        groups.is_sorted_by(|a, b| a < b) && groups.iter().all(is_here)
    }

    /// Returns the terms of groups. `terms` are those of the current groups.
    pub(crate) fn terms_of(&self, groups: &[ActiveGroup], terms: &[Arc<dyn Term>]) -> Vec<Arc<dyn Term>> {
        let term = |group: &ActiveGroup| match self.groups.binary_search(group) {
            Ok(at) => Arc::clone(&terms[at]),
            Err(_) => self.searches[group.0].group_term(group.1),
        };
        groups.iter().map(term).collect()
    }
}
