use std::ops::Range;

use pulp::{Arch, NullaryFnOnce};

use super::large_front;
use super::substitution::{Backward, Forward, SubtractProduct, SubtreeView, add_outside, copy_outside};
use crate::sparse::{
    MIN_SUBTREE, QUAD, Quad, Subtree, Subtrees, Supernode, SupernodeShape, Supernodes, VectorSection,
    children, process_subtrees, with_shape,
};

/// Supernodal LDLᵀ of a symmetric matrix without pivoting, by the multifrontal method.
///
/// Each supernode is eliminated in a dense frontal matrix. The front assembles the entries of K and the update matrices
/// of the children. Its own update matrix is kept on a stack until the parent is assembled. L is stored like the matrix.
/// Subtrees are processed in parallel. The trunk follows after them, or precedes them in backward substitution.
///
/// Source: Duff & Reid (1983); Liu (1992).
#[derive(Debug)]
pub(crate) struct Ldlt {
    /// Factor L, zero on and above the diagonal.
    l: Vec<f64>,
    /// Inverse pivots D⁻¹.
    inverse: Vec<f64>,
    subtrees: Subtrees,
    /// Working storage of the trunk and of each subtree.
    trunk: WorkSpace,
    spaces: Vec<WorkSpace>,
}

/// A pivot is zero, not finite, or below its rounding error.
pub(crate) struct BadPivot;

/// Working storage for the sequential elimination of supernodes.
#[derive(Debug)]
struct WorkSpace {
    front: Vec<Quad>,
    stack: Vec<Quad>,
    /// Number of quads on the stack, or `None` after a bad pivot.
    top: Option<usize>,
    /// Sections of vectors with the height of a supernode.
    part: Vec<Quad>,
    product: Vec<Quad>,
    /// Factor of a panel of a large front.
    panel: Vec<Quad>,
    /// Rows of a vector outside the subtree.
    outside: Vec<f64>,
}

