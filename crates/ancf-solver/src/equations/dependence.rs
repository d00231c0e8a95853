use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::state::{State, Weights};
use super::term::{LOCAL, Local, LocalMatrix, Term};
use crate::factor::Sparse;

/// A row that follows from earlier ones: Σ cᵢ rowᵢ = 0, the last cᵢ being its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Dependence {
    /// The coefficients cᵢ by row.
    pub coefficients: Sparse,
}

impl Dependence {
    /// The row, the last of those that depend on each other.
    pub fn row(&self) -> usize {
        self.coefficients.last_key_value().map_or(0, |(&row, _)| row)
    }

    /// The rows from which it follows.
    pub fn others(&self) -> impl Iterator<Item = usize> {
        let row = self.row();
        self.coefficients.keys().copied().filter(move |&other| other != row)
    }
}

/// A row is redundant if less than this part of it is independent of the others.
pub const INDEPENDENT: f64 = 1e-8;
/// A pivot is at least this part of the largest entry of its row.
const PIVOT: f64 = 0.1;
/// Entries and coefficients below this part of what they are sums of are rounding.
const ROUNDING: f64 = 1e-13;
/// Coefficients below this part of the largest do not count.
const COEFFICIENT: f64 = 1e-9;
/// Sweeps by which rows and columns get entries of size one.
const SWEEPS: usize = 20;

