use super::carriers::ConstraintRow;
use super::elimination::EliminationOrder;
use super::graph::IndexLists;
use super::ordering::{CoordinateGroups, CoreOrder, Massless, Ranks};
use super::supernodes::Supernodes;

/// Sparsity pattern of a symmetric matrix, ordered for LDLᵀ without pivoting.
///
/// Coordinates are ordered on the graph of *groups*. A group contains coordinates with the same terms, such as those of
/// a node. Trees of groups are eliminated from their leaves, and the remainder by minimum degree or by nested dissection, whichever
/// takes fewer operations. Each multiplier
/// follows the first group that can carry it. Its Schur complement is then negative definite. Massless coordinates follow
/// the multipliers that determine them, and their Schur complement is positive.
///
/// A group with its followers forms a *supernode*, which is eliminated at once. Large supernodes of nearly equal rows are
/// merged. Matrices and factors have the same storage: each supernode is dense with all rows of its fill-in.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Position of each unknown.
    position: Vec<u32>,
    /// Unknown at each position.
    order: Vec<u32>,
    /// Supernode of each position.
    supernode_of: Vec<u32>,
    supernodes: Supernodes,
    /// Entries that couple multipliers with coordinates.
    border: Vec<Border>,
    /// Positions of the coordinates of the border in ascending order.
    constrained: Vec<u32>,
    /// Positions of massless coordinates.
    massless: Vec<usize>,
    /// Positions of undetermined multipliers in ascending order.
    shared: Vec<usize>,
    /// Positions of coordinates without stiffness of their own, such as those of rigid bodies.
    without_stiffness: Vec<usize>,
    factor_storage: FactorStorage,
}

/// False in browsers, where models are small and code is transferred.
const IS_DISSECTED: bool = cfg!(not(target_family = "wasm"));
/// Products of a factorisation per supernode above which the dissection of the groups is tried, which takes as long as some of these
/// factorisations.
const DISSECTED: f64 = 2e5;

/// Part of the factors of a matrix that is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FactorStorage {
    /// All factors.
    #[default]
    All,
    /// Factors of the trunk, which follows the independent subtrees of the elimination. Factors of subtrees are computed again
    /// in each solution. Results are the same. All factors are stored if one subtree is larger than an eighth of all.
    Trunk,
}

/// Entry that couples a multiplier with a coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Border {
    /// Position of the coordinate.
    pub(crate) coordinate: u32,
    /// Position of the multiplier.
    pub(crate) multiplier: u32,
    /// Index among the values of a matrix.
    pub(crate) slot: usize,
}

impl Pattern {
    /// Creates the pattern of a sum of dense blocks over the given unknowns. Multipliers are numbered after
    /// coordinates, and each has a row.
    ///
    /// `massless` lists coordinates without mass and the multipliers that determine them.
    pub(crate) fn new(
        coordinates: usize,
        rows: &[ConstraintRow],
        blocks: &IndexLists,
        massless: &[Massless],
    ) -> Self {
        let groups = CoordinateGroups::new(coordinates, blocks);
        let elimination =
            |core| EliminationOrder::new(&Ranks::new(core, &groups, rows, blocks, massless), blocks);
        let mut best = elimination(CoreOrder::MinimumDegree);
        if IS_DISSECTED && best.supernodes.products() > DISSECTED * best.supernodes.list.len() as f64 {
            let other = elimination(CoreOrder::NestedDissection);
            if other.supernodes.products() < best.supernodes.products() {
                best = other;
            }
        }
        let EliminationOrder { order, supernodes } = best;
        let mut position = vec![0; order.len()];
        for (&unknown, at) in order.iter().zip(0..) {
            position[unknown as usize] = at;
        }
        let of = supernodes.list.iter().zip(0..);
        let supernode_of = of.flat_map(|(supernode, at)| supernode.own().map(move |_| at)).collect();
        let late = massless.iter().flat_map(|(late, _)| late.iter());
        let massless = late.map(|&coordinate| position[coordinate] as usize).collect();
        Self {
            position,
            order,
            supernode_of,
            supernodes,
            border: Vec::new(),
            constrained: Vec::new(),
            massless,
            shared: Vec::new(),
            without_stiffness: Vec::new(),
            factor_storage: FactorStorage::All,
        }
    }

    /// Sets the entries that couple a coordinate with a multiplier, both as unknowns.
    #[must_use]
    pub(crate) fn with_border(self, entries: impl Iterator<Item = [usize; 2]>) -> Self {
        let entry = |[coordinate, multiplier]: [usize; 2]| Border {
            coordinate: self.position[coordinate],
            multiplier: self.position[multiplier],
            slot: self.slot(coordinate, multiplier),
        };
        let mut border: Vec<Border> = entries.map(entry).collect();
        border.sort_unstable_by_key(|border| border.slot);
        border.dedup();
        let mut constrained: Vec<u32> = border.iter().map(|border| border.coordinate).collect();
        constrained.sort_unstable();
        constrained.dedup();
        Self { border, constrained, ..self }
    }

