use std::collections::{HashMap, HashSet};
use std::ops::Range;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::amd;
use faer::sparse::{SymbolicSparseColMat, SymbolicSparseColMatRef};

/// Where a symmetric matrix has entries, in an order fit for LDLᵀ without pivoting.
///
/// Coordinates are ordered by minimum degree on the graph of *groups*: coordinates that belong to the same terms, such
/// as those of a node. Each multiplier follows right after the last coordinate that it touches, so that the Schur
/// complement in its place is negative definite when it is eliminated. Coordinates without mass come after the multipliers
/// that determine them, and positive there.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Position of each unknown.
    position: Vec<u32>,
    /// The strict order: unknown at each position.
    order: Vec<u32>,
    /// Lower triangle in positions; rows of a column ascending, the diagonal first.
    lower: SymbolicSparseColMat<usize>,
    /// Entries of multipliers with coordinates.
    border: Vec<Border>,
    /// Positions of coordinates without mass.
    massless: Vec<usize>,
    /// Positions of multipliers that the equations leave undetermined, in order.
    shared: Vec<usize>,
}

/// An entry of a multiplier with a coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Border {
    /// Position of the coordinate.
    pub(super) coordinate: usize,
    /// Position of the multiplier.
    pub(super) multiplier: usize,
    /// Index among the values of a matrix.
    pub(super) slot: usize,
}

impl Pattern {
    /// The pattern of a sum of dense blocks, each over the given unknowns; multipliers count after coordinates. Coordinates
    /// without mass come with the multipliers that determine them.
    pub(super) fn new(
        coordinates: usize,
        multipliers: usize,
        blocks: &[Vec<usize>],
        massless: &[(&[usize], Range<usize>)],
    ) -> Self {
        let size = coordinates + multipliers;
        let order = order(coordinates, multipliers, blocks, massless);
        let mut position = vec![0; size];
        for (at, &unknown) in order.iter().enumerate() {
            position[unknown as usize] = at as u32;
        }
        let mut lower: Vec<Vec<usize>> = (0..size).map(|i| vec![i]).collect();
        for block in blocks {
            for &j in block {
                let column = position[j] as usize;
                lower[column].extend(block.iter().map(|&i| position[i] as usize).filter(|&row| row > column));
            }
        }
        let (mut columns, mut rows) = (vec![0], Vec::new());
        for column in &mut lower {
            column.sort_unstable();
            column.dedup();
            rows.append(column);
            columns.push(rows.len());
        }
        let late = massless.iter().flat_map(|(late, _)| late.iter());
        let massless = late.map(|&coordinate| position[coordinate] as usize).collect();
        let border = border(&columns, &rows, |at| order[at] as usize >= coordinates);
        Self {
            position,
            lower: SymbolicSparseColMat::new_checked(size, size, columns, None, rows),
            order,
            border,
            massless,
            shared: Vec::new(),
        }
    }

    /// Says which unknowns are multipliers that the equations leave undetermined ([`Factor`](super::Factor)).
    pub(super) fn share(&mut self, unknowns: impl Iterator<Item = usize>) {
        self.shared = unknowns.map(|unknown| self.position(unknown)).collect();
        self.shared.sort_unstable();
    }

    /// The unknowns that were said to be such.
    pub(super) fn sharing(&self) -> impl Iterator<Item = usize> {
        self.shared.iter().map(|&at| self.order[at] as usize)
    }

    /// Positions of coordinates without mass.
    pub(super) fn massless(&self) -> &[usize] {
        &self.massless
    }

    /// Positions of multipliers that the equations leave undetermined.
    pub(super) fn shared(&self) -> &[usize] {
        &self.shared
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Number of entries in the lower triangle.
    pub fn entries(&self) -> usize {
        self.rows().len()
    }

    /// Where each column starts among the entries.
    pub(super) fn columns(&self) -> &[usize] {
        self.lower.col_ptr()
    }

    /// The row of each entry.
    pub(super) fn rows(&self) -> &[usize] {
        self.lower.row_idx()
    }

    /// Entries of multipliers with coordinates.
    pub(super) fn border(&self) -> &[Border] {
        &self.border
    }

    /// Position of an unknown in the order of elimination.
    pub fn position(&self, unknown: usize) -> usize {
        self.position[unknown] as usize
    }

    /// The unknown at a position.
    pub(super) fn unknown(&self, position: usize) -> usize {
        self.order[position] as usize
    }

    /// Index of the entry of two unknowns among the values of a matrix.
    ///
    /// # Panics
    /// If the two share no block.
    pub(super) fn slot(&self, i: usize, j: usize) -> u32 {
        let (i, j) = (self.position(i), self.position(j));
        let (row, column) = (i.max(j), i.min(j));
        let range = self.columns()[column]..self.columns()[column + 1];
        let at = self.rows()[range.clone()].binary_search(&row).expect("both unknowns belong to one block");
        (range.start + at) as u32
    }

    /// Columns and rows of the upper triangle.
    pub(super) fn upper(&self) -> (Vec<usize>, Vec<usize>) {
        let mut upper: Vec<Vec<usize>> = vec![Vec::new(); self.size()];
        for (column, range) in self.columns().windows(2).enumerate() {
            for &row in &self.rows()[range[0]..range[1]] {
                upper[row].push(column);
            }
        }
        let mut columns = vec![0];
        for column in &upper {
            columns.push(columns[columns.len() - 1] + column.len());
        }
        (columns, upper.concat())
    }

    /// The lower triangle in faer's form.
    pub(super) fn symbolic(&self) -> SymbolicSparseColMatRef<'_, usize> {
        self.lower.as_ref()
    }
}

