use std::collections::{BTreeMap, BTreeSet};

/// Sparse row or column: entries by index.
pub type SparseVector = BTreeMap<usize, f64>;

/// Null space of a set of rows, by Gauss-Jordan elimination row by row.
///
/// Some unknowns become *pivots*, which depend on the *free* unknowns. The null space has one basis vector for each
/// free unknown, with 1 at this unknown and 0 at the other free ones.
#[derive(Clone, Debug, Default)]
pub struct NullSpace {
    /// Coefficients c of each pivot p: x_p + Σⱼ cⱼ xⱼ = 0, j free.
    pivots: BTreeMap<usize, SparseVector>,
    /// Pivots whose rows contain an unknown, by the unknown.
    users: BTreeMap<usize, BTreeSet<usize>>,
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
    pub fn add_row(&mut self, mut row: SparseVector, tolerance: f64, prefer: impl Fn(usize) -> bool) {
        let known: Vec<usize> = row.keys().copied().filter(|j| self.pivots.contains_key(j)).collect();
        for p in known {
            eliminate(&mut row, p, &self.pivots[&p]);
        }
        let largest = row.values().fold(0.0, |max: f64, x| max.max(x.abs()));
        if largest <= tolerance {
            return;
        }
        row.retain(|_, x| x.abs() > ROUNDING * largest);
        let rank =
            |j: usize, x: f64| (prefer(j) && x.abs() > 0.1 * largest, (x.abs() / largest * 1e6).round());
        let best = row.iter().max_by(|a, b| {
            let (a, b) = (rank(*a.0, *a.1), rank(*b.0, *b.1));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        let Some((&pivot, &entry)) = best else { return };
        row.remove(&pivot);
        row.values_mut().for_each(|x| *x /= entry);
        for user in self.users.remove(&pivot).unwrap_or_default() {
            let Some(other) = self.pivots.get_mut(&user) else { continue };
            self.entries -= other.len();
            eliminate(other, pivot, &row);
            other.retain(|_, x| x.abs() > ROUNDING);
            self.entries += other.len();
            for j in row.keys() {
                let users = self.users.entry(*j).or_default();
                if other.contains_key(j) {
                    users.insert(user)
                } else {
                    users.remove(&user)
                };
            }
        }
        for j in row.keys() {
            self.users.entry(*j).or_default().insert(pivot);
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
        let mut vectors: BTreeMap<usize, SparseVector> =
            free.map(|j| (j, SparseVector::from([(j, 1.0)]))).collect();
        for (&pivot, row) in &self.pivots {
            for (j, c) in row {
                if let Some(vector) = vectors.get_mut(j) {
                    vector.insert(pivot, -c);
                }
            }
        }
        vectors
    }
}

/// Replaces x_p in a row by −Σ c x.
fn eliminate(row: &mut SparseVector, p: usize, pivot_row: &SparseVector) {
    if let Some(entry) = row.remove(&p) {
        for (&j, c) in pivot_row {
            *row.entry(j).or_default() -= entry * c;
        }
    }
}