/// The dependences of sparse rows: as many as rows exceed the rank, each naming a row of its own, the latest it can.
///
/// A row depends on others if no more than `tolerance` of it is left by their elimination. Rows and columns are scaled
/// first, so that no units matter. Pivots are taken from the shortest rows and, of these, the shortest columns: chains and
/// trees fill in next to nothing, and the cost is near-linear in the number of entries.
///
/// Source: Markowitz (1957), the order of the pivots; Curtis & Reid (1972), the scaling.
pub fn dependences(rows: Vec<Sparse>, tolerance: f64) -> Vec<Dependence> {
    let mut rows = rows;
    rows.iter_mut().for_each(|row| row.retain(|_, x| *x != 0.0));
    let scales = equilibrate(&mut rows);
    let mut elimination = Elimination::new(rows, tolerance);
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

/// Scales rows and columns so that the logarithms of their entries have the mean zero; returns the factors of the rows.
fn equilibrate(rows: &mut [Sparse]) -> Vec<f64> {
    // Powers of two are exact.
    let of = |logarithms: f64, count: usize| (-logarithms / count.max(1) as f64).round().exp2();
    let mut scales = vec![1.0; rows.len()];
    for _ in 0..SWEEPS {
        for (row, scale) in rows.iter_mut().zip(&mut scales) {
            let own = of(row.values().map(|x| x.abs().log2()).sum(), row.len());
            row.values_mut().for_each(|x| *x *= own);
            *scale *= own;
        }
        let mut columns: HashMap<usize, (f64, usize)> = HashMap::new();
        for (j, x) in rows.iter().flatten() {
            let (sum, count) = columns.entry(*j).or_default();
            (*sum, *count) = (*sum + x.abs().log2(), *count + 1);
        }
        let columns: HashMap<usize, f64> = columns.into_iter().map(|(j, (sum, n))| (j, of(sum, n))).collect();
        rows.iter_mut().flatten().for_each(|(j, x)| *x *= columns[j]);
    }
    scales
}

/// Gaussian elimination under way.
struct Elimination {
    /// What is left of each row.
    rows: Vec<Sparse>,
    /// The rows that are left and have an entry, by column.
    columns: HashMap<usize, BTreeSet<usize>>,
    /// The rows that are left, by their number of entries.
    left: BTreeSet<(usize, usize)>,
    /// The largest number that each row was made of.
    sizes: Vec<f64>,
    /// For each row the pivots that were subtracted: (step, row, factor), in order.
    subtracted: Vec<Vec<(usize, usize, f64)>>,
    step: usize,
    vanished: Vec<usize>,
    tolerance: f64,
}

impl Elimination {
    fn new(rows: Vec<Sparse>, tolerance: f64) -> Self {
        let mut columns: HashMap<usize, BTreeSet<usize>> = HashMap::new();
        for (i, row) in rows.iter().enumerate() {
            row.keys().for_each(|&j| _ = columns.entry(j).or_default().insert(i));
        }
        let left = rows.iter().enumerate().map(|(i, row)| (row.len(), i)).collect();
        let (sizes, subtracted) = (rows.iter().map(largest).collect(), vec![Vec::new(); rows.len()]);
        Self { rows, columns, left, sizes, subtracted, step: 0, vanished: Vec::new(), tolerance }
    }

    /// Takes the shortest row that is left and has not vanished.
    fn shortest(&mut self) -> Option<usize> {
        while let Some((_, i)) = self.left.pop_first() {
            for j in self.rows[i].keys() {
                self.columns.get_mut(j).expect("every entry is in its column").remove(&i);
            }
            if largest(&self.rows[i]) > self.tolerance * self.sizes[i] {
                return Some(i);
            }
            self.vanished.push(i);
        }
        None
    }

    /// Eliminates one unknown of a row from all rows that are left.
    fn pivot_in(&mut self, row: usize) {
        let pivot = std::mem::take(&mut self.rows[row]);
        let least = PIVOT * largest(&pivot);
        let candidates = pivot.iter().filter(|(_, x)| x.abs() >= least);
        let Some((&at, &entry)) = candidates.min_by_key(|(j, _)| self.columns[*j].len()) else { return };
        for i in std::mem::take(self.columns.get_mut(&at).expect("the pivot's column")) {
            let factor = self.rows[i][&at] / entry;
            self.subtract(i, factor, &pivot, at);
            self.subtracted[i].push((self.step, row, factor));
        }
        self.step += 1;
    }

    fn subtract(&mut self, i: usize, factor: f64, pivot: &Sparse, at: usize) {
        let target = &mut self.rows[i];
        self.left.remove(&(target.len(), i));
        target.remove(&at);
        let size = self.sizes[i].max(factor.abs() * largest(pivot));
        for (&j, x) in pivot.iter().filter(|(j, _)| **j != at) {
            let value = target.entry(j).or_default();
            *value -= factor * x;
            if value.abs() > ROUNDING * size {
                self.columns.get_mut(&j).expect("a column of the rows").insert(i);
            } else {
                target.remove(&j);
                self.columns.get_mut(&j).expect("a column of the rows").remove(&i);
            }
        }
        self.sizes[i] = size;
        self.left.insert((target.len(), i));
    }

    /// The combination of the given rows that a row has become.
    fn combination(&self, row: usize) -> Sparse {
        // Pivots, the latest first: what a row is made of was done before it became a pivot.
        let mut open: BTreeMap<(usize, usize), f64> = BTreeMap::from([((usize::MAX, row), 1.0)]);
        let mut sum = Sparse::new();
        while let Some(((_, row), c)) = open.pop_last() {
            sum.insert(row, c);
            for &(step, pivot, factor) in &self.subtracted[row] {
                *open.entry((step, pivot)).or_default() -= c * factor;
            }
        }
        sum
    }
}

/// The same dependences, each with another last row.
fn latest(dependences: Vec<Sparse>) -> Vec<Dependence> {
    let mut found: BTreeMap<usize, Sparse> = BTreeMap::new();
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

fn largest(row: &Sparse) -> f64 {
    row.values().fold(0.0, |max: f64, x| max.max(x.abs()))
}

/// The rows of Φ_q of a term in a state, one for each of its multipliers.
pub fn constraint_rows(term: &dyn Term, s: &State) -> Vec<Sparse> {
    let (coordinates, n, m) = (term.coordinates(), term.coordinates().len(), term.multipliers().len());
    let zero = [0.0; LOCAL];
    let mut q = [0.0; LOCAL];
    coordinates.iter().enumerate().for_each(|(i, &c)| q[i] = s.q[c]);
    let at = Local { q: &q[..n], v: &zero[..n], a: &zero[..n], lambda: &zero[..m], t: s.t, load: s.load };
    let mut storage = [0.0; LOCAL * LOCAL];
    let mut block = LocalMatrix::zero(n + m, &mut storage);
    term.tangent(&at, Weights { q: 0.0, v: 0.0, a: 0.0 }, &mut block);
    let row = |k: usize| {
        let entries = coordinates.iter().enumerate().map(|(i, &c)| (c, block.get(n + k, i)));
        entries.filter(|(_, x)| *x != 0.0).collect()
    };
    (0..m).map(row).collect()
}

/// The rows of Φ_q of some terms in a state, by multiplier.
pub fn all_constraint_rows<'a>(
    terms: impl IntoIterator<Item = &'a dyn Term>,
    multipliers: usize,
    s: &State,
) -> Vec<Sparse> {
    let mut rows = vec![Sparse::new(); multipliers];
    for term in terms {
        for (multiplier, row) in term.multipliers().zip(constraint_rows(term, s)) {
            // The terms of a slide share multipliers; one of them is active.
            if rows[multiplier].is_empty() {
                rows[multiplier] = row;
            }
        }
    }
    rows
}