/// Entries below the diagonal of which one unknown is a multiplier and the other is not.
fn border(columns: &[usize], rows: &[usize], is_multiplier: impl Fn(usize) -> bool) -> Vec<Border> {
    let mut border = Vec::new();
    for (column, range) in columns.windows(2).enumerate() {
        for slot in range[0]..range[1] {
            match (is_multiplier(rows[slot]), is_multiplier(column)) {
                (true, false) => border.push(Border { coordinate: column, multiplier: rows[slot], slot }),
                (false, true) => border.push(Border { coordinate: rows[slot], multiplier: column, slot }),
                _ => {}
            }
        }
    }
    border
}

/// The order of elimination: groups by minimum degree, each multiplier after its last coordinate.
fn order(
    coordinates: usize,
    multipliers: usize,
    blocks: &[Vec<usize>],
    massless: &[(&[usize], Range<usize>)],
) -> Vec<u32> {
    let (group_of, members) = groups(coordinates, blocks);
    let mut rank: Vec<Option<usize>> = vec![None; coordinates];
    let is_massless: HashSet<usize> = massless.iter().flat_map(|(late, _)| late.iter().copied()).collect();
    // What is at one rank comes in this order.
    let (regular, defining, late, other) = (0, 1, 2, 3);
    let mut places = Vec::with_capacity(coordinates + multipliers);
    for group in minimum_degree(&group_of, members.len(), blocks) {
        for &c in members[group].iter().filter(|&&c| !is_massless.contains(&(c as usize))) {
            rank[c as usize] = Some(places.len());
            places.push((places.len(), regular, c));
        }
    }
    let end = coordinates;
    let before = last_coordinates(coordinates, multipliers, blocks, &rank);
    let mut defines = vec![false; multipliers];
    for (coordinates, multipliers) in massless.iter().filter(|(late, _)| !late.is_empty()) {
        multipliers.clone().for_each(|m| defines[m] = true);
        let last = multipliers.clone().map(|m| before[m].unwrap_or(end)).max();
        coordinates.iter().for_each(|&c| rank[c] = rank[c].max(last));
    }
    places.extend(is_massless.iter().map(|&c| (rank[c].unwrap_or(end), late, c as u32)));
    let after = last_coordinates(coordinates, multipliers, blocks, &rank);
    places.extend((0..multipliers).map(|m| {
        let (rank, kind) = if defines[m] { (before[m], defining) } else { (after[m], other) };
        (rank.unwrap_or(end), kind, (coordinates + m) as u32)
    }));
    places.sort_unstable();
    places.into_iter().map(|(_, _, unknown)| unknown).collect()
}

/// Coordinates grouped by the set of blocks that they belong to: (group of each coordinate, members of each group).
fn groups(coordinates: usize, blocks: &[Vec<usize>]) -> (Vec<usize>, Vec<Vec<u32>>) {
    let mut blocks_of: Vec<Vec<u32>> = vec![Vec::new(); coordinates];
    for (b, block) in blocks.iter().enumerate() {
        for &c in block.iter().filter(|&&c| c < coordinates) {
            blocks_of[c].push(b as u32);
        }
    }
    let mut known: HashMap<Vec<u32>, usize> = HashMap::new();
    let (mut group_of, mut members) = (Vec::with_capacity(coordinates), Vec::new());
    for (c, key) in blocks_of.into_iter().enumerate() {
        let group = *known.entry(key).or_insert_with(|| {
            members.push(Vec::new());
            members.len() - 1
        });
        group_of.push(group);
        members[group].push(c as u32);
    }
    (group_of, members)
}

/// Approximate minimum degree order of the groups.
fn minimum_degree(group_of: &[usize], groups: usize, blocks: &[Vec<usize>]) -> Vec<usize> {
    let mut neighbours: Vec<Vec<usize>> = (0..groups).map(|g| vec![g]).collect();
    for block in blocks {
        let mut present: Vec<usize> =
            block.iter().filter(|&&c| c < group_of.len()).map(|&c| group_of[c]).collect();
        present.sort_unstable();
        present.dedup();
        for &g in &present {
            neighbours[g].extend_from_slice(&present);
        }
    }
    let (mut columns, mut rows) = (vec![0], Vec::new());
    for column in &mut neighbours {
        column.sort_unstable();
        column.dedup();
        rows.append(column);
        columns.push(rows.len());
    }
    let graph = SymbolicSparseColMatRef::new_checked(groups, groups, &columns, None, &rows);
    let (mut order, mut inverse) = (vec![0; groups], vec![0; groups]);
    let mut memory = MemBuffer::new(amd::order_scratch::<usize>(groups, rows.len()));
    let done =
        amd::order(&mut order, &mut inverse, graph, amd::Control::default(), MemStack::new(&mut memory));
    // AMD fails only when indices overflow; the natural order is then as good as any.
    if done.is_ok() { order } else { (0..groups).collect() }
}

/// For each multiplier the rank of the last coordinate that it touches, of those that have one.
fn last_coordinates(
    coordinates: usize,
    multipliers: usize,
    blocks: &[Vec<usize>],
    rank: &[Option<usize>],
) -> Vec<Option<usize>> {
    let mut last: Vec<Option<usize>> = vec![None; multipliers];
    for block in blocks {
        let latest = block.iter().filter(|&&c| c < coordinates).filter_map(|&c| rank[c]).max();
        for &unknown in block.iter().filter(|&&c| c >= coordinates) {
            last[unknown - coordinates] = last[unknown - coordinates].max(latest);
        }
    }
    last
}
