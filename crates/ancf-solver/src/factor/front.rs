//! Frontal matrix of a supernode: dense columns of full height, first its own, then those of the quads of rows below.
//!
//! The functions are called within [`pulp::Arch::dispatch`] and are therefore inlined.

use crate::sparse::{LANES, Quad, Run, Shape};

/// Initialises a front with the entries of K.
#[inline(always)]
pub(crate) fn fill(shape: Shape, front: &mut [Quad], k: &[Quad]) {
    for (j, column) in front.chunks_exact_mut(shape.height).enumerate() {
        if j < shape.columns {
            column[j / LANES..].copy_from_slice(&k[shape.column(j)]);
        } else {
            column[shape.own() + (j - shape.columns) / LANES..].fill([0.0; LANES]);
        }
    }
}

/// Adds the update matrix of a child (extend-add).
#[inline(always)]
pub(crate) fn take_in(shape: Shape, front: &mut [Quad], runs: &[Run], form: Shape, update: &[Quad]) {
    match runs {
        [run] if (run.into as usize).is_multiple_of(LANES) => take_in_run(shape, front, run, form, update),
        runs => take_in_runs(shape, front, runs, form, update),
    }
}

/// Returns the column of a front for a row.
#[inline(always)]
fn column_of(shape: Shape, row: usize) -> usize {
    if row < shape.columns { row } else { shape.columns + row - LANES * shape.own() }
}

/// Adds the update matrix of a child whose rows are consecutive and start with a quad.
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

/// Adds the update matrix of a child run by run.
#[inline(always)]
fn take_in_runs(shape: Shape, front: &mut [Quad], runs: &[Run], form: Shape, update: &[Quad]) {
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
