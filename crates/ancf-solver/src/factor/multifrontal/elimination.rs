use std::ops::Range;

use pulp::NullaryFnOnce;

use super::large_front;
use super::work_space::{WorkSpace, subtree_of};
use crate::sparse::{
    QUAD, Quad, Subtree, Supernode, SupernodeShape, Supernodes, VectorSection, children, with_shape,
};

/// Update matrices that subtrees pass to the trunk.
#[derive(Clone, Copy, Default)]
pub(super) struct SubtreeUpdates<'a> {
    pub(super) subtrees: &'a [Subtree],
    pub(super) spaces: &'a [WorkSpace],
}

impl<'a> SubtreeUpdates<'a> {
    #[inline(always)]
    fn of(&self, root: usize) -> Option<&'a [Quad]> {
        subtree_of(self.subtrees, root).map(|subtree| &self.spaces[subtree].stack[..])
    }
}

/// Elimination of a range of supernodes.
pub(super) struct Factorise<'a> {
    pub(super) supernodes: &'a Supernodes,
    pub(super) k: &'a [f64],
    pub(super) range: Range<usize>,
    pub(super) l: VectorSection<'a>,
    pub(super) inverse: VectorSection<'a>,
    pub(super) space: &'a mut WorkSpace,
    pub(super) updates: SubtreeUpdates<'a>,
}

impl NullaryFnOnce for Factorise<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        let WorkSpace { front, stack, part: sizes, panel, top: space_top, .. } = self.space;
        let Some(mut top) = *space_top else { return };
        for at in self.range {
            let supernode = &self.supernodes.list[at];
            let k = self.k[supernode.values()].as_chunks().0;
            let l = self.l.slice(supernode.values()).as_chunks_mut().0;
            let (inverse, updates) = (self.inverse.slice(supernode.own()), self.updates);
            let work = EliminationStep {
                supernodes: self.supernodes,
                at,
                supernode,
                k,
                l,
                inverse,
                front,
                stack,
                sizes,
                panel,
                top,
                updates,
            };
            let done = with_shape!(shape = supernode.shape(), work.eliminate(shape));
            *space_top = done;
            match done {
                Some(now) => top = now,
                None => return,
            }
        }
    }
}

/// Data for the elimination of one supernode.
struct EliminationStep<'a> {
    supernodes: &'a Supernodes,
    at: usize,
    supernode: &'a Supernode,
    k: &'a [Quad],
    l: &'a mut [Quad],
    inverse: &'a mut [f64],
    front: &'a mut [Quad],
    stack: &'a mut [Quad],
    sizes: &'a mut [Quad],
    panel: &'a mut [Quad],
    /// Number of quads on the stack.
    top: usize,
    updates: SubtreeUpdates<'a>,
}

impl EliminationStep<'_> {
    /// Eliminates a supernode. Returns the new number of quads on the stack if all pivots are good.
    #[inline(always)]
    fn eliminate(self, shape: SupernodeShape) -> Option<usize> {
        let (height, own, below) = (shape.height, shape.own(), shape.below());
        let front = &mut self.front[..(shape.columns + QUAD * below) * height];
        super::front::fill(shape, front, self.k);
        let mut top = self.top;
        for child in children(self.supernodes, self.at) {
            let form = self.supernodes.list[child].update();
            let update = match self.updates.of(child) {
                Some(updates) => &updates[..form.size()],
                None => {
                    top -= form.size();
                    &self.stack[top..top + form.size()]
                }
            };
            super::front::extend_add(shape, front, self.supernodes.runs(child), form, update);
        }
        let form = self.supernode.update();
        let (sizes, update) = (&mut self.sizes[..own], &mut self.stack[top..top + form.size()]);
        let good = if large_front::is_large(shape) {
            large_front::eliminate(shape, front, self.l, self.inverse, sizes, self.panel, update)
        } else {
            let good = super::dense::eliminate(shape, front, self.l, self.inverse, sizes);
            super::dense::update(shape, front, self.l, update);
            good
        };
        good.then_some(top + form.size())
    }
}
