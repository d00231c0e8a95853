use pulp::{Arch, NullaryFnOnce};

use super::dense;
use super::panel::{LANES, Panel, Panels, Quad, Run, Shape};

/// LDLᵀ of a symmetric matrix in panels, without pivoting, by the multifrontal method.
///
/// Each panel is eliminated in a dense matrix of its own, the front, which takes in the panel's entries of K and what its children
/// leave; what it leaves itself waits on a stack until its parent is there. L is stored as the matrix is.
///
/// Source: Duff & Reid (1983); Liu (1992).
#[derive(Debug)]
pub(super) struct Ldlt {
    /// L, zero on and above the diagonal.
    l: Vec<f64>,
    /// D⁻¹.
    inverse: Vec<f64>,
    front: Vec<f64>,
    stack: Vec<f64>,
    /// Parts of vectors, of the height of a panel.
    part: Vec<f64>,
    product: Vec<f64>,
}

/// A pivot is zero, not finite, or nothing but rounding error.
pub(super) struct BadPivot;

impl Ldlt {
    /// Memory for matrices in the given panels.
    pub(super) fn new(panels: &Panels) -> Self {
        let most = |of: fn(Shape, Shape) -> usize| {
            let sizes = panels.panels.iter().map(|panel| of(panel.shape(), panel.update()));
            LANES * sizes.max().unwrap_or_default()
        };
        let part = vec![0.0; most(|shape, _| shape.height)];
        let unknowns = panels.panels.last().map_or(0, |last| last.own().end);
        Self {
            l: vec![0.0; panels.entries()],
            inverse: vec![0.0; unknowns],
            front: vec![0.0; most(|shape, update| (shape.columns + update.columns) * shape.height)],
            stack: vec![0.0; LANES * stack_height(panels)],
            product: part.clone(),
            part,
        }
    }

    /// Factorises a matrix.
    ///
    /// # Errors
    /// At a pivot that is zero, not finite, or nothing but rounding error.
    pub(super) fn factorise(&mut self, panels: &Panels, k: &[f64]) -> Result<(), BadPivot> {
        Arch::new().dispatch(Factorise { panels, k, to: self })
    }

    /// Solves K x = b in place, in positions.
    pub(super) fn solve(&mut self, panels: &Panels, x: &mut [f64]) {
        Arch::new().dispatch(Solve { panels, x, with: self });
    }

    /// r −= K x in positions, with a matrix in the same panels.
    pub(super) fn subtract_product(&mut self, panels: &Panels, k: &[f64], x: &[f64], r: &mut [f64]) {
        let parts = (self.part.as_chunks_mut().0, self.product.as_chunks_mut().0);
        Arch::new().dispatch(SubtractProduct { panels, k, x, r, parts });
    }

    /// D⁻¹.
    pub(super) fn inverse_pivots(&self) -> &[f64] {
        &self.inverse
    }
}

/// The most quads that wait at once for parents.
fn stack_height(panels: &Panels) -> usize {
    let (mut height, mut most) = (0, 0);
    for (at, panel) in panels.panels.iter().enumerate() {
        height -= children(panels, at).map(|child| panels.panels[child].update().size()).sum::<usize>();
        height += panel.update().size();
        most = most.max(height);
    }
    most
}

/// The children of a panel, the last one first.
#[inline(always)]
fn children(panels: &Panels, panel: usize) -> impl Iterator<Item = usize> {
    let first = panels.panels[panel].subtree as usize;
    let mut end = panel;
    std::iter::from_fn(move || {
        let child = end.checked_sub(1).filter(|&child| child >= first)?;
        end = panels.panels[child].subtree as usize;
        Some(child)
    })
}

struct Factorise<'a> {
    panels: &'a Panels,
    k: &'a [f64],
    to: &'a mut Ldlt,
}

