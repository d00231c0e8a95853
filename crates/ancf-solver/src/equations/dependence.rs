use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::terms::{LOCAL, Local, LocalMatrix, State, Term, Weights};
use crate::factor::SparseVector;
use crate::sparse::ConstraintRow;

/// Linear dependence of a row on earlier rows: Σ cᵢ rowᵢ = 0, where the last cᵢ belongs to the dependent row.
#[derive(Clone, Debug, PartialEq)]
pub struct Dependence {
    /// Coefficients cᵢ by row.
    pub coefficients: SparseVector,
}

impl Dependence {
    /// Returns the dependent row, which is the last row of the combination.
    pub fn row(&self) -> usize {
        self.coefficients.last_key_value().map_or(0, |(&row, _)| row)
    }

    /// Returns the rows on which the dependent row depends.
    pub fn others(&self) -> impl Iterator<Item = usize> {
        let row = self.row();
        self.coefficients.keys().copied().filter(move |&other| other != row)
    }
}

/// Redundancy tolerance: a row is redundant if its independent part is smaller, relative to the row.
pub const REDUNDANCY_TOLERANCE: f64 = 1e-8;
/// Pivot threshold, relative to the largest entry of the row.
const PIVOT: f64 = 0.1;
/// Rounding threshold of entries and coefficients, relative to the summands.
const ROUNDING: f64 = 1e-13;
/// Threshold for coefficients, relative to the largest one. Smaller coefficients are dropped.
const COEFFICIENT: f64 = 1e-9;
/// Rounding threshold of the entries of a row, relative to the largest one.
const NEGLIGIBLE: f64 = 16.0 * f64::EPSILON;
/// Number of equilibration sweeps.
const SWEEPS: usize = 20;

/// Finds the linear dependences of sparse rows.
///
/// Returns one dependence for each row in excess of the rank. The dependent rows are distinct and as late as possible.
/// A row is dependent if elimination reduces it to at most `tolerance` times its size. Rows and columns are
/// equilibrated first, so the result does not depend on units. Pivots are taken from the shortest rows and, among
/// these, from the shortest columns. Chains and trees then produce almost no fill-in. The cost is nearly linear in the
/// number of entries.
///
/// Source: Markowitz (1957) for the pivot order; Curtis & Reid (1972) for the scaling.
pub fn dependences(rows: Vec<SparseVector>, tolerance: f64) -> Vec<Dependence> {
    let mut rows = rows;
    for row in &mut rows {
        // Entries that are zero but for rounding errors would determine the scales.
        let least = NEGLIGIBLE * largest(row);
        row.retain(|_, x| x.abs() > least);
    }
    let scales = equilibrate(&mut rows);
    let mut elimination = RowElimination::new(rows, tolerance);
    while let Some(row) = elimination.shortest() {
        elimination.pivot_in(row);
    }
    let vanished = elimination.vanished.iter().map(|&row| elimination.combination(row));
    let mut found = latest(vanished.collect());
    for (&row, c) in found.iter_mut().flat_map(|found| &mut found.coefficients) {
        *c *= scales[row];
    }
    found
}

/// Scales rows and columns until the mean logarithm of their entries is zero. Returns the row scales.
fn equilibrate(rows: &mut [SparseVector]) -> Vec<f64> {
    // Powers of two scale without rounding.
    let correction = |sum: f64, count: usize| -(sum / count.max(1) as f64).round();
    let logarithms: Vec<Vec<(usize, f64)>> =
        rows.iter().map(|row| row.iter().map(|(&j, x)| (j, x.abs().log2())).collect()).collect();
    let columns = column_count(rows);
    let (mut of_rows, mut of_columns) = (vec![0.0; rows.len()], vec![0.0; columns]);
    let mut sums = vec![(0.0, 0); columns];
    for _ in 0..SWEEPS {
        let mut changed = false;
        sums.fill((0.0, 0));
        for (row, own) in logarithms.iter().zip(&mut of_rows) {
            let of_row: f64 = row.iter().map(|&(j, x)| x + *own + of_columns[j]).sum();
            let step = correction(of_row, row.len());
            *own += step;
            changed |= step != 0.0;
            for &(j, x) in row {
                sums[j].0 += x + *own + of_columns[j];
                sums[j].1 += 1;
            }
        }
        for (own, &(sum, count)) in of_columns.iter_mut().zip(&sums) {
            let step = correction(sum, count);
            *own += step;
            changed |= step != 0.0;
        }
        if !changed {
            break;
        }
    }
    for (row, own) in rows.iter_mut().zip(&of_rows) {
        row.iter_mut().for_each(|(&j, x)| *x *= (own + of_columns[j]).exp2());
    }
    of_rows.into_iter().map(f64::exp2).collect()
}

/// Number of columns up to the last one with an entry.
fn column_count(rows: &[SparseVector]) -> usize {
    rows.iter().filter_map(|row| row.last_key_value()).map(|(&j, _)| j + 1).max().unwrap_or(0)
}

/// State of a Gaussian elimination.
struct RowElimination {
    /// Remainder of each row.
    rows: Vec<SparseVector>,
    /// Active rows with an entry, by column.
    columns: Vec<BTreeSet<usize>>,
    /// Active rows, sorted by their number of entries.
    left: BTreeSet<(usize, usize)>,
    /// Largest number from which each row was computed.
    sizes: Vec<f64>,
    /// Subtracted pivots of each row as (step, row, factor), in order.
    subtracted: Vec<Vec<(usize, usize, f64)>>,
    step: usize,
    vanished: Vec<usize>,
    tolerance: f64,
}

