use std::ops::Range;

use super::large_front;
use crate::sparse::{QUAD, Quad, Subtree, SupernodeShape, Supernodes, children};

/// Working storage for the sequential elimination of supernodes.
#[derive(Debug)]
pub(super) struct WorkSpace {
    pub(super) front: Vec<Quad>,
    pub(super) stack: Vec<Quad>,
    /// Number of quads on the stack, or `None` after a bad pivot.
    pub(super) top: Option<usize>,
    /// Sections of vectors with the height of a supernode.
    pub(super) part: Vec<Quad>,
    pub(super) product: Vec<Quad>,
    /// Factor of a panel of a large front.
    pub(super) panel: Vec<Quad>,
    /// Rows of a vector outside the subtree.
    pub(super) outside: Vec<f64>,
}

/// Numbers of quads of a working storage.
#[derive(Clone, Copy, Debug)]
pub(super) struct WorkSize {
    front: usize,
    stack: usize,
    part: usize,
    panel: usize,
}

impl WorkSize {
    /// Determines the size for supernodes in some ranges. Update matrices that leave the ranges or come from subtrees are kept
    /// elsewhere.
    pub(super) fn new(supernodes: &Supernodes, ranges: &[Range<usize>], subtrees: &[Subtree]) -> Self {
        let all = || ranges.iter().cloned().flatten().map(|at| supernodes.list[at]);
        let most = |of: fn(SupernodeShape, SupernodeShape) -> usize| {
            all().map(|supernode| of(supernode.shape(), supernode.update())).max().unwrap_or_default()
        };
        Self {
            front: most(|shape, update| (shape.columns + update.columns) * shape.height),
            stack: stack_height(supernodes, ranges, subtrees),
            part: most(|shape, _| shape.height),
            panel: most(|shape, _| large_front::storage(shape)),
        }
    }

    /// Returns the size for a subtree.
    pub(super) fn of_subtree(supernodes: &Supernodes, subtree: &Subtree) -> Self {
        Self::new(supernodes, std::slice::from_ref(&subtree.supernodes), &[])
    }

    /// Returns the number of values.
    pub(super) fn values(self) -> usize {
        QUAD * (self.front + self.stack + 2 * self.part + self.panel)
    }
}

impl WorkSpace {
    /// Allocates working storage, with a number of rows outside the subtree.
    pub(super) fn new(size: WorkSize, outside: usize) -> Self {
        let quads = |count: usize| vec![[0.0; QUAD]; count];
        Self {
            front: quads(size.front),
            stack: quads(size.stack),
            top: Some(0),
            part: quads(size.part),
            product: quads(size.part),
            panel: quads(size.panel),
            outside: vec![0.0; outside],
        }
    }
}

/// Returns the maximum number of quads on the stack of update matrices.
fn stack_height(supernodes: &Supernodes, ranges: &[Range<usize>], subtrees: &[Subtree]) -> usize {
    let (mut height, mut most) = (0, 0);
    for at in ranges.iter().cloned().flatten() {
        let own = children(supernodes, at).filter(|&child| subtree_of(subtrees, child).is_none());
        height -= own.map(|child| supernodes.list[child].update().size()).sum::<usize>();
        height += supernodes.list[at].update().size();
        most = most.max(height);
    }
    most
}

/// Returns the subtree with a given root.
#[inline(always)]
pub(super) fn subtree_of(subtrees: &[Subtree], root: usize) -> Option<usize> {
    subtrees.binary_search_by_key(&root, Subtree::root).ok()
}
