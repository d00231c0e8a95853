use std::sync::Arc;

use super::terms::{LOCAL, Local, LocalMatrix, State, Term, Weights};
use crate::factor::{SparseRow, dependences, sparse_row};
use crate::sparse::ConstraintRow;

/// Redundancy tolerance: a row is redundant if its independent part is smaller, relative to the row.
pub const REDUNDANCY_TOLERANCE: f64 = 1e-8;

/// Returns the rows of Φ_q of a term in a state, one for each multiplier.
pub fn constraint_rows(term: &dyn Term, s: &State) -> Vec<SparseRow> {
    let (coordinates, n, m) = (term.coordinates(), term.coordinates().len(), term.multipliers().len());
    let mut storage = vec![0.0; (n + m) * (n + m + 1) / 2];
    let block = local_tangent(term, s, Weights { q: 0.0, v: 0.0, a: 0.0 }, &mut storage);
    let row = |k: usize| {
        let entries = coordinates.iter().enumerate().map(|(i, &c)| (c, block.get(n + k, i)));
        let mut row: SparseRow = entries.filter(|(_, x)| *x != 0.0).collect();
        row.sort_unstable_by_key(|(c, _)| *c);
        row
    };
    (0..m).map(row).collect()
}

/// Computes the tangent of a term in a state without motion and multipliers.
fn local_tangent<'a>(term: &dyn Term, s: &State, w: Weights, storage: &'a mut [f64]) -> LocalMatrix<'a> {
    let (coordinates, n, m) = (term.coordinates(), term.coordinates().len(), term.multipliers().len());
    let zero = [0.0; LOCAL];
    let mut q = [0.0; LOCAL];
    coordinates.iter().enumerate().for_each(|(i, &c)| q[i] = s.q[c]);
    let at = Local { q: &q[..n], v: &zero[..n], a: &zero[..n], lambda: &zero[..m], t: s.t, load: s.load };
    let mut block = LocalMatrix::zero(n + m, storage);
    term.tangent(&at, w, &mut block);
    block
}

/// Returns the rows of Φ_q in the reference configuration, with columns scaled by M_cc^(−1/2), indexed by multiplier.
///
/// Rows without entries, with coordinates without mass or of several terms, such as those of a slider, are empty.
pub(super) fn scaled_constraint_rows(
    terms: &[Arc<dyn Term>],
    coordinates: usize,
    multipliers: usize,
) -> Vec<ConstraintRow> {
    let (mut rows, mut occurrences) = (vec![ConstraintRow::new(); multipliers], vec![0; multipliers]);
    let s = State::rest(coordinates, multipliers);
    let (mut mass, mut is_constrained) = (vec![0.0; coordinates], vec![false; coordinates]);
    let constraints = terms.iter().filter(|term| !term.multipliers().is_empty());
    constraints.flat_map(|term| term.coordinates()).for_each(|&c| is_constrained[c] = true);
    let mut storage = [0.0; LOCAL * (LOCAL + 1) / 2];
    for term in terms.iter().filter(|term| term.coordinates().iter().any(|&c| is_constrained[c])) {
        let block = local_tangent(&**term, &s, Weights::MASS, &mut storage);
        term.coordinates().iter().enumerate().for_each(|(i, &c)| mass[c] += block.get(i, i));
        let n = term.coordinates().len();
        for (k, multiplier) in term.multipliers().enumerate() {
            occurrences[multiplier] += 1;
            let entries =
                term.coordinates().iter().enumerate().map(|(i, &c)| (c as u32, block.get(n + k, i)));
            rows[multiplier] = entries.collect();
        }
    }
    for (row, occurrences) in rows.iter_mut().zip(occurrences) {
        for (c, entry) in &mut *row {
            *entry /= mass[*c as usize].max(0.0).sqrt();
        }
        let is_determined = occurrences == 1 && row.iter().all(|(_, entry)| entry.is_finite());
        if !is_determined || row.iter().all(|(_, entry)| *entry == 0.0) {
            row.clear();
        }
    }
    rows
}

/// Returns the number of linearly dependent rows of Φ_q in a state.
pub(super) fn redundant_rows<'a>(
    terms: impl IntoIterator<Item = &'a dyn Term>,
    multipliers: usize,
    s: &State,
) -> usize {
    dependences(all_constraint_rows(terms, multipliers, s), REDUNDANCY_TOLERANCE).len()
}

/// Returns the rows of Φ_q of several terms in a state, indexed by multiplier.
pub fn all_constraint_rows<'a>(
    terms: impl IntoIterator<Item = &'a dyn Term>,
    multipliers: usize,
    s: &State,
) -> Vec<SparseRow> {
    let mut rows = vec![SparseRow::new(); multipliers];
    for term in terms {
        for (multiplier, row) in term.multipliers().zip(constraint_rows(term, s)) {
            // Terms can share multipliers: those of a sliding joint, of which one is active, and the elements around a gas.
            let sum = &mut rows[multiplier];
            if sum.is_empty() {
                *sum = row;
            } else {
                sum.extend(row);
                *sum = sparse_row(std::mem::take(sum));
            }
        }
    }
    rows
}
