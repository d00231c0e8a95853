//! Frontal matrix of a supernode: dense columns of full height, first its own, then those of the quads of rows below.
//!
//! The functions are called within [`pulp::Arch::dispatch`] and are therefore inlined.

use super::quads::keep_quads;
use crate::sparse::{QUAD, Quad, RowRun, SupernodeShape};

/// Initialises a front with the entries of K.
#[inline(always)]
pub(crate) fn fill(shape: SupernodeShape, front: &mut [Quad], k: &[Quad]) {
    for (j, column) in front.chunks_exact_mut(shape.height).enumerate() {
        if j < shape.columns {
            column[j / QUAD..].copy_from_slice(&k[shape.column(j)]);
        } else {
            column[shape.own() + (j - shape.columns) / QUAD..].fill([0.0; QUAD]);
        }
    }
}

/// Adds the update matrix of a child (extend-add).
#[inline(always)]
pub(crate) fn extend_add(
    shape: SupernodeShape,
    front: &mut [Quad],
    runs: &[RowRun],
    form: SupernodeShape,
    update: &[Quad],
) {
    match runs {
        [run] if (run.parent_row as usize).is_multiple_of(QUAD) => {
            extend_add_run(shape, front, run, form, update);
        }
        runs => extend_add_runs(shape, front, runs, form, update),
    }
}

/// Returns the column of a front for a row.
#[inline(always)]
fn column_of(shape: SupernodeShape, row: usize) -> usize {
    if row < shape.columns { row } else { shape.columns + row - QUAD * shape.own() }
}

/// Adds the update matrix of a child whose rows are consecutive and start with a quad.
#[inline(always)]
fn extend_add_run(
    shape: SupernodeShape,
    front: &mut [Quad],
    run: &RowRun,
    form: SupernodeShape,
    update: &[Quad],
) {
    let (parent_row, first) = (run.parent_row as usize / QUAD, column_of(shape, run.parent_row as usize));
    for c in 0..run.length as usize {
        let four = c / QUAD;
        let column = &mut front[(first + c) * shape.height..(first + c + 1) * shape.height];
        for (x, y) in column[parent_row + four..].iter_mut().zip(&update[form.column(c)]) {
            (0..QUAD).for_each(|lane| x[lane] += y[lane]);
            keep_quads();
        }
    }
}

/// Adds the update matrix of a child run by run.
#[inline(always)]
fn extend_add_runs(
    shape: SupernodeShape,
    front: &mut [Quad],
    runs: &[RowRun],
    form: SupernodeShape,
    update: &[Quad],
) {
    let mut c = 0;
    for (i, run) in runs.iter().enumerate() {
        for column in run.parent_row..run.parent_row + run.length {
            let from = column_of(shape, column as usize) * shape.height;
            let target = front[from..from + shape.height].as_flattened_mut();
            let mut source = &update[form.column(c)].as_flattened()[c % QUAD..];
            let mut add = |parent_row: u32, length: u32| {
                let (rows, rest) = source.split_at(length as usize);
                target[parent_row as usize..].iter_mut().zip(rows).for_each(|(x, y)| *x += y);
                source = rest;
            };
            add(column, run.parent_row + run.length - column);
            runs[i + 1..].iter().for_each(|rows| add(rows.parent_row, rows.length));
            c += 1;
        }
    }
}
