use std::ops::Range;

use super::thread_parts::hull;
use crate::sparse::{LANES, Pattern, Shape};

/// Where the lower triangle of a small matrix over some unknowns goes in a matrix of a pattern.
///
/// Unknowns that follow each other both in the small matrix and in a panel make a run, each pair of runs a piece that is
/// dense in both: three pieces for an element of two nodes.
#[derive(Clone, Debug)]
pub struct Scatter {
    size: u32,
    pieces: Box<[Piece]>,
}

/// A part of a small matrix, dense in a panel.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// Where the values of the panel begin, and its height in quads.
    start: usize,
    height: u32,
    /// The first row and the first column in the panel.
    row: u32,
    column: u32,
    /// The first of the small matrix, in rows and in columns of the panel.
    from_row: u8,
    from_column: u8,
    rows: u8,
    columns: u8,
}

/// Unknowns that follow each other in a small matrix and in a panel.
#[derive(Clone, Copy)]
struct Stretch {
    from: usize,
    length: usize,
    position: usize,
}

impl Scatter {
    /// That of the given unknowns, multipliers counted after the coordinates.
    ///
    /// # Panics
    /// If the pattern was made without a block of them.
    pub(crate) fn new(pattern: &Pattern, unknowns: &[u32]) -> Self {
        let stretches = stretches(pattern, unknowns);
        let mut pieces = Vec::with_capacity(stretches.len() * (stretches.len() + 1) / 2);
        for (i, &one) in stretches.iter().enumerate() {
            for &other in &stretches[i..] {
                let (columns, rows) =
                    if one.position <= other.position { (one, other) } else { (other, one) };
                let at = pattern.panel_of(columns.position);
                let panel = &pattern.panels().panels[at];
                let row = pattern.panels().row(at, rows.position).expect("a block of these unknowns");
                pieces.push(Piece {
                    start: panel.start,
                    height: panel.shape().height as u32,
                    row: row as u32,
                    column: columns.position as u32 - panel.first,
                    from_row: rows.from as u8,
                    from_column: columns.from as u8,
                    rows: rows.length as u8,
                    columns: columns.length as u8,
                });
            }
        }
        Self { size: unknowns.len() as u32, pieces: pieces.into() }
    }

    /// The range of the values of a matrix to which it adds.
    pub(crate) fn range(&self) -> Range<usize> {
        hull(self.pieces.iter().map(Piece::range))
    }

    /// Adds entries to the values of a matrix, of which the first `skip` are left out: `entry(k)` is the k-th of the lower
    /// triangle by columns.
    #[inline]
    pub fn add(&self, values: &mut [f64], skip: usize, entry: impl Fn(usize) -> f64) {
        let n = self.size as usize;
        for piece in &*self.pieces {
            let (rows, i, j) = (piece.rows as usize, piece.from_row as usize, piece.from_column as usize);
            if i == j {
                let mut k = start(n, j) + j;
                piece.columns(|c, first| {
                    let column = &mut values[first + c - skip..first + rows - skip];
                    column.iter_mut().zip(k..).for_each(|(x, k)| *x += entry(k));
                    k += n - j - c;
                });
            } else if i > j {
                let mut k = start(n, j) + i;
                piece.columns(|c, first| {
                    let column = &mut values[first - skip..first + rows - skip];
                    column.iter_mut().zip(k..).for_each(|(x, k)| *x += entry(k));
                    k += n - 1 - j - c;
                });
            } else {
                // The small matrix has it in a row.
                let row = start(n, i) + j;
                piece.columns(|c, first| {
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

/// Where column j of a lower triangle of n columns would begin with row zero.
#[inline(always)]
const fn start(n: usize, j: usize) -> usize {
    j * n - j * (j + 1) / 2
}

impl Piece {
    /// The range of the values that hold it.
    fn range(&self) -> Range<usize> {
        let (mut start, mut end) = (usize::MAX, 0);
        self.columns(|_, first| (start, end) = (start.min(first), end.max(first + self.rows as usize)));
        start..end
    }

    /// Calls for each column with its number and where its first row is among the values.
    #[inline(always)]
    fn columns(&self, mut work: impl FnMut(usize, usize)) {
        let (height, column) = (self.height as usize, self.column as usize);
        let shape = Shape { columns: 0, height };
        let mut first =
            self.start + LANES * shape.column(column).start + self.row as usize - (column - column % LANES);
        for c in 0..self.columns as usize {
            work(c, first);
            let j = column + c;
            // Each four columns begin a quad of rows later than those before.
            first += LANES * (height - j / LANES) - if j % LANES == LANES - 1 { LANES } else { 0 };
        }
    }
}

/// Parts unknowns into those that follow each other.
fn stretches(pattern: &Pattern, unknowns: &[u32]) -> Vec<Stretch> {
    let mut stretches: Vec<Stretch> = Vec::new();
    for (from, &unknown) in unknowns.iter().enumerate() {
        let position = pattern.position(unknown as usize);
        match stretches.last_mut() {
            Some(last)
                if last.position + last.length == position
                    && pattern.panel_of(last.position) == pattern.panel_of(position) =>
            {
                last.length += 1;
            }
            _ => stretches.push(Stretch { from, length: 1, position }),
        }
    }
    stretches
}