impl RowElimination {
    fn new(rows: Vec<SparseVector>, tolerance: f64) -> Self {
        let mut columns = vec![BTreeSet::new(); column_count(&rows)];
        for (i, row) in rows.iter().enumerate() {
            row.keys().for_each(|&j| _ = columns[j].insert(i));
        }
        let left = rows.iter().enumerate().map(|(i, row)| (row.len(), i)).collect();
        let (sizes, subtracted) = (rows.iter().map(largest).collect(), vec![Vec::new(); rows.len()]);
        Self { rows, columns, left, sizes, subtracted, step: 0, vanished: Vec::new(), tolerance }
    }

    /// Takes the shortest active row that has not vanished.
    fn shortest(&mut self) -> Option<usize> {
        while let Some((_, i)) = self.left.pop_first() {
            for &j in self.rows[i].keys() {
                self.columns[j].remove(&i);
            }
            if largest(&self.rows[i]) > self.tolerance * self.sizes[i] {
                return Some(i);
            }
            self.vanished.push(i);
        }
        None
    }

    /// Eliminates one unknown of a row from all active rows.
    fn pivot_in(&mut self, row: usize) {
        let pivot = std::mem::take(&mut self.rows[row]);
        let least = PIVOT * largest(&pivot);
        let candidates = pivot.iter().filter(|(_, x)| x.abs() >= least);
        let Some((&at, &entry)) = candidates.min_by_key(|(j, _)| self.columns[**j].len()) else { return };
        for i in std::mem::take(&mut self.columns[at]) {
            let factor = self.rows[i][&at] / entry;
            self.subtract(i, factor, &pivot, at);
            self.subtracted[i].push((self.step, row, factor));
        }
        self.step += 1;
    }

    fn subtract(&mut self, i: usize, factor: f64, pivot: &SparseVector, at: usize) {
        let target = &mut self.rows[i];
        self.left.remove(&(target.len(), i));
        target.remove(&at);
        let size = self.sizes[i].max(factor.abs() * largest(pivot));
        for (&j, x) in pivot.iter().filter(|(j, _)| **j != at) {
            let value = target.entry(j).or_default();
            *value -= factor * x;
            if value.abs() > ROUNDING * size {
                self.columns[j].insert(i);
            } else {
                target.remove(&j);
                self.columns[j].remove(&i);
            }
        }
        self.sizes[i] = size;
        self.left.insert((target.len(), i));
    }

    /// Returns the linear combination of the given rows that produced a remaining row.
    fn combination(&self, row: usize) -> SparseVector {
        // Pivots in descending order of steps: a pivot row is complete before the step in which it is used.
        let mut open: BTreeMap<(usize, usize), f64> = BTreeMap::from([((usize::MAX, row), 1.0)]);
        let mut sum = SparseVector::new();
        while let Some(((_, row), c)) = open.pop_last() {
            sum.insert(row, c);
            for &(step, pivot, factor) in &self.subtracted[row] {
                *open.entry((step, pivot)).or_default() -= c * factor;
            }
        }
        sum
    }
}

/// Reduces the dependences until their last rows are distinct.
fn latest(dependences: Vec<SparseVector>) -> Vec<Dependence> {
    let mut found: BTreeMap<usize, SparseVector> = BTreeMap::new();
    for mut sum in dependences {
        loop {
            let size = largest(&sum);
            sum.retain(|_, c| c.abs() > COEFFICIENT * size);
            let Some((&last, &c)) = sum.last_key_value() else { break };
            let Some(other) = found.get(&last) else {
                found.insert(last, sum);
                break;
            };
            let part = c / other[&last];
            for (&row, x) in other {
                *sum.entry(row).or_default() -= part * x;
            }
            sum.remove(&last);
        }
    }
    found.into_values().map(|coefficients| Dependence { coefficients }).collect()
}

fn largest(row: &SparseVector) -> f64 {
    row.values().fold(0.0, |max: f64, x| max.max(x.abs()))
}

/// Returns the rows of Φ_q of a term in a state, one for each multiplier.
pub fn constraint_rows(term: &dyn Term, s: &State) -> Vec<SparseVector> {
    let (coordinates, n, m) = (term.coordinates(), term.coordinates().len(), term.multipliers().len());
    let mut storage = vec![0.0; (n + m) * (n + m + 1) / 2];
    let block = local_tangent(term, s, Weights { q: 0.0, v: 0.0, a: 0.0 }, &mut storage);
    let row = |k: usize| {
        let entries = coordinates.iter().enumerate().map(|(i, &c)| (c, block.get(n + k, i)));
        entries.filter(|(_, x)| *x != 0.0).collect()
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
) -> Vec<SparseVector> {
    let mut rows = vec![SparseVector::new(); multipliers];
    for term in terms {
        for (multiplier, row) in term.multipliers().zip(constraint_rows(term, s)) {
            // Terms can share multipliers: those of a sliding joint, of which one is active, and the elements around a gas.
            let sum: &mut SparseVector = &mut rows[multiplier];
            row.into_iter().for_each(|(c, entry)| *sum.entry(c).or_default() += entry);
        }
    }
    rows
}
