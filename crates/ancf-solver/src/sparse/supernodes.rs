use std::ops::Range;

/// Numbers of a panel that are handled at once.
pub(crate) const LANES: usize = 4;

/// Four numbers of a column, one below the other.
pub(crate) type Quad = [f64; LANES];

/// The least number of quads that hold so many rows.
pub(crate) const fn quads(rows: usize) -> usize {
    rows.div_ceil(LANES)
}

/// The form of a lower block column: its own rows, filled up to quads, then those below, filled up likewise.
///
/// Columns come in fours, which begin at the quad of their diagonal. So nothing has to be done one by one at the ends, and little
/// is stored for nothing: 240 numbers for 12 columns and 12 rows below, where 222 have a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// Number of columns.
    pub(crate) columns: usize,
    /// Height in quads.
    pub(crate) height: usize,
}

impl Shape {
    /// That of so many columns with so many rows below.
    pub(crate) const fn new(columns: usize, below: usize) -> Self {
        Self { columns, height: quads(columns) + quads(below) }
    }

    /// Quads of its own rows.
    #[inline(always)]
    pub(crate) const fn own(self) -> usize {
        quads(self.columns)
    }

    /// Quads of the rows below.
    #[inline(always)]
    pub(crate) const fn below(self) -> usize {
        self.height - self.own()
    }

    /// The quads of a column among all, from that of its diagonal on.
    #[inline(always)]
    pub(crate) fn column(self, j: usize) -> Range<usize> {
        let four = j / LANES;
        let length = self.height - four;
        let start = LANES * four * self.height - 2 * four * four.saturating_sub(1) + (j % LANES) * length;
        start..start + length
    }

    /// The quads of four columns, or of those that are left.
    #[inline(always)]
    pub(crate) fn columns_of(self, four: usize) -> Range<usize> {
        let columns = LANES.min(self.columns - LANES * four);
        let start = self.column(LANES * four).start;
        start..start + columns * (self.height - four)
    }

    /// Number of quads.
    #[inline(always)]
    pub(crate) fn size(self) -> usize {
        self.column(self.columns).start
    }

    /// Where the number of a row and a column is, row ≥ column; rows below count from the first quad below.
    pub(crate) fn at(self, row: usize, column: usize) -> usize {
        LANES * self.column(column).start + row - (column - column % LANES)
    }
}

/// A block column of a matrix and of its factor: neighbours in the order of elimination that are eliminated together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Panel {
    /// Position of its first unknown.
    pub(crate) first: u32,
    /// Number of its unknowns.
    pub(crate) columns: u32,
    /// Number of rows below.
    pub(crate) below: u32,
    /// The first of its runs among all.
    pub(crate) runs: u32,
    /// The first panel of its subtree, whose panels are all from there to itself.
    pub(crate) subtree: u32,
    /// Where its values begin.
    pub(crate) start: usize,
}

impl Panel {
    #[inline(always)]
    pub(crate) fn shape(&self) -> Shape {
        Shape::new(self.columns as usize, self.below as usize)
    }

    /// The positions of its unknowns.
    #[inline(always)]
    pub(crate) fn own(&self) -> Range<usize> {
        self.first as usize..(self.first + self.columns) as usize
    }

    /// Its values among all.
    #[inline(always)]
    pub(crate) fn values(&self) -> Range<usize> {
        self.start..self.start + LANES * self.shape().size()
    }

    /// The form of what its elimination leaves to later panels.
    #[inline(always)]
    pub(crate) fn update(&self) -> Shape {
        Shape { columns: LANES * quads(self.below as usize), height: quads(self.below as usize) }
    }
}

/// Rows below a panel that follow each other and belong to one later panel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Run {
    /// Position of the first.
    pub(crate) first: u32,
    /// Number of rows.
    pub(crate) length: u32,
    /// The first among the rows of the parent, its own or those below.
    pub(crate) into: u32,
}

impl Run {
    /// The positions.
    #[inline(always)]
    pub(crate) fn positions(&self) -> Range<usize> {
        self.first as usize..(self.first + self.length) as usize
    }
}

/// The panels of a pattern in the order of elimination, and the runs of their rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Panels {
    /// The panels.
    pub(crate) panels: Vec<Panel>,
    /// The runs of all of them.
    pub(crate) runs: Vec<Run>,
}

impl Panels {
    /// The runs of a panel, ascending.
    #[inline(always)]
    pub(crate) fn runs(&self, panel: usize) -> &[Run] {
        let end = self.panels.get(panel + 1).map_or(self.runs.len(), |next| next.runs as usize);
        &self.runs[self.panels[panel].runs as usize..end]
    }

    /// The row of a position in a panel, of those that it has.
    pub(crate) fn row(&self, panel: usize, position: usize) -> Option<usize> {
        let own = self.panels[panel].own();
        if own.contains(&position) {
            return Some(position - own.start);
        }
        let mut row = LANES * quads(own.len());
        for run in self.runs(panel) {
            if run.positions().contains(&position) {
                return Some(row + position - run.first as usize);
            }
            row += run.length as usize;
        }
        None
    }

    /// Number of values of a matrix.
    pub(crate) fn entries(&self) -> usize {
        self.panels.last().map_or(0, |last| last.values().end)
    }
}
