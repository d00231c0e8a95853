use std::ops::Range;

use super::Pattern;
use super::panel::{LANES, Shape};

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
    pub(super) fn new(pattern: &Pattern, unknowns: &[u32]) -> Self {
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
    pub(super) fn range(&self) -> Range<usize> {
        let ranges = self.pieces.iter().map(Piece::range);
        ranges.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end)).unwrap_or_default()
    }

    /// Adds entries to the values of a matrix from the `first` on: `entry(k)` is the k-th of the lower triangle by columns.
    #[inline]
    pub fn add(&self, values: &mut [f64], first: usize, entry: impl Fn(usize) -> f64) {
        let n = self.size as usize;
        // Where a column would begin with row zero.
        let column = |j: usize| j * n - j * (j + 1) / 2;
        for piece in &*self.pieces {
            let (from_row, from_column) = (piece.from_row as usize, piece.from_column as usize);
            let rows = piece.rows as usize;
            for c in 0..piece.columns as usize {
                let j = from_column + c;
                if from_row == from_column {
                    let from = column(j) + j;
                    piece
                        .column(values, first, c, c)
                        .iter_mut()
                        .zip(from..)
                        .for_each(|(x, k)| *x += entry(k));
                } else if from_row > from_column {
                    let from = column(j) + from_row;
                    piece
                        .column(values, first, c, 0)
                        .iter_mut()
                        .zip(from..)
                        .for_each(|(x, k)| *x += entry(k));
                } else {
                    // The small matrix has it in a row.
                    let mut k = column(from_row) + j;
                    for (x, i) in piece.column(values, first, c, 0).iter_mut().zip(from_row..from_row + rows)
                    {
                        *x += entry(k);
                        k += n - 1 - i;
                    }
                }
            }
        }
    }
}

impl Piece {
    /// Where row zero of a column would be among the values.
    #[inline(always)]
    fn top(&self, column: usize) -> usize {
        let j = self.column as usize + column;
        let shape = Shape { columns: 0, height: self.height as usize };
        self.start + LANES * shape.column(j).start + self.row as usize - (j - j % LANES)
    }

    /// The values of a column from a row on, of those from the `first` on.
    #[inline(always)]
    fn column<'a>(&self, values: &'a mut [f64], first: usize, column: usize, row: usize) -> &'a mut [f64] {
        let top = self.top(column) - first;
        &mut values[top + row..top + self.rows as usize]
    }

    /// The range of the values that hold it.
    fn range(&self) -> Range<usize> {
        // A diagonal piece begins with the diagonal of its first column.
        self.top(0)..self.top(self.columns as usize - 1) + self.rows as usize
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
