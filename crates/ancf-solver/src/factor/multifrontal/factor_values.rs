use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use crate::sparse::{FactorStorage, Subtree, Subtrees, Supernode, Supernodes, VectorSection};

/// Values of a factor L: of all supernodes, or of those of the trunk.
///
/// The values of subtrees that are not stored are computed again from the matrix for each substitution, in a buffer.
#[derive(Debug)]
pub(super) struct FactorValues {
    /// Stored values, in the order of the supernodes.
    pub(super) stored: Vec<f64>,
    /// Index of the first value of each range of the trunk, and its place among the stored values.
    pub(super) trunk: Vec<(usize, Range<usize>)>,
    /// Buffers for subtrees, unless they are stored.
    pub(super) buffers: Option<Buffers>,
}

/// Part of the values of all subtrees that the largest one may have, if they are not stored.
const LARGEST_PART: usize = 8;

/// Places of the stored values of a factor.
pub(super) struct FactorLayout {
    /// Number of stored values.
    pub(super) stored: usize,
    /// Index of the first value of each range of the trunk, and its place among the stored values.
    trunk: Vec<(usize, Range<usize>)>,
    /// Numbers of values and of pivots of the largest subtree, unless all factors are stored.
    largest: Option<[usize; 2]>,
}

impl FactorLayout {
    pub(super) fn new(supernodes: &Supernodes, subtrees: &Subtrees, storage: FactorStorage) -> Self {
        let sizes = || subtrees.list.iter().map(|subtree| values_of(supernodes, subtree).len());
        let (sum, most) = (sizes().sum::<usize>(), sizes().max().unwrap_or(0));
        let is_stored = storage == FactorStorage::All || LARGEST_PART * most > sum;
        let mut end = 0;
        let place = |range: &Range<usize>| {
            let (first, last) = (supernodes.list[range.start], supernodes.list[range.end - 1]);
            let start = if is_stored { first.start } else { end };
            end = start + last.values().end - first.start;
            (first.start, start..end)
        };
        let trunk = subtrees.trunk.iter().map(place).collect();
        let positions = subtrees.list.iter().map(|subtree| subtree.positions.len()).max().unwrap_or(0);
        let stored = if is_stored { supernodes.entries() } else { end };
        Self { stored, trunk, largest: (!is_stored).then_some([most, positions]) }
    }
}

impl FactorValues {
    pub(super) fn new(layout: FactorLayout) -> Self {
        let FactorLayout { stored, trunk, largest } = layout;
        let buffers = largest.map(|sizes| Buffers { free: Mutex::default(), sizes });
        Self { stored: vec![0.0; stored], trunk, buffers }
    }

    /// Returns the values of each range of the trunk.
    pub(super) fn trunk_sections(
        &self,
    ) -> impl DoubleEndedIterator<Item = FactorSection<'_>> + ExactSizeIterator {
        self.trunk.iter().map(|(first, place)| FactorSection::new(*first, &self.stored[place.clone()]))
    }
}

/// Values of a section of the factor.
#[derive(Clone, Copy)]
pub(super) struct FactorSection<'a> {
    /// Index of the first value.
    first: usize,
    values: &'a [f64],
}

impl<'a> FactorSection<'a> {
    /// Creates a section that begins with the value of an index.
    pub(super) fn new(first: usize, values: &'a [f64]) -> Self {
        Self { first, values }
    }

    /// Returns the values of a supernode.
    #[inline(always)]
    pub(super) fn of(&self, supernode: &Supernode) -> &'a [f64] {
        let values = supernode.values();
        &self.values[values.start - self.first..values.end - self.first]
    }
}

/// Buffers for the factors of subtrees, one for each thread that uses one at a time.
#[derive(Debug)]
pub(super) struct Buffers {
    free: Mutex<Vec<Buffer>>,
    /// Numbers of values and of pivots of the largest subtree.
    sizes: [usize; 2],
}

/// Values and inverse pivots of a subtree.
#[derive(Debug)]
pub(super) struct Buffer {
    values: Vec<f64>,
    inverse: Vec<f64>,
}

impl Buffers {
    /// Calls a function with a buffer.
    pub(super) fn lend<T>(&self, function: impl FnOnce(&mut Buffer) -> T) -> T {
        let free = || self.free.lock().unwrap_or_else(PoisonError::into_inner);
        let [values, positions] = self.sizes;
        let buffer = free().pop();
        let mut buffer =
            buffer.unwrap_or_else(|| Buffer { values: vec![0.0; values], inverse: vec![0.0; positions] });
        let result = function(&mut buffer);
        free().push(buffer);
        result
    }
}

impl Buffer {
    /// Returns sections for the values and inverse pivots of a subtree.
    pub(super) fn sections(&mut self, subtree: &Subtree) -> (VectorSection<'_>, VectorSection<'_>) {
        let Self { values, inverse } = self;
        (VectorSection::new(subtree.start, values), VectorSection::new(subtree.positions.start, inverse))
    }

    /// Returns the values of a subtree.
    pub(super) fn values(&self, subtree: &Subtree) -> FactorSection<'_> {
        FactorSection::new(subtree.start, &self.values)
    }

    /// Returns the inverse pivots of a subtree.
    pub(super) fn inverse(&self, subtree: &Subtree) -> &[f64] {
        &self.inverse[..subtree.positions.len()]
    }
}

/// Returns the range of the values of a subtree.
fn values_of(supernodes: &Supernodes, subtree: &Subtree) -> Range<usize> {
    subtree.start..supernodes.list[subtree.root()].values().end
}
