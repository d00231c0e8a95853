use std::ops::{Deref, Range};

use pulp::NullaryFnOnce;

use super::factor_values::FactorSection;
use crate::sparse::{QUAD, Quad, RowRun, Subtree, Supernode, Supernodes, VectorSection, with_shape};

/// View of a vector for a subtree: its own positions, and the rows below its root, stored outside. The trunk sees all.
pub(crate) struct SubtreeView<'a, S> {
    supernodes: &'a Supernodes,
    /// Root of the subtree.
    root: usize,
    /// First position of the subtree.
    first: usize,
    inside: S,
    outside: S,
}

impl<'a, S: Default> SubtreeView<'a, S> {
    pub(crate) fn whole(supernodes: &'a Supernodes, x: S) -> Self {
        Self { supernodes, root: 0, first: 0, inside: x, outside: S::default() }
    }
}

impl<'a> SubtreeView<'a, &'a mut [f64]> {
    pub(crate) fn of(
        supernodes: &'a Supernodes,
        subtree: &Subtree,
        x: VectorSection<'a>,
        outside: &'a mut [f64],
    ) -> Self {
        let (root, first) = (subtree.root(), subtree.positions.start);
        Self { supernodes, root, first, inside: x.into_slice(subtree.positions.clone()), outside }
    }

    #[inline(always)]
    fn own_mut(&mut self, supernode: &Supernode) -> &mut [f64] {
        let own = supernode.own();
        &mut self.inside[own.start - self.first..own.end - self.first]
    }

    #[inline(always)]
    fn run_mut(&mut self, run: &RowRun) -> &mut [f64] {
        match self.place(run) {
            (true, at) => &mut self.inside[at],
            (false, at) => &mut self.outside[at],
        }
    }
}

impl<S: Deref<Target = [f64]>> SubtreeView<'_, S> {
    #[inline(always)]
    fn own(&self, supernode: &Supernode) -> &[f64] {
        let own = supernode.own();
        &self.inside[own.start - self.first..own.end - self.first]
    }

    #[inline(always)]
    fn run(&self, run: &RowRun) -> &[f64] {
        match self.place(run) {
            (true, at) => &self.inside[at],
            (false, at) => &self.outside[at],
        }
    }

    /// Returns true if a run is inside, and its range inside or outside.
    #[inline(always)]
    fn place(&self, run: &RowRun) -> (bool, Range<usize>) {
        let at = run.first as usize - self.first;
        let is_inside = at < self.inside.len();
        let at = if is_inside { at } else { self.row_outside(run.first) };
        (is_inside, at..at + run.length as usize)
    }

    fn row_outside(&self, position: u32) -> usize {
        let row = self.supernodes.row(self.root, position as usize);
        row.expect("a root contains all rows of its subtree")
            - QUAD * self.supernodes.list[self.root].shape().own()
    }

    /// Copies the rows of a supernode, with zeros for the padding.
    #[inline(always)]
    fn gather(&self, part: &mut [Quad], supernode: &Supernode, runs: &[RowRun]) {
        part.fill([0.0; QUAD]);
        let (own, below) = part.split_at_mut(supernode.shape().own());
        own.as_flattened_mut()[..supernode.columns as usize].copy_from_slice(self.own(supernode));
        let mut below = below.as_flattened_mut();
        for run in runs {
            let (to, rest) = below.split_at_mut(run.length as usize);
            to.copy_from_slice(self.run(run));
            below = rest;
        }
    }
}

/// Adds the outside rows of a subtree to a vector.
pub(crate) fn add_outside(supernodes: &Supernodes, subtree: &Subtree, outside: &[f64], x: &mut [f64]) {
    let rows = supernodes.runs(subtree.root()).iter().flat_map(RowRun::positions);
    rows.zip(outside).for_each(|(at, y)| x[at] += y);
}

