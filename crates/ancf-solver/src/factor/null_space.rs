use std::collections::BTreeMap;

use super::sparse_row::{SparseRow, SparseVector, largest, position, subtract};

/// Null space of a set of rows, by Gauss-Jordan elimination row by row.
///
/// Some unknowns become *pivots*, which depend on the *free* unknowns. The null space has one basis vector for each
/// free unknown, with 1 at this unknown and 0 at the other free ones.
#[derive(Clone, Debug, Default)]
pub struct NullSpace {
    /// Coefficients c of each pivot p: x_p + Σⱼ cⱼ xⱼ = 0, j free.
    pivots: BTreeMap<usize, SparseRow>,
    /// Pivots whose rows contain an unknown, or contained it, by the unknown.
    users: BTreeMap<usize, Vec<usize>>,
    /// Number of coefficients of all pivots.
    entries: usize,
}

/// Rounding threshold of entries, relative to the largest entry of the row.
const ROUNDING: f64 = 1e-12;

impl NullSpace {
    /// Adds a row. A dependent row, in which elimination leaves no entry above `tolerance`, is ignored.
    ///
    /// Unknowns accepted by `prefer` become pivots unless their entries are small, so that the other unknowns remain
    /// free.
    pub fn add_row(&mut self, row: SparseRow, tolerance: f64, prefer: impl Fn(usize) -> bool) {
        let known: Vec<usize> = row.iter().map(|(j, _)| *j).filter(|j| self.pivots.contains_key(j)).collect();
        let mut row = row;
        for p in known {
            row = eliminated(&row, p, &self.pivots[&p], |_| {});
        }
        let largest = largest(&row);
        if largest <= tolerance {
            return;
        }
        row.retain(|(_, x)| x.abs() > ROUNDING * largest);
        let rank =
            |j: usize, x: f64| (prefer(j) && x.abs() > 0.1 * largest, (x.abs() / largest * 1e6).round());
        let best = row.iter().enumerate().max_by(|(_, a), (_, b)| {
            let (a, b) = (rank(a.0, a.1), rank(b.0, b.1));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        let Some(place) = best.map(|(place, _)| place) else { return };
        let (pivot, entry) = row.remove(place);
        row.iter_mut().for_each(|(_, x)| *x /= entry);
        for user in self.users.remove(&pivot).unwrap_or_default() {
            let Some(other) = self.pivots.get_mut(&user).filter(|other| position(other, pivot).is_some())
            else {
                continue;
            };
            self.entries -= other.len();
            let users = &mut self.users;
            *other = eliminated(other, pivot, &row, |j| users.entry(j).or_default().push(user));
            other.retain(|(_, x)| x.abs() > ROUNDING);
            self.entries += other.len();
        }
        for &(j, _) in &row {
            self.users.entry(j).or_default().push(pivot);
        }
        self.entries += row.len();
        self.pivots.insert(pivot, row);
    }

    /// Returns the number of coefficients of the dependent unknowns, a measure of the memory of the basis.
    pub fn entries(&self) -> usize {
        self.entries
    }

    /// Returns the basis vectors by their free unknowns, for the given total number of unknowns.
    pub fn basis(&self, unknowns: usize) -> BTreeMap<usize, SparseVector> {
        let free = (0..unknowns).filter(|j| !self.pivots.contains_key(j));
        let mut vectors: BTreeMap<usize, SparseRow> = free.map(|j| (j, vec![(j, 1.0)])).collect();
        for (&pivot, row) in &self.pivots {
            for (j, c) in row {
                if let Some(vector) = vectors.get_mut(j) {
                    vector.push((pivot, -c));
                }
            }
        }
        vectors.into_iter().map(|(j, vector)| (j, vector.into_iter().collect())).collect()
    }
}

/// Returns a row with x_p replaced by −Σ c x. `added` is called with the unknowns that the row did not contain.
fn eliminated(row: &SparseRow, p: usize, pivot_row: &SparseRow, mut added: impl FnMut(usize)) -> SparseRow {
    let Some(place) = position(row, p) else { return row.clone() };
    let entry = row[place].1;
    let mut sum = Vec::with_capacity(row.len() + pivot_row.len());
    let others = row.iter().copied().filter(|(j, _)| *j != p);
    subtract(others, entry, pivot_row, &mut sum, |j, is_contained, _| {
        if !is_contained {
            added(j);
        }
        true
    });
    sum
}
