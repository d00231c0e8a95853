use std::ops::Range;

use pulp::{Arch, NullaryFnOnce};

use super::substitution::{Backward, Forward, SubtractProduct, View, add_outside, copy_outside};
use crate::sparse::{Branch, Branches, LANES, LEAST, Panel, Panels, Quad, Shape, Stretch, children, fork};

/// Supernodal LDLᵀ of a symmetric matrix without pivoting, by the multifrontal method.
///
/// Each supernode is eliminated in a dense frontal matrix. The front assembles the entries of K and the update matrices
/// of the children. Its own update matrix stays on a stack until the parent is assembled. L is stored like the matrix.
/// Subtrees are processed in parallel. The trunk follows after them, or precedes them in backward substitution.
///
/// Source: Duff & Reid (1983); Liu (1992).
#[derive(Debug)]
pub(crate) struct Ldlt {
    /// Factor L, zero on and above the diagonal.
    l: Vec<f64>,
    /// Inverse pivots D⁻¹.
    inverse: Vec<f64>,
    branches: Branches,
    /// Working storage of the trunk and of each subtree.
    trunk: Space,
    spaces: Vec<Space>,
}

/// A pivot is zero, not finite, or below its rounding error.
pub(crate) struct BadPivot;

/// Working storage for the sequential elimination of supernodes.
#[derive(Debug)]
struct Space {
    front: Vec<Quad>,
    stack: Vec<Quad>,
    /// Number of quads on the stack, or `None` after a bad pivot.
    top: Option<usize>,
    /// Sections of vectors with the height of a supernode.
    part: Vec<Quad>,
    product: Vec<Quad>,
    /// Rows of a vector outside the subtree.
    outside: Vec<f64>,
}

impl Space {
    /// Allocates storage for supernodes in some ranges. Update matrices that leave the ranges or come from subtrees are
    /// kept elsewhere.
    fn new(panels: &Panels, ranges: &[Range<usize>], outside: usize, branches: &[Branch]) -> Self {
        let all = || ranges.iter().cloned().flatten().map(|at| panels.panels[at]);
        let most = |of: fn(Shape, Shape) -> usize| {
            let sizes = all().map(|panel| of(panel.shape(), panel.update()));
            vec![[0.0; LANES]; sizes.max().unwrap_or_default()]
        };
        let part = most(|shape, _| shape.height);
        Self {
            front: most(|shape, update| (shape.columns + update.columns) * shape.height),
            stack: vec![[0.0; LANES]; stack_height(panels, ranges, branches)],
            top: Some(0),
            product: part.clone(),
            part,
            outside: vec![0.0; outside],
        }
    }
}

/// Returns the maximum number of quads on the stack of update matrices.
fn stack_height(panels: &Panels, ranges: &[Range<usize>], branches: &[Branch]) -> usize {
    let (mut height, mut most) = (0, 0);
    for at in ranges.iter().cloned().flatten() {
        let own = children(panels, at).filter(|&child| branch_of(branches, child).is_none());
        height -= own.map(|child| panels.panels[child].update().size()).sum::<usize>();
        height += panels.panels[at].update().size();
        most = most.max(height);
    }
    most
}

/// Returns the subtree with a given root.
#[inline(always)]
fn branch_of(branches: &[Branch], root: usize) -> Option<usize> {
    branches.binary_search_by_key(&root, Branch::root).ok()
}

impl Ldlt {
    /// Allocates storage for matrices with the given supernodes.
    pub(crate) fn new(panels: &Panels) -> Self {
        Self::with(panels, Branches::new(panels, LEAST))
    }

    fn with(panels: &Panels, branches: Branches) -> Self {
        let unknowns = panels.panels.last().map_or(0, |last| last.own().end);
        let space = |branch: &Branch| {
            let outside = panels.panels[branch.root()].below as usize;
            Space::new(panels, std::slice::from_ref(&branch.panels), outside, &[])
        };
        Self {
            l: vec![0.0; panels.entries()],
            inverse: vec![0.0; unknowns],
            trunk: Space::new(panels, &branches.trunk, 0, &branches.branches),
            spaces: branches.branches.iter().map(space).collect(),
            branches,
        }
    }