impl WorkSpace {
    /// Allocates storage for supernodes in some ranges. Update matrices that leave the ranges or come from subtrees are
    /// kept elsewhere.
    fn new(supernodes: &Supernodes, ranges: &[Range<usize>], outside: usize, subtrees: &[Subtree]) -> Self {
        let all = || ranges.iter().cloned().flatten().map(|at| supernodes.list[at]);
        let most = |of: fn(SupernodeShape, SupernodeShape) -> usize| {
            let sizes = all().map(|supernode| of(supernode.shape(), supernode.update()));
            vec![[0.0; QUAD]; sizes.max().unwrap_or_default()]
        };
        let part = most(|shape, _| shape.height);
        Self {
            front: most(|shape, update| (shape.columns + update.columns) * shape.height),
            stack: vec![[0.0; QUAD]; stack_height(supernodes, ranges, subtrees)],
            top: Some(0),
            product: part.clone(),
            panel: most(|shape, _| large_front::storage(shape)),
            part,
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
fn subtree_of(subtrees: &[Subtree], root: usize) -> Option<usize> {
    subtrees.binary_search_by_key(&root, Subtree::root).ok()
}

impl Ldlt {
    /// Allocates storage for matrices with the given supernodes.
    pub(crate) fn new(supernodes: &Supernodes) -> Self {
        Self::with(supernodes, Subtrees::new(supernodes, MIN_SUBTREE))
    }

    fn with(supernodes: &Supernodes, subtrees: Subtrees) -> Self {
        let unknowns = supernodes.list.last().map_or(0, |last| last.own().end);
        let space = |subtree: &Subtree| {
            let outside = supernodes.list[subtree.root()].below as usize;
            WorkSpace::new(supernodes, std::slice::from_ref(&subtree.supernodes), outside, &[])
        };
        Self {
            l: vec![0.0; supernodes.entries()],
            inverse: vec![0.0; unknowns],
            trunk: WorkSpace::new(supernodes, &subtrees.trunk, 0, &subtrees.list),
            spaces: subtrees.list.iter().map(space).collect(),
            subtrees,
        }
    }

    /// Factorises a matrix.
    ///
    /// # Errors
    /// If a pivot is zero, not finite, or below its rounding error.
    pub(crate) fn factorise(&mut self, supernodes: &Supernodes, k: &[f64]) -> Result<(), BadPivot> {
        let Self { l, inverse, subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces } = self;
        process_subtrees(
            subtrees,
            spaces,
            (VectorSection::full(l), VectorSection::full(inverse)),
            &|(l, inverse), subtree| {
                let ((l, next_l), (inverse, next)) =
                    (l.split_at(subtree.start), inverse.split_at(subtree.positions.start));
                ((l, inverse), (next_l, next))
            },
            &|subtree, space, (l, inverse)| {
                space.top = Some(0);
                let range = subtree.supernodes.clone();
                Arch::new().dispatch(Factorise {
                    supernodes,
                    k,
                    range,
                    l,
                    inverse,
                    space,
                    updates: SubtreeUpdates::default(),
                });
            },
        );
        let is_good = |space: &WorkSpace| space.top.is_some();
        trunk.top = spaces.iter().all(is_good).then_some(0);
        let updates = SubtreeUpdates { subtrees, spaces };
        for range in ranges.iter().cloned() {
            let (l, inverse) = (VectorSection::full(l), VectorSection::full(inverse));
            Arch::new().dispatch(Factorise { supernodes, k, range, l, inverse, space: trunk, updates });
        }
        if is_good(trunk) { Ok(()) } else { Err(BadPivot) }
    }

    /// Solves K x = b in place, by position.
    pub(crate) fn solve(&mut self, supernodes: &Supernodes, x: &mut [f64]) {
        let Self { l, inverse, subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces } = self;
        let (l, inverse, part) = (&l[..], &inverse[..], &mut trunk.part[..]);
        process_subtrees(
            subtrees,
            spaces,
            VectorSection::full(x),
            &|x, subtree| x.split_at(subtree.positions.start),
            &|subtree, space, x| {
                let (range, part) = (subtree.supernodes.clone(), &mut space.part[..]);
                space.outside.fill(0.0);
                let x = SubtreeView::of(supernodes, subtree, x, &mut space.outside);
                Arch::new().dispatch(Forward { supernodes, range, l, x, part });
            },
        );
        for (subtree, space) in subtrees.iter().zip(&*spaces) {
            add_outside(supernodes, subtree, &space.outside, x);
        }
        for range in ranges.iter().cloned() {
            let x = SubtreeView::whole(supernodes, &mut *x);
            Arch::new().dispatch(Forward { supernodes, range, l, x, part });
        }
        for range in ranges.iter().rev().cloned() {
            let x = SubtreeView::whole(supernodes, &mut *x);
            Arch::new().dispatch(Backward { supernodes, range, l, inverse, x, part });
        }
        for (subtree, space) in subtrees.iter().zip(&mut *spaces) {
            copy_outside(supernodes, subtree, x, &mut space.outside);
        }
        process_subtrees(
            subtrees,
            spaces,
            VectorSection::full(x),
            &|x, subtree| x.split_at(subtree.positions.start),
            &|subtree, space, x| {
                let (range, part) = (subtree.supernodes.clone(), &mut space.part[..]);
                let x = SubtreeView::of(supernodes, subtree, x, &mut space.outside);
                Arch::new().dispatch(Backward { supernodes, range, l, inverse, x, part });
            },
        );
    }

    /// Computes r −= K x by position, for a matrix with the same supernodes.
    pub(crate) fn subtract_product(&mut self, supernodes: &Supernodes, k: &[f64], x: &[f64], r: &mut [f64]) {
        let Self { subtrees: Subtrees { list: subtrees, trunk: ranges }, trunk, spaces, .. } = self;
        let x = || SubtreeView::whole(supernodes, x);
        process_subtrees(
            subtrees,
            spaces,
            VectorSection::full(r),
            &|r, subtree| r.split_at(subtree.positions.start),
            &|subtree, space, r| {
                let (range, parts) =
                    (subtree.supernodes.clone(), (&mut space.part[..], &mut space.product[..]));
                space.outside.fill(0.0);
                let r = SubtreeView::of(supernodes, subtree, r, &mut space.outside);
                Arch::new().dispatch(SubtractProduct { supernodes, range, k, x: x(), r, parts });
            },
        );
        for (subtree, space) in subtrees.iter().zip(&*spaces) {
            add_outside(supernodes, subtree, &space.outside, r);
        }
        for range in ranges.iter().cloned() {
            let (r, parts) =
                (SubtreeView::whole(supernodes, &mut *r), (&mut trunk.part[..], &mut trunk.product[..]));
            Arch::new().dispatch(SubtractProduct { supernodes, range, k, x: x(), r, parts });
        }
    }

    /// Returns the inverse pivots D⁻¹.
    pub(crate) fn inverse_pivots(&self) -> &[f64] {
        &self.inverse
    }
}

/// Update matrices that subtrees pass to the trunk.
#[derive(Clone, Copy, Default)]
struct SubtreeUpdates<'a> {
    subtrees: &'a [Subtree],
    spaces: &'a [WorkSpace],
}

impl<'a> SubtreeUpdates<'a> {
    #[inline(always)]
    fn of(&self, root: usize) -> Option<&'a [Quad]> {
        subtree_of(self.subtrees, root).map(|subtree| &self.spaces[subtree].stack[..])
    }
}

/// Elimination of a range of supernodes.
struct Factorise<'a> {
    supernodes: &'a Supernodes,
    k: &'a [f64],
    range: Range<usize>,
    l: VectorSection<'a>,
    inverse: VectorSection<'a>,
    space: &'a mut WorkSpace,
    updates: SubtreeUpdates<'a>,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::IndexLists;
    use crate::sparse::Pattern;

