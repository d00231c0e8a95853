use std::ops::Range;

/// Number of rows that are processed at once.
pub(crate) const QUAD: usize = 4;

/// Four consecutive numbers of a column.
pub(crate) type Quad = [f64; QUAD];

/// Returns the number of quads that hold the given number of rows.
pub(crate) const fn quads(rows: usize) -> usize {
    rows.div_ceil(QUAD)
}

/// Shape of a lower block column: its own rows, padded to quads, then the rows below, padded to quads.
///
/// Columns are stored in groups of four that start at the quad of their diagonal. No remainder loops are necessary, and
/// the padding is small: 240 stored numbers for 12 columns and 12 rows below, of which 222 are entries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SupernodeShape {
    /// Number of columns.
    pub(crate) columns: usize,
    /// Height in quads.
    pub(crate) height: usize,
}

impl SupernodeShape {
    /// Creates the shape with the given numbers of columns and rows below.
    pub(crate) const fn new(columns: usize, below: usize) -> Self {
        Self { columns, height: quads(columns) + quads(below) }
    }

    /// Returns the number of quads of its own rows.
    #[inline(always)]
    pub(crate) const fn own(self) -> usize {
        quads(self.columns)
    }

    /// Returns the number of quads of the rows below.
    #[inline(always)]
    pub(crate) const fn below(self) -> usize {
        self.height - self.own()
    }

    /// Returns the quads of a column, from the quad of its diagonal.
    #[inline(always)]
    pub(crate) fn column(self, j: usize) -> Range<usize> {
        let four = j / QUAD;
        let length = self.height - four;
        let start = QUAD * four * self.height - 2 * four * four.saturating_sub(1) + (j % QUAD) * length;
        start..start + length
    }

    /// Returns the quads of a group of four columns, or of the last, incomplete group.
    #[inline(always)]
    pub(crate) fn columns_of(self, four: usize) -> Range<usize> {
        let columns = QUAD.min(self.columns - QUAD * four);
        let start = self.column(QUAD * four).start;
        start..start + columns * (self.height - four)
    }

    /// Returns the number of quads.
    #[inline(always)]
    pub(crate) fn size(self) -> usize {
        self.column(self.columns).start
    }

    /// Returns the index of the number at row ≥ column. Rows below are counted from the first quad below.
    pub(crate) fn at(self, row: usize, column: usize) -> usize {
        QUAD * self.column(column).start + row - (column - column % QUAD)
    }
}

/// Evaluates an expression for a shape. Common shapes are repeated with constant sizes, so that loops have known lengths.
///
/// They are nodes of a beam (12 coordinates, 12 rows below), and the two parts of a rigid body on a hinge: its centre with the
/// position of the hinge, and its directors with the other constraints (9 to 12 rows below).
macro_rules! with_shape {
    ($shape:ident = $of:expr, $evaluate:expr) => {
        match $of {
            $crate::sparse::SupernodeShape { columns: 12, height: 6 } => {
                let $shape = $crate::sparse::SupernodeShape { columns: 12, height: 6 };
                $evaluate
            }
            $crate::sparse::SupernodeShape { columns: 6, height: 5 } => {
                let $shape = $crate::sparse::SupernodeShape { columns: 6, height: 5 };
                $evaluate
            }
            $crate::sparse::SupernodeShape { columns: 17, height: 8 } => {
                let $shape = $crate::sparse::SupernodeShape { columns: 17, height: 8 };
                $evaluate
            }
            $shape => $evaluate,
        }
    };
}
pub(crate) use with_shape;

/// Block column of a matrix and its factor: neighbouring unknowns that are eliminated together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Supernode {
    /// Position of its first unknown.
    pub(crate) first: u32,
    /// Number of its unknowns.
    pub(crate) columns: u32,
    /// Number of rows below.
    pub(crate) below: u32,
    /// Index of its first run.
    pub(crate) runs: u32,
    /// First supernode of its subtree, which ends at this supernode.
    pub(crate) subtree: u32,
    /// Index of its first value.
    pub(crate) start: usize,
}

impl Supernode {
    #[inline(always)]
    pub(crate) fn shape(&self) -> SupernodeShape {
        SupernodeShape::new(self.columns as usize, self.below as usize)
    }

    /// Returns the positions of its unknowns.
    #[inline(always)]
    pub(crate) fn own(&self) -> Range<usize> {
        self.first as usize..(self.first + self.columns) as usize
    }

    /// Returns the range of its values.
    #[inline(always)]
    pub(crate) fn values(&self) -> Range<usize> {
        self.start..self.start + QUAD * self.shape().size()
    }

    /// Returns the shape of its update matrix.
    #[inline(always)]
    pub(crate) fn update(&self) -> SupernodeShape {
        SupernodeShape { columns: QUAD * quads(self.below as usize), height: quads(self.below as usize) }
    }
}

/// Run: consecutive rows below a supernode that belong to one later supernode.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowRun {
    /// Position of the first row.
    pub(crate) first: u32,
    /// Number of rows.
    pub(crate) length: u32,
    /// First row in the parent, counted over its own rows and the rows below.
    pub(crate) parent_row: u32,
}

impl RowRun {
    /// Returns the positions.
    #[inline(always)]
    pub(crate) fn positions(&self) -> Range<usize> {
        self.first as usize..(self.first + self.length) as usize
    }
}

/// Supernodes of a pattern in the order of elimination, and the runs of their rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Supernodes {
    /// Supernodes.
    pub(crate) list: Vec<Supernode>,
    /// Runs of all supernodes.
    pub(crate) runs: Vec<RowRun>,
}

impl Supernodes {
    /// Returns the runs of a supernode in ascending order.
    #[inline(always)]
    pub(crate) fn runs(&self, supernode: usize) -> &[RowRun] {
        let end = self.list.get(supernode + 1).map_or(self.runs.len(), |next| next.runs as usize);
        &self.runs[self.list[supernode].runs as usize..end]
    }

    /// Returns the row of a position in a supernode, if the supernode has it.
    pub(crate) fn row(&self, supernode: usize, position: usize) -> Option<usize> {
        let own = self.list[supernode].own();
        if own.contains(&position) {
            return Some(position - own.start);
        }
        let mut row = QUAD * quads(own.len());
        for run in self.runs(supernode) {
            if run.positions().contains(&position) {
                return Some(row + position - run.first as usize);
            }
            row += run.length as usize;
        }
        None
    }

    /// Returns the products of a factorisation, relative to those of a substitution.
    ///
    /// A column of h rows takes h²/2 products in the factorisation and 2 h in the substitution.
    pub(crate) fn factor_cost(&self) -> f64 {
        let substitution: f64 = self.heights().map(|rows| 2.0 * rows).sum();
        if substitution > 0.0 { self.products() / substitution } else { 0.0 }
    }

    /// Returns the products of a factorisation.
    pub(crate) fn products(&self) -> f64 {
        self.heights().map(|rows| 0.5 * rows * rows).sum()
    }

    /// Returns the heights of all columns.
    fn heights(&self) -> impl Iterator<Item = f64> {
        let of = |supernode: &Supernode| (supernode.below + 1..=supernode.below + supernode.columns).rev();
        self.list.iter().flat_map(of).map(f64::from)
    }

    /// Returns the number of values of a matrix.
    pub(crate) fn entries(&self) -> usize {
        self.list.last().map_or(0, |last| last.values().end)
    }
}