    /// Factorises a matrix.
    ///
    /// # Errors
    /// If a pivot is zero, not finite, or below its rounding error.
    pub(crate) fn factorise(&mut self, panels: &Panels, k: &[f64]) -> Result<(), BadPivot> {
        let Self { l, inverse, branches: Branches { branches, trunk: ranges }, trunk, spaces } = self;
        fork(
            branches,
            spaces,
            (Stretch::whole(l), Stretch::whole(inverse)),
            &|(l, inverse), branch| {
                let ((l, next_l), (inverse, next)) =
                    (l.cut(branch.start), inverse.cut(branch.positions.start));
                ((l, inverse), (next_l, next))
            },
            &|branch, space, (l, inverse)| {
                space.top = Some(0);
                let range = branch.panels.clone();
                Arch::new().dispatch(Factorise {
                    panels,
                    k,
                    range,
                    l,
                    inverse,
                    space,
                    left: Left::default(),
                });
            },
        );
        let is_good = |space: &Space| space.top.is_some();
        trunk.top = spaces.iter().all(is_good).then_some(0);
        let left = Left { branches, spaces };
        for range in ranges.iter().cloned() {
            let (l, inverse) = (Stretch::whole(l), Stretch::whole(inverse));
            Arch::new().dispatch(Factorise { panels, k, range, l, inverse, space: trunk, left });
        }
        if is_good(trunk) { Ok(()) } else { Err(BadPivot) }
    }

    /// Solves K x = b in place, by position.
    pub(crate) fn solve(&mut self, panels: &Panels, x: &mut [f64]) {
        let Self { l, inverse, branches: Branches { branches, trunk: ranges }, trunk, spaces } = self;
        let (l, inverse, part) = (&l[..], &inverse[..], &mut trunk.part[..]);
        fork(
            branches,
            spaces,
            Stretch::whole(x),
            &|x, branch| x.cut(branch.positions.start),
            &|branch, space, x| {
                let (range, part) = (branch.panels.clone(), &mut space.part[..]);
                space.outside.fill(0.0);
                let x = View::of(panels, branch, x, &mut space.outside);
                Arch::new().dispatch(Forward { panels, range, l, x, part });
            },
        );
        for (branch, space) in branches.iter().zip(&*spaces) {
            add_outside(panels, branch, &space.outside, x);
        }
        for range in ranges.iter().cloned() {
            let x = View::whole(panels, &mut *x);
            Arch::new().dispatch(Forward { panels, range, l, x, part });
        }
        for range in ranges.iter().rev().cloned() {
            let x = View::whole(panels, &mut *x);
            Arch::new().dispatch(Backward { panels, range, l, inverse, x, part });
        }
        for (branch, space) in branches.iter().zip(&mut *spaces) {
            copy_outside(panels, branch, x, &mut space.outside);
        }
        fork(
            branches,
            spaces,
            Stretch::whole(x),
            &|x, branch| x.cut(branch.positions.start),
            &|branch, space, x| {
                let (range, part) = (branch.panels.clone(), &mut space.part[..]);
                let x = View::of(panels, branch, x, &mut space.outside);
                Arch::new().dispatch(Backward { panels, range, l, inverse, x, part });
            },
        );
    }

    /// Computes r −= K x by position, for a matrix with the same supernodes.
    pub(crate) fn subtract_product(&mut self, panels: &Panels, k: &[f64], x: &[f64], r: &mut [f64]) {
        let Self { branches: Branches { branches, trunk: ranges }, trunk, spaces, .. } = self;
        let x = || View::whole(panels, x);
        fork(
            branches,
            spaces,
            Stretch::whole(r),
            &|r, branch| r.cut(branch.positions.start),
            &|branch, space, r| {
                let (range, parts) = (branch.panels.clone(), (&mut space.part[..], &mut space.product[..]));
                space.outside.fill(0.0);
                let r = View::of(panels, branch, r, &mut space.outside);
                Arch::new().dispatch(SubtractProduct { panels, range, k, x: x(), r, parts });
            },
        );
        for (branch, space) in branches.iter().zip(&*spaces) {
            add_outside(panels, branch, &space.outside, r);
        }
        for range in ranges.iter().cloned() {
            let (r, parts) = (View::whole(panels, &mut *r), (&mut trunk.part[..], &mut trunk.product[..]));
            Arch::new().dispatch(SubtractProduct { panels, range, k, x: x(), r, parts });
        }
    }

    /// Returns the inverse pivots D⁻¹.
    pub(crate) fn inverse_pivots(&self) -> &[f64] {
        &self.inverse
    }
}

/// Update matrices that subtrees pass to the trunk.
#[derive(Clone, Copy, Default)]
struct Left<'a> {
    branches: &'a [Branch],
    spaces: &'a [Space],
}

impl<'a> Left<'a> {
    #[inline(always)]
    fn by(&self, root: usize) -> Option<&'a [Quad]> {
        branch_of(self.branches, root).map(|branch| &self.spaces[branch].stack[..])
    }
}

/// Elimination of a range of supernodes.
struct Factorise<'a> {
    panels: &'a Panels,
    k: &'a [f64],
    range: Range<usize>,
    l: Stretch<'a>,
    inverse: Stretch<'a>,
    space: &'a mut Space,
    left: Left<'a>,
}

