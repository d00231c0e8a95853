use std::ops::{Deref, Range};

use pulp::NullaryFnOnce;

use crate::sparse::{Branch, LANES, Panel, Panels, Quad, Run, Shape, Stretch};

/// View of a vector for a subtree: its own positions, and the rows below its root, stored outside. The trunk sees all.
pub(crate) struct View<'a, S> {
    panels: &'a Panels,
    /// Root of the subtree.
    root: usize,
    /// First position of the subtree.
    first: usize,
    inside: S,
    outside: S,
}

impl<'a, S: Default> View<'a, S> {
    pub(crate) fn whole(panels: &'a Panels, x: S) -> Self {
        Self { panels, root: 0, first: 0, inside: x, outside: S::default() }
    }
}

impl<'a> View<'a, &'a mut [f64]> {
    pub(crate) fn of(panels: &'a Panels, branch: &Branch, x: Stretch<'a>, outside: &'a mut [f64]) -> Self {
        let (root, first) = (branch.root(), branch.positions.start);
        Self { panels, root, first, inside: x.into_of(branch.positions.clone()), outside }
    }

    #[inline(always)]
    fn own_mut(&mut self, panel: &Panel) -> &mut [f64] {
        let own = panel.own();
        &mut self.inside[own.start - self.first..own.end - self.first]
    }

    #[inline(always)]
    fn run_mut(&mut self, run: &Run) -> &mut [f64] {
        match self.place(run) {
            (true, at) => &mut self.inside[at],
            (false, at) => &mut self.outside[at],
        }
    }
}

impl<S: Deref<Target = [f64]>> View<'_, S> {
    #[inline(always)]
    fn own(&self, panel: &Panel) -> &[f64] {
        let own = panel.own();
        &self.inside[own.start - self.first..own.end - self.first]
    }

    #[inline(always)]
    fn run(&self, run: &Run) -> &[f64] {
        match self.place(run) {
            (true, at) => &self.inside[at],
            (false, at) => &self.outside[at],
        }
    }

    /// Returns true if a run is inside, and its range inside or outside.
    #[inline(always)]
    fn place(&self, run: &Run) -> (bool, Range<usize>) {
        let at = run.first as usize - self.first;
        let is_inside = at < self.inside.len();
        let at = if is_inside { at } else { self.row_outside(run.first) };
        (is_inside, at..at + run.length as usize)
    }

    fn row_outside(&self, position: u32) -> usize {
        let row = self.panels.row(self.root, position as usize);
        row.expect("a root has all rows of its subtree") - LANES * self.panels.panels[self.root].shape().own()
    }

    /// Copies the rows of a supernode, with zeros for the padding.
    #[inline(always)]
    fn gather(&self, part: &mut [Quad], panel: &Panel, runs: &[Run]) {
        part.fill([0.0; LANES]);
        let (own, below) = part.split_at_mut(panel.shape().own());
        own.as_flattened_mut()[..panel.columns as usize].copy_from_slice(self.own(panel));
        let mut below = below.as_flattened_mut();
        for run in runs {
            let (to, rest) = below.split_at_mut(run.length as usize);
            to.copy_from_slice(self.run(run));
            below = rest;
        }
    }
}

/// Adds the outside rows of a subtree to a vector.
pub(crate) fn add_outside(panels: &Panels, branch: &Branch, outside: &[f64], x: &mut [f64]) {
    let rows = panels.runs(branch.root()).iter().flat_map(Run::positions);
    rows.zip(outside).for_each(|(at, y)| x[at] += y);
}

/// Copies the outside rows of a subtree from a vector.
pub(crate) fn copy_outside(panels: &Panels, branch: &Branch, x: &[f64], outside: &mut [f64]) {
    let rows = panels.runs(branch.root()).iter().flat_map(Run::positions);
    rows.zip(outside).for_each(|(at, y)| *y = x[at]);
}

/// Forward substitution: solves L y = x in place for some supernodes and updates the rows below.
pub(crate) struct Forward<'a> {
    pub(crate) panels: &'a Panels,
    pub(crate) range: Range<usize>,
    pub(crate) l: &'a [f64],
    pub(crate) x: View<'a, &'a mut [f64]>,
    pub(crate) part: &'a mut [Quad],
}

impl NullaryFnOnce for Forward<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range {
            let (panel, runs) = (&self.panels.panels[at], self.panels.runs(at));
            let (shape, l) = (panel.shape(), self.l[panel.values()].as_chunks().0);
            let part = &mut self.part[..shape.height];
            self.x.gather(part, panel, runs);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    super::dense::forward(Shape { columns: 12, height: 6 }, l, part);
                }
                shape => super::dense::forward(shape, l, part),
            }
            let (own, below) = part.split_at(shape.own());
            self.x.own_mut(panel).copy_from_slice(&own.as_flattened()[..shape.columns]);
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
    pub(crate) panels: &'a Panels,
    pub(crate) range: Range<usize>,
    pub(crate) l: &'a [f64],
    pub(crate) inverse: &'a [f64],
    pub(crate) x: View<'a, &'a mut [f64]>,
    pub(crate) part: &'a mut [Quad],
}

impl NullaryFnOnce for Backward<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range.rev() {
            let (panel, runs) = (&self.panels.panels[at], self.panels.runs(at));
            let (shape, l) = (panel.shape(), self.l[panel.values()].as_chunks().0);
            let own = self.x.own_mut(panel).iter_mut();
            own.zip(&self.inverse[panel.own()]).for_each(|(x, inverse)| *x *= inverse);
            let part = &mut self.part[..shape.height];
            self.x.gather(part, panel, runs);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    super::dense::backward(Shape { columns: 12, height: 6 }, l, part);
                }
                shape => super::dense::backward(shape, l, part),
            }
            self.x.own_mut(panel).copy_from_slice(&part.as_flattened()[..shape.columns]);
        }
    }
}

/// Product r −= K x for some supernodes.
pub(crate) struct SubtractProduct<'a> {
    pub(crate) panels: &'a Panels,
    pub(crate) range: Range<usize>,
    pub(crate) k: &'a [f64],
    pub(crate) x: View<'a, &'a [f64]>,
    pub(crate) r: View<'a, &'a mut [f64]>,
    pub(crate) parts: (&'a mut [Quad], &'a mut [Quad]),
}

impl NullaryFnOnce for SubtractProduct<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for at in self.range {
            let (panel, runs) = (&self.panels.panels[at], self.panels.runs(at));
            let (shape, k) = (panel.shape(), self.k[panel.values()].as_chunks().0);
            let (part, product) = (&mut self.parts.0[..shape.height], &mut self.parts.1[..shape.height]);
            self.x.gather(part, panel, runs);
            product.fill([0.0; LANES]);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    super::dense::multiply(Shape { columns: 12, height: 6 }, k, part, product);
                }
                shape => super::dense::multiply(shape, k, part, product),
            }
            let (own, below) = product.split_at(shape.own());
            let subtract = |r: &mut [f64], y: &[f64]| r.iter_mut().zip(y).for_each(|(r, y)| *r -= y);
            subtract(self.r.own_mut(panel), own.as_flattened());
            let mut below = below.as_flattened();
            for run in runs {
                subtract(self.r.run_mut(run), below);
                below = &below[run.length as usize..];
            }
        }
    }
}
