use std::collections::BTreeMap;

use ancf_solver::equations::{Batch, LANES, Term};

/// Batch with the places of its terms in a list.
pub type TermBatch = (Vec<usize>, Box<dyn Batch>);

/// Kind of terms that can be evaluated in batches.
pub(crate) trait BatchTerm: Term + Sized {
    /// Creates batches of the terms of a system, each with the places of its terms in the list.
    fn batches(terms: &[&Self]) -> Vec<TermBatch>;
}

/// Returns the elements of each body in groups of up to [`LANES`], each with the place of its first element.
///
/// Consecutive elements of a body share coordinates.
pub(super) fn elements_of_bodies<'a, 'e, E: Term>(
    elements: &'a [&'e E],
) -> impl Iterator<Item = (usize, &'a [&'e E])> {
    let bodies = elements.chunk_by(|one, next| one.coordinates().last() >= next.coordinates().first());
    let mut first = 0;
    bodies.flat_map(|body| body.chunks(LANES)).map(move |group| {
        first += group.len();
        (first - group.len(), group)
    })
}

/// Returns the batch of consecutive terms.
pub(super) fn consecutive(first: usize, batch: impl Batch + 'static) -> TermBatch {
    ((first..first + batch.count()).collect(), Box::new(batch))
}

/// Creates batches of up to [`LANES`] terms with equal structure, in the order of the terms. Terms without a structure are in none.
pub(crate) fn alike<T, K: Ord>(
    terms: &[&T],
    structure: impl Fn(&T) -> Option<K>,
    batch: impl Fn(&[&T]) -> Box<dyn Batch>,
) -> Vec<TermBatch> {
    let mut alike: BTreeMap<K, Vec<usize>> = BTreeMap::new();
    for (place, term) in terms.iter().enumerate() {
        if let Some(structure) = structure(term) {
            alike.entry(structure).or_default().push(place);
        }
    }
    let groups = alike.values().flat_map(|places| places.chunks(LANES));
    let batch = |places: &[usize]| {
        (places.to_vec(), batch(&places.iter().map(|&place| terms[place]).collect::<Vec<_>>()))
    };
    groups.map(batch).collect()
}