impl NullaryFnOnce for Factorise<'_> {
    type Output = Result<(), BadPivot>;

    #[inline(always)]
    fn call(self) -> Self::Output {
        let Ldlt { l, inverse, front, stack, part, .. } = self.to;
        let (k, front) = (self.k.as_chunks().0, front.as_chunks_mut().0);
        let (l, stack, sizes) = (l.as_chunks_mut().0, stack.as_chunks_mut().0, part.as_chunks_mut().0);
        let mut top = 0;
        for (at, panel) in self.panels.panels.iter().enumerate() {
            let values = panel.start / LANES..panel.values().end / LANES;
            let (k, l, inverse) = (&k[values.clone()], &mut l[values], &mut inverse[panel.own()]);
            let work = Work { panels: self.panels, at, panel, k, l, inverse, front, stack, sizes, top };
            // The usual forms again, for the compiler to know their sizes.
            let done = match panel.shape() {
                Shape { columns: 12, height: 6 } => work.eliminate(Shape { columns: 12, height: 6 }),
                shape => work.eliminate(shape),
            };
            top = done.ok_or(BadPivot)?;
        }
        Ok(())
    }
}

/// All that the elimination of one panel needs.
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
}

impl Work<'_> {
    /// Returns the new number of quads on the stack if all pivots are good.
    #[inline(always)]
    fn eliminate(self, shape: Shape) -> Option<usize> {
        let (height, own, below) = (shape.height, shape.own(), shape.below());
        let front = &mut self.front[..(shape.columns + LANES * below) * height];
        for (j, column) in front.chunks_exact_mut(height).enumerate() {
            if j < shape.columns {
                column[j / LANES..].copy_from_slice(&self.k[shape.column(j)]);
            } else {
                column[own + (j - shape.columns) / LANES..].fill([0.0; LANES]);
            }
        }
        let mut top = self.top;
        for child in children(self.panels, self.at) {
            let form = self.panels.panels[child].update();
            top -= form.size();
            let update = &self.stack[top..top + form.size()];
            match self.panels.runs(child) {
                [run] if (run.into as usize).is_multiple_of(LANES) => {
                    take_in_run(shape, front, run, form, update);
                }
                runs => take_in(shape, front, runs, form, update),
            }
        }
        let good = dense::eliminate(shape, front, self.l, self.inverse, &mut self.sizes[..own]);
        let form = self.panel.update();
        dense::update(shape, front, self.l, &mut self.stack[top..top + form.size()]);
        good.then_some(top + form.size())
    }
}

/// The column of a front for a row.
#[inline(always)]
fn column_of(shape: Shape, row: usize) -> usize {
    if row < shape.columns { row } else { shape.columns + row - LANES * shape.own() }
}

/// Adds what a child leaves if its rows follow each other and begin with a quad.
#[inline(always)]
fn take_in_run(shape: Shape, front: &mut [Quad], run: &Run, form: Shape, update: &[Quad]) {
    let (into, first) = (run.into as usize / LANES, column_of(shape, run.into as usize));
    for c in 0..run.length as usize {
        let four = c / LANES;
        let column = &mut front[(first + c) * shape.height..(first + c + 1) * shape.height];
        for (x, y) in column[into + four..].iter_mut().zip(&update[form.column(c)]) {
            (0..LANES).for_each(|lane| x[lane] += y[lane]);
        }
    }
}

/// Adds what a child leaves.
#[inline(always)]
fn take_in(shape: Shape, front: &mut [Quad], runs: &[Run], form: Shape, update: &[Quad]) {
    let mut c = 0;
    for (i, run) in runs.iter().enumerate() {
        for column in run.into..run.into + run.length {
            let from = column_of(shape, column as usize) * shape.height;
            let target = front[from..from + shape.height].as_flattened_mut();
            let mut source = &update[form.column(c)].as_flattened()[c % LANES..];
            let mut add = |into: u32, length: u32| {
                let (rows, rest) = source.split_at(length as usize);
                target[into as usize..].iter_mut().zip(rows).for_each(|(x, y)| *x += y);
                source = rest;
            };
            add(column, run.into + run.length - column);
            runs[i + 1..].iter().for_each(|rows| add(rows.into, rows.length));
            c += 1;
        }
    }
}