impl NullaryFnOnce for Factorise<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        let Space { front, stack, part: sizes, top: space_top, .. } = self.space;
        let Some(mut top) = *space_top else { return };
        for at in self.range {
            let panel = &self.panels.panels[at];
            let k = self.k[panel.values()].as_chunks().0;
            let l = self.l.of(panel.values()).as_chunks_mut().0;
            let (inverse, left) = (self.inverse.of(panel.own()), self.left);
            let work = Work { panels: self.panels, at, panel, k, l, inverse, front, stack, sizes, top, left };
            // Common shapes are repeated as constants, so that the compiler knows their sizes.
            let done = match panel.shape() {
                Shape { columns: 12, height: 6 } => work.eliminate(Shape { columns: 12, height: 6 }),
                shape => work.eliminate(shape),
            };
            *space_top = done;
            match done {
                Some(now) => top = now,
                None => return,
            }
        }
    }
}

/// Data for the elimination of one supernode.
struct Work<'a> {
    panels: &'a Panels,
    at: usize,
    panel: &'a Panel,
    k: &'a [Quad],
    l: &'a mut [Quad],
    inverse: &'a mut [f64],
    front: &'a mut [Quad],
    stack: &'a mut [Quad],
    sizes: &'a mut [Quad],
    /// Number of quads on the stack.
    top: usize,
    left: Left<'a>,
}

impl Work<'_> {
    /// Eliminates a supernode. Returns the new number of quads on the stack if all pivots are good.
    #[inline(always)]
    fn eliminate(self, shape: Shape) -> Option<usize> {
        let (height, own, below) = (shape.height, shape.own(), shape.below());
        let front = &mut self.front[..(shape.columns + LANES * below) * height];
        super::front::fill(shape, front, self.k);
        let mut top = self.top;
        for child in children(self.panels, self.at) {
            let form = self.panels.panels[child].update();
            let update = match self.left.by(child) {
                Some(left) => &left[..form.size()],
                None => {
                    top -= form.size();
                    &self.stack[top..top + form.size()]
                }
            };
            super::front::take_in(shape, front, self.panels.runs(child), form, update);
        }
        let good = super::dense::eliminate(shape, front, self.l, self.inverse, &mut self.sizes[..own]);
        let form = self.panel.update();
        super::dense::update(shape, front, self.l, &mut self.stack[top..top + form.size()]);
        good.then_some(top + form.size())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sparse::Lists;
    use crate::sparse::Pattern;

    /// Subtrees change the result by rounding only. The number of threads does not change the result.
    #[test]
    fn branches_change_nothing() {
        // Nodes with three coordinates in a comb: each tooth is a chain attached to the previous tooth.
        let node = |n: u32| 3 * n..3 * n + 3;
        let links = (1..600).map(|n| (if n % 60 == 0 { n - 60 } else { n - 1 }, n));
        let blocks: Lists = links.map(|(a, b)| node(a).chain(node(b)).collect::<Vec<_>>()).collect();
        let pattern = Pattern::new(1800, 0, &blocks, &[]);
        let panels = pattern.panels();
        let mut k = vec![0.0; panels.entries()];
        for (i, j) in
            blocks.iter().flat_map(|block| block.iter().flat_map(|&i| block.iter().map(move |&j| (i, j))))
        {
            let other = (f64::from(i) * 0.7 + f64::from(j)).sin() * (f64::from(j) * 0.7 + f64::from(i)).cos();
            k[pattern.slot(i as usize, j as usize)] = if i == j { 12.0 } else { other };
        }
        let run = |least: usize, threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let mut ldlt = Ldlt::with(panels, Branches::new(panels, least));
            let b: Vec<f64> = (0..1800).map(|i| f64::from(i).sin()).collect();
            let (mut x, mut r) = (b.clone(), b);
            pool.install(|| {
                assert!(ldlt.factorise(panels, &k).is_ok());
                ldlt.solve(panels, &mut x);
                ldlt.subtract_product(panels, &k, &x, &mut r);
            });
            assert!(r.iter().all(|r| r.abs() < 1e-13));
            (ldlt.spaces.len(), [ldlt.l, ldlt.inverse, x, r])
        };
        let ((none, serial), (count, branched)) = (run(1800, 1), run(20, 1));
        assert!(none == 0 && count > 4, "{none} {count}");
        let pairs = serial.iter().flatten().zip(branched.iter().flatten());
        pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-13, "{a} {b}"));
        (2..5).for_each(|threads| assert_eq!(run(20, threads).1, branched));
    }
}
