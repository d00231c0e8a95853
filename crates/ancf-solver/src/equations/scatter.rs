use std::ops::Range;
use std::sync::Arc;

use super::term_sums::unknowns;
use super::terms::{LOCAL, Term};
use super::thread_parts::enclosing_range;
use crate::sparse::{ConstraintRow, IndexLists, Pattern, QUAD, SupernodeShape};

/// Map from the lower triangle of a local matrix to the values of a sparse matrix.
///
/// Unknowns that are consecutive both in the local matrix and in a supernode form a run. Each pair of runs forms a
/// block that is dense in both matrices. An element with two nodes has three blocks.
#[derive(Clone, Debug)]
pub struct Scatter {
    size: u32,
    /// Copies share the blocks.
    blocks: Arc<[DenseBlock]>,
}

/// Block of a local matrix that is dense in a supernode.
#[derive(Clone, Copy, Debug)]
struct DenseBlock {
    /// Index of the first value of the supernode, and the height of the supernode in quads.
    start: usize,
    height: u32,
    /// First row and first column in the supernode.
    row: u32,
    column: u32,
    /// First row and first column in the local matrix, as rows and columns of the supernode.
    from_row: u8,
    from_column: u8,
    rows: u8,
    columns: u8,
}

/// Unknowns that are consecutive in a local matrix and in a supernode.
#[derive(Clone, Copy)]
struct UnknownRun {
    from: usize,
    length: usize,
    position: usize,
}

impl Scatter {
    /// Creates the map of the given unknowns. Multipliers are numbered after the coordinates.
    ///
    /// # Panics
    /// If the pattern does not contain the block of these unknowns.
    pub(crate) fn new(pattern: &Pattern, unknowns: &[u32]) -> Self {
        let unknown_runs = unknown_runs(pattern, unknowns);
        let mut blocks = Vec::with_capacity(unknown_runs.len() * (unknown_runs.len() + 1) / 2);
        for (i, &one) in unknown_runs.iter().enumerate() {
            for &other in &unknown_runs[i..] {
                let (columns, rows) =
                    if one.position <= other.position { (one, other) } else { (other, one) };
                let at = pattern.supernode_of(columns.position);
                let supernode = &pattern.supernodes().list[at];
                let row = pattern
                    .supernodes()
                    .row(at, rows.position)
                    .expect("the pattern contains a block of these unknowns");
                blocks.push(DenseBlock {
                    start: supernode.start,
                    height: supernode.shape().height as u32,
                    row: row as u32,
                    column: columns.position as u32 - supernode.first,
                    from_row: rows.from as u8,
                    from_column: columns.from as u8,
                    rows: rows.length as u8,
                    columns: columns.length as u8,
                });
            }
        }
        Self { size: unknowns.len() as u32, blocks: blocks.into() }
    }

    /// Returns the range of matrix values that receive entries.
    pub(crate) fn range(&self) -> Range<usize> {
        enclosing_range(self.blocks.iter().map(DenseBlock::range))
    }

    /// Adds entries to a section of the matrix values that starts at index `skip`.
    ///
    /// `entry(k)` is the k-th entry of the lower triangle by columns.
    #[inline]
    pub fn add(&self, values: &mut [f64], skip: usize, entry: impl Fn(usize) -> f64) {
        let n = self.size as usize;
        for block in &*self.blocks {
            let (rows, i, j) = (block.rows as usize, block.from_row as usize, block.from_column as usize);
            if i == j {
                let mut k = start(n, j) + j;
                block.columns(|c, first| {
                    let column = &mut values[first + c - skip..first + rows - skip];
                    column.iter_mut().zip(k..).for_each(|(x, k)| *x += entry(k));
                    k += n - j - c;
                });
            } else if i > j {
                let mut k = start(n, j) + i;
                block.columns(|c, first| {
                    let column = &mut values[first - skip..first + rows - skip];
                    column.iter_mut().zip(k..).for_each(|(x, k)| *x += entry(k));
                    k += n - 1 - j - c;
                });
            } else {
                // The local matrix stores this block as a row.
                let row = start(n, i) + j;
                block.columns(|c, first| {
                    let mut k = row + c;
                    for (r, x) in values[first - skip..first + rows - skip].iter_mut().enumerate() {
                        *x += entry(k);
                        k += n - 1 - i - r;
                    }
                });
            }
        }
    }
}

/// Returns the index that row zero of column j would have in a lower triangle of n columns.
#[inline(always)]
const fn start(n: usize, j: usize) -> usize {
    j * n - j * (j + 1) / 2
}

impl DenseBlock {
    /// Returns the range of values of the block.
    fn range(&self) -> Range<usize> {
        let (mut start, mut end) = (usize::MAX, 0);
        self.columns(|_, first| (start, end) = (start.min(first), end.max(first + self.rows as usize)));
        start..end
    }

    /// Calls `work` for each column with its index and the index of its first value.
    #[inline(always)]
    fn columns(&self, mut work: impl FnMut(usize, usize)) {
        let (height, column) = (self.height as usize, self.column as usize);
        let shape = SupernodeShape { columns: 0, height };
        let mut first =
            self.start + QUAD * shape.column(column).start + self.row as usize - (column - column % QUAD);
        for c in 0..self.columns as usize {
            work(c, first);
            let j = column + c;
            // Every four columns, the first stored row moves down by one quad.
            first += QUAD * (height - j / QUAD) - if j % QUAD == QUAD - 1 { QUAD } else { 0 };
        }
    }
}

/// Splits unknowns into runs of consecutive positions.
fn unknown_runs(pattern: &Pattern, unknowns: &[u32]) -> Vec<UnknownRun> {
    let mut unknown_runs: Vec<UnknownRun> = Vec::new();
    for (from, &unknown) in unknowns.iter().enumerate() {
        let position = pattern.position(unknown as usize);
        match unknown_runs.last_mut() {
            Some(last)
                if last.position + last.length == position
                    && pattern.supernode_of(last.position) == pattern.supernode_of(position) =>
            {
                last.length += 1;
            }
            _ => unknown_runs.push(UnknownRun { from, length: 1, position }),
        }
    }
    unknown_runs
}

/// Returns the pattern of the sum of some terms. `rows` are the scaled rows of the constraints, which determine the order.
pub(super) fn pattern_of<'a>(
    coordinates: usize,
    rows: &[ConstraintRow],
    terms: impl Iterator<Item = &'a Arc<dyn Term>> + Clone,
) -> Pattern {
    let blocks: IndexLists = terms.clone().map(|term| unknowns(&**term, coordinates)).collect();
    assert!(blocks.iter().all(|block| block.len() <= LOCAL), "a term has at most {LOCAL} unknowns");
    let defining = terms.clone().filter(|term| !term.massless().is_empty());
    let defined: Vec<_> = defining.map(|term| (term.massless().to_vec(), term.multipliers())).collect();
    let constraints = terms.filter(|term| !term.multipliers().is_empty()).flat_map(|term| {
        let (own, first) = (term.coordinates(), coordinates + term.multipliers().start);
        term.constraint_entries().into_iter().map(move |[k, i]| [own[i], first + k])
    });
    Pattern::new(coordinates, rows, &blocks, &defined).with_border(constraints)
}

/// Returns the scatter maps of some terms.
pub(super) fn scatters(pattern: &Pattern, coordinates: usize, terms: &[Arc<dyn Term>]) -> Vec<Scatter> {
    let unknowns = |term: &Arc<dyn Term>| -> Vec<u32> { unknowns(&**term, coordinates).collect() };
    terms.iter().map(|term| Scatter::new(pattern, &unknowns(term))).collect()
}