    /// Subtrees change the result by rounding only. The number of threads does not change the result.
    #[test]
    fn subtrees_change_rounding_only() {
        // Nodes with three coordinates in a comb: each tooth is a chain attached to the previous tooth.
        let node = |n: u32| 3 * n..3 * n + 3;
        let links = (1..600).map(|n| (if n % 60 == 0 { n - 60 } else { n - 1 }, n));
        let blocks: IndexLists = links.map(|(a, b)| node(a).chain(node(b)).collect::<Vec<_>>()).collect();
        let pattern = Pattern::new(1800, &[], &blocks, &[]);
        let supernodes = pattern.supernodes();
        let mut k = vec![0.0; supernodes.entries()];
        for (i, j) in
            blocks.iter().flat_map(|block| block.iter().flat_map(|&i| block.iter().map(move |&j| (i, j))))
        {
            let other = (f64::from(i) * 0.7 + f64::from(j)).sin() * (f64::from(j) * 0.7 + f64::from(i)).cos();
            k[pattern.slot(i as usize, j as usize)] = if i == j { 12.0 } else { other };
        }
        let run = |least: usize, threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut ldlt = Ldlt::with(supernodes, Subtrees::new(supernodes, least));
            let b: Vec<f64> = (0..1800).map(|i| f64::from(i).sin()).collect();
            let (mut x, mut r) = (b.clone(), b);
            pool.install(|| {
                assert!(ldlt.factorise(supernodes, &k).is_ok());
                ldlt.solve(supernodes, &mut x);
                ldlt.subtract_product(supernodes, &k, &x, &mut r);
            });
            assert!(r.iter().all(|r| r.abs() < 1e-13));
            (ldlt.spaces.len(), [ldlt.l, ldlt.inverse, x, r])
        };
        let ((none, serial), (count, with_subtrees)) = (run(1800, 1), run(20, 1));
        assert!(none == 0 && count > 4, "{none} {count}");
        let pairs = serial.iter().flatten().zip(with_subtrees.iter().flatten());
        pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-13, "{a} {b}"));
        (2..5).for_each(|threads| assert_eq!(run(20, threads).1, with_subtrees));
    }
}
