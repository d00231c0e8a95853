use super::elimination::Elimination;
use super::index_lists::Lists;
use super::ordering::{Massless, Ranks};
use super::supernodes::Panels;

/// Where a symmetric matrix has entries, in an order fit for LDLᵀ without pivoting.
///
/// Coordinates are ordered on the graph of *groups*: coordinates that belong to the same terms, such as those of a node. Trees
/// of groups are eliminated from their leaves, what is left by minimum degree. Each multiplier follows right after the last
/// group that it touches, so that the Schur complement in its place is negative definite when it is eliminated. Coordinates
/// without mass come after the multipliers that determine them, and positive there.
///
/// A group and what follows it make a *panel*, which is eliminated at once. Matrices and their factors are stored alike: each
/// panel with all rows that its elimination fills, dense.
#[derive(Clone, Debug)]
pub struct Pattern {
    /// Position of each unknown.
    position: Vec<u32>,
    /// The strict order: unknown at each position.
    order: Vec<u32>,
    /// The panel of each position.
    panel_of: Vec<u32>,
    panels: Panels,
    /// Entries of multipliers with coordinates.
    border: Vec<Border>,
    /// Positions of coordinates without mass.
    massless: Vec<usize>,
    /// Positions of multipliers that the equations leave undetermined, in order.
    shared: Vec<usize>,
}

/// An entry of a multiplier with a coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Border {
    /// Position of the coordinate.
    pub(crate) coordinate: usize,
    /// Position of the multiplier.
    pub(crate) multiplier: usize,
    /// Index among the values of a matrix.
    pub(crate) slot: usize,
}

impl Pattern {
    /// The pattern of a sum of dense blocks, each over the given unknowns; multipliers count after coordinates. Coordinates
    /// without mass come with the multipliers that determine them.
    pub(crate) fn new(coordinates: usize, multipliers: usize, blocks: &Lists, massless: &[Massless]) -> Self {
        let ranks = Ranks::new(coordinates, multipliers, blocks, massless);
        let Elimination { order, panels } = Elimination::new(&ranks, blocks);
        let mut position = vec![0; order.len()];
        for (&unknown, at) in order.iter().zip(0..) {
            position[unknown as usize] = at;
        }
        let of = panels.panels.iter().zip(0..);
        let panel_of = of.flat_map(|(panel, at)| panel.own().map(move |_| at)).collect();
        let late = massless.iter().flat_map(|(late, _)| late.iter());
        let massless = late.map(|&coordinate| position[coordinate] as usize).collect();
        let (border, shared) = (Vec::new(), Vec::new());
        let pattern = Self { position, order, panel_of, panels, border, massless, shared };
        Self { border: pattern.borders(coordinates, blocks), ..pattern }
    }

    /// The entries of the blocks of which one unknown is a multiplier and the other is not.
    fn borders(&self, coordinates: usize, blocks: &Lists) -> Vec<Border> {
        let mut borders = Vec::new();
        for block in blocks.iter() {
            let unknowns = || block.iter().map(|&unknown| unknown as usize);
            for multiplier in unknowns().filter(|&unknown| unknown >= coordinates) {
                borders.extend(unknowns().filter(|&unknown| unknown < coordinates).map(|coordinate| {
                    Border {
                        coordinate: self.position(coordinate),
                        multiplier: self.position(multiplier),
                        slot: self.slot(coordinate, multiplier),
                    }
                }));
            }
        }
        borders.sort_unstable_by_key(|border| border.slot);
        borders.dedup();
        borders
    }

    /// Says which unknowns are multipliers that the equations leave undetermined ([`Factor`](crate::factor::Factor)).
    pub(crate) fn share(&mut self, unknowns: impl Iterator<Item = usize>) {
        self.shared = unknowns.map(|unknown| self.position(unknown)).collect();
        self.shared.sort_unstable();
    }

    /// The unknowns that were said to be such.
    pub(crate) fn sharing(&self) -> impl Iterator<Item = usize> {
        self.shared.iter().map(|&at| self.order[at] as usize)
    }

    /// Positions of coordinates without mass.
    pub(crate) fn massless(&self) -> &[usize] {
        &self.massless
    }

    /// Whether there are multipliers that the equations leave undetermined.
    pub fn is_sharing(&self) -> bool {
        !self.shared.is_empty()
    }

    /// Positions of multipliers that the equations leave undetermined.
    pub(crate) fn shared(&self) -> &[usize] {
        &self.shared
    }

    /// Number of unknowns.
    pub fn size(&self) -> usize {
        self.order.len()
    }

    /// Number of values of a matrix: its lower triangle, what elimination fills, and what fills up panels.
    pub fn entries(&self) -> usize {
        self.panels.entries()
    }

    /// The panels.
    pub(crate) fn panels(&self) -> &Panels {
        &self.panels
    }

    /// The panel of a position.
    pub(crate) fn panel_of(&self, position: usize) -> usize {
        self.panel_of[position] as usize
    }

    /// Entries of multipliers with coordinates.
    pub(crate) fn border(&self) -> &[Border] {
        &self.border
    }

    /// Position of an unknown in the order of elimination.
    pub fn position(&self, unknown: usize) -> usize {
        self.position[unknown] as usize
    }

    /// The unknown at a position.
    pub(crate) fn unknown(&self, position: usize) -> usize {
        self.order[position] as usize
    }

    /// Index of the entry of two unknowns among the values of a matrix.
    ///
    /// # Panics
    /// If the two share no block.
    pub(crate) fn slot(&self, i: usize, j: usize) -> usize {
        let (i, j) = (self.position(i), self.position(j));
        let (row, column) = (i.max(j), i.min(j));
        let at = self.panel_of(column);
        let panel = &self.panels.panels[at];
        let row = self.panels.row(at, row).expect("both unknowns belong to one block");
        panel.start + panel.shape().at(row, column - panel.first as usize)
    }

    /// Index of the entry of a position with itself among the values of a matrix.
    pub(crate) fn diagonal(&self, position: usize) -> usize {
        let panel = &self.panels.panels[self.panel_of(position)];
        let at = position - panel.first as usize;
        panel.start + panel.shape().at(at, at)
    }
}