/// Copies the rows of a panel from a vector, zeros in between.
#[inline(always)]
fn gather(part: &mut [Quad], panel: &Panel, runs: &[Run], x: &[f64]) {
    part.fill([0.0; LANES]);
    let (own, below) = part.split_at_mut(panel.shape().own());
    own.as_flattened_mut()[..panel.columns as usize].copy_from_slice(&x[panel.own()]);
    let mut below = below.as_flattened_mut();
    for run in runs {
        let (to, rest) = below.split_at_mut(run.length as usize);
        to.copy_from_slice(&x[run.positions()]);
        below = rest;
    }
}

struct Solve<'a> {
    panels: &'a Panels,
    x: &'a mut [f64],
    with: &'a mut Ldlt,
}

impl NullaryFnOnce for Solve<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        let Self { panels, x, with } = self;
        let part = with.part.as_chunks_mut().0;
        for (at, panel) in panels.panels.iter().enumerate() {
            let (shape, runs, l) = (panel.shape(), panels.runs(at), with.l[panel.values()].as_chunks().0);
            let part = &mut part[..shape.height];
            gather(part, panel, runs, x);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    dense::forward(Shape { columns: 12, height: 6 }, l, part);
                }
                shape => dense::forward(shape, l, part),
            }
            let (own, below) = part.split_at(shape.own());
            x[panel.own()].copy_from_slice(&own.as_flattened()[..shape.columns]);
            let mut below = below.as_flattened();
            for run in runs {
                let (from, rest) = below.split_at(run.length as usize);
                x[run.positions()].copy_from_slice(from);
                below = rest;
            }
        }
        for (at, panel) in panels.panels.iter().enumerate().rev() {
            let (shape, runs, l) = (panel.shape(), panels.runs(at), with.l[panel.values()].as_chunks().0);
            let own = &mut x[panel.own()];
            own.iter_mut().zip(&with.inverse[panel.own()]).for_each(|(x, inverse)| *x *= inverse);
            let part = &mut part[..shape.height];
            gather(part, panel, runs, x);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    dense::backward(Shape { columns: 12, height: 6 }, l, part);
                }
                shape => dense::backward(shape, l, part),
            }
            x[panel.own()].copy_from_slice(&part.as_flattened()[..shape.columns]);
        }
    }
}

struct SubtractProduct<'a> {
    panels: &'a Panels,
    k: &'a [f64],
    x: &'a [f64],
    r: &'a mut [f64],
    parts: (&'a mut [Quad], &'a mut [Quad]),
}

impl NullaryFnOnce for SubtractProduct<'_> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        for (at, panel) in self.panels.panels.iter().enumerate() {
            let (shape, runs) = (panel.shape(), self.panels.runs(at));
            let k = self.k[panel.values()].as_chunks().0;
            let (part, product) = (&mut self.parts.0[..shape.height], &mut self.parts.1[..shape.height]);
            gather(part, panel, runs, self.x);
            product.fill([0.0; LANES]);
            match shape {
                Shape { columns: 12, height: 6 } => {
                    dense::multiply(Shape { columns: 12, height: 6 }, k, part, product);
                }
                shape => dense::multiply(shape, k, part, product),
            }
            let (own, below) = product.split_at(shape.own());
            let subtract = |r: &mut [f64], y: &[f64]| r.iter_mut().zip(y).for_each(|(r, y)| *r -= y);
            subtract(&mut self.r[panel.own()], own.as_flattened());
            let mut below = below.as_flattened();
            for run in runs {
                subtract(&mut self.r[run.positions()], below);
                below = &below[run.length as usize..];
            }
        }
    }
}
