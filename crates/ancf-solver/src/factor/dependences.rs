use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::sparse_row::{SparseRow, SparseVector, largest, position, subtract};

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
pub fn dependences(rows: Vec<SparseRow>, tolerance: f64) -> Vec<Dependence> {
    let mut rows = rows;
    for row in &mut rows {
        // Entries that are zero but for rounding errors would determine the scales.
        let least = NEGLIGIBLE * largest(row);
        row.retain(|(_, x)| x.abs() > least);
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
fn equilibrate(rows: &mut [SparseRow]) -> Vec<f64> {
    // Powers of two scale without rounding.
    let correction = |sum: f64, count: usize| -(sum / count.max(1) as f64).round();
    let logarithms: Vec<f64> = rows.iter().flatten().map(|(_, x)| x.abs().log2()).collect();
    let columns = column_count(rows);
    let (mut of_rows, mut of_columns) = (vec![0.0; rows.len()], vec![0.0; columns]);
    let mut sums = vec![(0.0, 0); columns];
    for _ in 0..SWEEPS {
        let mut changed = false;
        sums.fill((0.0, 0));
        let mut left = logarithms.as_slice();
        for (row, own) in rows.iter().zip(&mut of_rows) {
            let (of_entries, others) = left.split_at(row.len());
            left = others;
            let entries = || row.iter().zip(of_entries).map(|(&(j, _), x)| (j, x));
            let of_row: f64 = entries().map(|(j, x)| x + *own + of_columns[j]).sum();
            let step = correction(of_row, row.len());
            *own += step;
            changed |= step != 0.0;
            for (j, x) in entries() {
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
        row.iter_mut().for_each(|(j, x)| *x *= (own + of_columns[*j]).exp2());
    }
    of_rows.into_iter().map(f64::exp2).collect()
}

/// Number of columns up to the last one with an entry.
fn column_count(rows: &[SparseRow]) -> usize {
    rows.iter().filter_map(|row| row.last()).map(|(j, _)| j + 1).max().unwrap_or(0)
}

/// State of a Gaussian elimination.
struct RowElimination {
    /// Remainder of each row.
    rows: Vec<SparseRow>,
    /// Rows that have or had an entry, by column.
    columns: Vec<Vec<usize>>,
    /// Number of active rows with an entry, by column.
    counts: Vec<usize>,
    is_active: Vec<bool>,
    /// Numbers of entries that rows have or had, with the rows, from the smallest.
    queue: BinaryHeap<Reverse<(usize, usize)>>,
    /// Largest number from which each row was computed.
    sizes: Vec<f64>,
    /// Subtracted pivots of each row as (step, row, factor), in order.
    subtracted: Vec<Vec<(usize, usize, f64)>>,
    step: usize,
    vanished: Vec<usize>,
    tolerance: f64,
    /// Storage of a difference of rows.
    difference: SparseRow,
}

impl RowElimination {
    fn new(rows: Vec<SparseRow>, tolerance: f64) -> Self {
        let mut columns = vec![Vec::new(); column_count(&rows)];
        for (i, row) in rows.iter().enumerate() {
            row.iter().for_each(|&(j, _)| columns[j].push(i));
        }
        Self {
            counts: columns.iter().map(Vec::len).collect(),
            columns,
            is_active: vec![true; rows.len()],
            queue: rows.iter().enumerate().map(|(i, row)| Reverse((row.len(), i))).collect(),
            sizes: rows.iter().map(|row| largest(row)).collect(),
            subtracted: vec![Vec::new(); rows.len()],
            step: 0,
            vanished: Vec::new(),
            tolerance,
            difference: Vec::new(),
            rows,
        }
    }

    /// Takes the shortest active row that has not vanished.
    fn shortest(&mut self) -> Option<usize> {
        while let Some(Reverse((length, i))) = self.queue.pop() {
            let row = &self.rows[i];
            if !self.is_active[i] || length != row.len() {
                continue; // This length is that of an earlier step.
            }
            self.is_active[i] = false;
            row.iter().for_each(|&(j, _)| self.counts[j] -= 1);
            if largest(row) > self.tolerance * self.sizes[i] {
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
        let Some(&(at, entry)) = candidates.min_by_key(|(j, _)| self.counts[*j]) else { return };
        let users = std::mem::take(&mut self.columns[at]);
        for i in users.into_iter().filter(|&i| i != row) {
            let Some(place) = position(&self.rows[i], at).filter(|_| self.is_active[i]) else { continue };
            let factor = self.rows[i][place].1 / entry;
            self.subtract(i, factor, &pivot, at);
            self.subtracted[i].push((self.step, row, factor));
        }
        self.step += 1;
    }

    /// Subtracts a multiple of a pivot row from a row, whose entry in the column of the pivot vanishes.
    fn subtract(&mut self, i: usize, factor: f64, pivot: &SparseRow, at: usize) {
        let size = self.sizes[i].max(factor.abs() * largest(pivot));
        let target = self.rows[i].iter().copied();
        let (counts, columns) = (&mut self.counts, &mut self.columns);
        subtract(target, factor, pivot, &mut self.difference, |j, is_contained, value| {
            let remains = j != at && value.abs() > ROUNDING * size;
            match (is_contained, remains) {
                (true, false) => counts[j] -= 1,
                (false, true) => {
                    counts[j] += 1;
                    columns[j].push(i);
                }
                _ => {}
            }
            remains
        });
        if self.difference.len() != self.rows[i].len() {
            self.queue.push(Reverse((self.difference.len(), i)));
        }
        std::mem::swap(&mut self.rows[i], &mut self.difference);
        self.sizes[i] = size;
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
            let size = sum.values().fold(0.0, |max: f64, c| max.max(c.abs()));
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