/// Copies the outside rows of a subtree from a vector.
pub(crate) fn copy_outside(supernodes: &Supernodes, subtree: &Subtree, x: &[f64], outside: &mut [f64]) {
    let rows = supernodes.runs(subtree.root()).iter().flat_map(RowRun::positions);
    rows.zip(outside).for_each(|(at, y)| *y = x[at]);
}

/// Forward substitution: solves L y = x in place for some supernodes and updates the rows below.
pub(crate) struct Forward<'a> {
    pub(crate) supernodes: &'a Supernodes,
    pub(crate) range: Range<usize>,
    pub(crate) l: FactorSection<'a>,
    pub(crate) x: SubtreeView<'a, &'a mut [f64]>,
    pub(crate) part: &'a mut [Quad],
}

impl NullaryFnOnce for Forward<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range {
            let (supernode, runs) = (&self.supernodes.list[at], self.supernodes.runs(at));
            let (shape, l) = (supernode.shape(), self.l.of(supernode).as_chunks().0);
            let part = &mut self.part[..shape.height];
            self.x.gather(part, supernode, runs);
            with_shape!(shape = shape, super::dense::forward(shape, l, part));
            let (own, below) = part.split_at(shape.own());
            self.x.own_mut(supernode).copy_from_slice(&own.as_flattened()[..shape.columns]);
            let mut below = below.as_flattened();
            for run in runs {
                let (from, rest) = below.split_at(run.length as usize);
                self.x.run_mut(run).copy_from_slice(from);
                below = rest;
            }
        }
    }
}

/// Backward substitution: solves D Lᵀ y = x in place for some supernodes with known rows below.
pub(crate) struct Backward<'a> {
    pub(crate) supernodes: &'a Supernodes,
    pub(crate) range: Range<usize>,
    pub(crate) l: FactorSection<'a>,
    pub(crate) inverse: &'a [f64],
    pub(crate) x: SubtreeView<'a, &'a mut [f64]>,
    pub(crate) part: &'a mut [Quad],
}

impl NullaryFnOnce for Backward<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range.rev() {
            let (supernode, runs) = (&self.supernodes.list[at], self.supernodes.runs(at));
            let (shape, l) = (supernode.shape(), self.l.of(supernode).as_chunks().0);
            let own = self.x.own_mut(supernode).iter_mut();
            own.zip(&self.inverse[supernode.own()]).for_each(|(x, inverse)| *x *= inverse);
            let part = &mut self.part[..shape.height];
            self.x.gather(part, supernode, runs);
            with_shape!(shape = shape, super::dense::backward(shape, l, part));
            self.x.own_mut(supernode).copy_from_slice(&part.as_flattened()[..shape.columns]);
        }
    }
}

/// Product r −= K x for some supernodes.
pub(crate) struct SubtractProduct<'a> {
    pub(crate) supernodes: &'a Supernodes,
    pub(crate) range: Range<usize>,
    pub(crate) k: &'a [f64],
    pub(crate) x: SubtreeView<'a, &'a [f64]>,
    pub(crate) r: SubtreeView<'a, &'a mut [f64]>,
    pub(crate) parts: (&'a mut [Quad], &'a mut [Quad]),
}

impl NullaryFnOnce for SubtractProduct<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range {
            let (supernode, runs) = (&self.supernodes.list[at], self.supernodes.runs(at));
            let (shape, k) = (supernode.shape(), self.k[supernode.values()].as_chunks().0);
            let (part, product) = (&mut self.parts.0[..shape.height], &mut self.parts.1[..shape.height]);
            self.x.gather(part, supernode, runs);
            product.fill([0.0; QUAD]);
            with_shape!(shape = shape, super::dense::multiply(shape, k, part, product));
            let (own, below) = product.split_at(shape.own());
            let subtract = |r: &mut [f64], y: &[f64]| r.iter_mut().zip(y).for_each(|(r, y)| *r -= y);
            subtract(self.r.own_mut(supernode), own.as_flattened());
            let mut below = below.as_flattened();
            for run in runs {
                subtract(self.r.run_mut(run), below);
                below = &below[run.length as usize..];
            }
        }
    }
}