    /// Marks unknowns as multipliers that the equations leave undetermined ([`Factor`](crate::factor::Factor)).
    pub(crate) fn share(&mut self, unknowns: impl Iterator<Item = usize>) {
        self.shared = unknowns.map(|unknown| self.position(unknown)).collect();
        self.shared.sort_unstable();
    }

    /// Marks coordinates without stiffness of their own. In statics their stiffness is that of constraint forces.
    pub(crate) fn leave_without_stiffness(&mut self, coordinates: impl Iterator<Item = usize>) {
        self.without_stiffness = coordinates.map(|coordinate| self.position(coordinate)).collect();
    }

    /// Returns the positions of coordinates without stiffness of their own.
    pub(crate) fn without_stiffness(&self) -> &[usize] {
        &self.without_stiffness
    }

    /// Sets the stored part of factors.
    pub(crate) fn store(&mut self, storage: FactorStorage) {
        self.factor_storage = storage;
    }

    /// Returns the stored part of factors.
    pub fn factor_storage(&self) -> FactorStorage {
        self.factor_storage
    }

    /// Marks the same unknowns as another pattern of the system, and stores the same part of factors.
    pub(crate) fn mark_as(&mut self, other: &Self) {
        self.store(other.factor_storage);
        self.share(other.sharing());
        self.leave_without_stiffness(other.without_stiffness.iter().map(|&at| other.unknown(at)));
    }

    /// Returns the unknowns that are undetermined multipliers.
    pub(crate) fn sharing(&self) -> impl Iterator<Item = usize> {
        self.shared.iter().map(|&at| self.order[at] as usize)
    }

    /// Returns the positions of massless coordinates.
    pub(crate) fn massless(&self) -> &[usize] {
        &self.massless
    }

    /// Returns true if the equations leave some multipliers undetermined.
    pub fn has_shared_multipliers(&self) -> bool {
        !self.shared.is_empty()
    }

    /// Returns the positions of undetermined multipliers.
    pub(crate) fn shared(&self) -> &[usize] {
        &self.shared
    }

    /// Returns the number of unknowns.
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Returns the number of values of a matrix: lower triangle, fill-in and padding.
    pub fn entries(&self) -> usize {
        self.supernodes.entries()
    }

    /// Returns the supernodes.
    pub(crate) fn supernodes(&self) -> &Supernodes {
        &self.supernodes
    }

    /// Returns the supernode of a position.
    pub(crate) fn supernode_of(&self, position: usize) -> usize {
        self.supernode_of[position] as usize
    }

    /// Returns the entries that couple multipliers with coordinates.
    pub(crate) fn border(&self) -> &[Border] {
        &self.border
    }

    /// Returns the positions of the coordinates that are coupled with multipliers.
    pub(crate) fn constrained(&self) -> impl Iterator<Item = usize> {
        self.constrained.iter().map(|&at| at as usize)
    }

    /// Returns the position of an unknown in the order of elimination.
    pub fn position(&self, unknown: usize) -> usize {
        self.position[unknown] as usize
    }

    /// Returns the unknowns by position.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Returns the unknown at a position.
    pub(crate) fn unknown(&self, position: usize) -> usize {
        self.order[position] as usize
    }

    /// Returns the index of the entry of two unknowns among the values of a matrix.
    ///
    /// # Panics
    /// If the unknowns share no block.
    pub(crate) fn slot(&self, i: usize, j: usize) -> usize {
        self.find_slot(i, j).expect("both unknowns belong to one block")
    }

    /// Returns the index of the entry of two unknowns, or `None` if the pattern has no such entry.
    pub(crate) fn find_slot(&self, i: usize, j: usize) -> Option<usize> {
        let (i, j) = (self.position(i), self.position(j));
        let (row, column) = (i.max(j), i.min(j));
        let at = self.supernode_of(column);
        let supernode = &self.supernodes.list[at];
        let row = self.supernodes.row(at, row)?;
        Some(supernode.start + supernode.shape().at(row, column - supernode.first as usize))
    }

    /// Returns true if the pattern has the entries of a dense block over the given unknowns.
    pub(crate) fn contains(&self, unknowns: &[u32]) -> bool {
        let mut positions: Vec<usize> =
            unknowns.iter().map(|&unknown| self.position(unknown as usize)).collect();
        positions.sort_unstable();
        let has_rows = |(k, &column): (usize, &usize)| {
            let at = self.supernode_of(column);
            positions[k..].iter().all(|&row| self.supernodes.row(at, row).is_some())
        };
        positions.iter().enumerate().all(has_rows)
    }

    /// Returns the index of the diagonal entry of a position among the values of a matrix.
    pub(crate) fn diagonal(&self, position: usize) -> usize {
        let supernode = &self.supernodes.list[self.supernode_of(position)];
        let at = position - supernode.first as usize;
        supernode.start + supernode.shape().at(at, at)
    }
}
