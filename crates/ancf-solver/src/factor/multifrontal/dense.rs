//! Dense kernels for supernodes in quads. They are called within [`pulp::Arch::dispatch`] and are therefore inlined.

use std::ops::Range;

use super::quads::{add_product, add_products, keep_quads, mul_add, quotient};
use crate::sparse::{QUAD, Quad, SupernodeShape};

#[inline(always)]
fn sum(x: &Quad) -> f64 {
    (x[0] + x[2]) + (x[1] + x[3])
}

/// Factorises the columns of a supernode: A = L D Lᵀ for its own rows, L for the rows below.
///
/// In `front`, whose columns have full height, the result is L D. `l` receives L, zero on and above the diagonal, and
/// `inverse` receives D⁻¹. Returns true if all pivots and their inverses are finite and above their rounding error. The
/// rounding error is relative to the largest subtracted number, recorded in `sizes` (quads of the own rows).
#[inline(always)]
pub(crate) fn eliminate(
    shape: SupernodeShape,
    front: &mut [Quad],
    l: &mut [Quad],
    inverse: &mut [f64],
    sizes: &mut [Quad],
) -> bool {
    sizes.fill([0.0; QUAD]);
    eliminate_quads::<2>(shape, 0..shape.own(), front, l, inverse, sizes)
}

/// Factorises some groups of four columns as in [`eliminate`], with earlier columns already subtracted. `N` quads of rows are
/// processed at once.
#[inline(always)]
pub(crate) fn eliminate_quads<const N: usize>(
    shape: SupernodeShape,
    fours: Range<usize>,
    front: &mut [Quad],
    l: &mut [Quad],
    inverse: &mut [f64],
    sizes: &mut [Quad],
) -> bool {
    let mut good = true;
    for four in fours.clone() {
        if four > fours.start {
            let columns = QUAD.min(shape.columns - QUAD * four);
            let mut row = four;
            while row + N <= shape.height {
                subtract_from_own::<N>(shape, front, l, fours.start..four, columns, row);
                row += N;
            }
            while row < shape.height {
                subtract_from_own::<1>(shape, front, l, fours.start..four, columns, row);
                row += 1;
            }
        }
        let (own, inverse) = (&mut l[shape.columns_of(four)], &mut inverse[QUAD * four..]);
        let front_of = &mut front[QUAD * four * shape.height..];
        good &= match shape.columns - QUAD * four {
            4.. => eliminate_columns::<4>(shape, four, front_of, own, inverse, sizes),
            3 => eliminate_columns::<3>(shape, four, front_of, own, inverse, sizes),
            2 => eliminate_columns::<2>(shape, four, front_of, own, inverse, sizes),
            _ => eliminate_columns::<1>(shape, four, front_of, own, inverse, sizes),
        };
    }
    good
}

/// Factorises up to four columns.
#[inline(always)]
fn eliminate_columns<const N: usize>(
    shape: SupernodeShape,
    four: usize,
    front: &mut [Quad],
    l: &mut [Quad],
    inverse: &mut [f64],
    sizes: &mut [Quad],
) -> bool {
    let (length, mut good) = (shape.height - four, true);
    let (front, l) = (columns_of::<N>(front, shape.height, four), columns_of::<N>(l, length, 0));
    let (mut pivots, mut by) = ([0.0; N], [0.0; N]);
    // Factors of each column with the previous columns, from the quad of the diagonal.
    let mut factors = [[0.0; QUAD]; N];
    let mut x = quads(&front, 0);
    for c in 0..N {
        for k in 0..c {
            let before = x[k];
            add_product(&mut x[c], -factors[k][c], &before);
        }
        pivots[c] = x[c][c];
        by[c] = 1.0 / pivots[c];
        let is_number = pivots[c].is_finite() && by[c].is_finite();
        good &= is_number && pivots[c].abs() >= f64::EPSILON * sizes[four][c];
        let quotient = quotient(&x[c], pivots[c], by[c]);
        for lane in 0..QUAD {
            factors[c][lane] = if lane > c { quotient[lane] } else { 0.0 };
        }
        raise(&mut sizes[four], &factors[c], &x[c]);
        l[c][0] = factors[c];
        front[c][0] = x[c];
    }
    inverse[..N].copy_from_slice(&by);
    for row in 1..length {
        let mut x = quads(&front, row);
        let own = sizes.get_mut(four + row);
        let mut size = own.as_deref().copied().unwrap_or_default();
        for c in 0..N {
            for k in 0..c {
                let before = x[k];
                add_product(&mut x[c], -factors[k][c], &before);
            }
            let quotient = quotient(&x[c], pivots[c], by[c]);
            l[c][row] = quotient;
            front[c][row] = x[c];
            raise(&mut size, &quotient, &x[c]);
        }
        if let Some(own) = own {
            *own = size;
        }
    }
    good
}

/// Returns the first columns of the given height, from a row on.
#[inline(always)]
fn columns_of<const N: usize>(values: &mut [Quad], height: usize, row: usize) -> [&mut [Quad]; N] {
    let mut columns: [&mut [Quad]; N] = std::array::from_fn(|_| <&mut [Quad]>::default());
    for (column, values) in columns.iter_mut().zip(values.chunks_exact_mut(height)) {
        *column = &mut values[row..];
    }
    columns
}

/// Returns a quad of each column.
#[inline(always)]
fn quads<const N: usize>(columns: &[&mut [Quad]; N], row: usize) -> [Quad; N] {
    let mut quads = [[0.0; QUAD]; N];
    for c in 0..N {
        quads[c] = columns[c][row];
    }
    quads
}

/// Raises sizes to the magnitudes of a product.
#[inline(always)]
fn raise(sizes: &mut Quad, x: &Quad, y: &Quad) {
    for lane in 0..QUAD {
        let size = (x[lane] * y[lane]).abs();
        sizes[lane] = if size > sizes[lane] { size } else { sizes[lane] };
    }
}

/// Subtracts the products of four columns from some quads of rows of four columns.
///
/// The product is L D of the rows times L of the columns, which is in the quad of rows `at`.
#[inline(always)]
fn subtract<const N: usize>(
    shape: SupernodeShape,
    front: &[Quad],
    l: &[Quad],
    four: usize,
    at: usize,
    row: usize,
    sums: &mut [[Quad; N]; QUAD],
) {
    let length = shape.height - four;
    let l = &l[shape.columns_of(four)];
    for k in 0..QUAD.min(shape.columns - QUAD * four) {
        let factors = l[k * length + at - four];
        let from = (QUAD * four + k) * shape.height + row;
        let rows = &front[from..from + N];
        for c in 0..QUAD {
            for n in 0..N {
                add_product(&mut sums[c][n], -factors[c], &rows[n]);
            }
        }
    }
}

/// Subtracts the products of earlier groups of columns from some quads of rows of the next group.
#[inline(always)]
fn subtract_from_own<const N: usize>(
    shape: SupernodeShape,
    front: &mut [Quad],
    l: &[Quad],
    earlier: Range<usize>,
    columns: usize,
    row: usize,
) {
    let later = earlier.end;
    let mut sums = [[[0.0; QUAD]; N]; QUAD];
    let place = |c: usize| (QUAD * later + c) * shape.height + row;
    for c in 0..columns {
        sums[c].copy_from_slice(&front[place(c)..place(c) + N]);
    }
    for four in earlier {
        subtract(shape, front, l, four, later, row, &mut sums);
    }
    for c in 0..columns {
        front[place(c)..place(c) + N].copy_from_slice(&sums[c]);
    }
}

/// Computes the update matrix of a factorised supernode: A − L D Lᵀ of the rows below.
#[inline(always)]
pub(crate) fn update(shape: SupernodeShape, front: &[Quad], l: &[Quad], update: &mut [Quad]) {
    let (own, below) = (shape.own(), shape.below());
    let mut update = update;
    for four in 0..below {
        let (columns, rest) = update.split_at_mut(QUAD * (below - four));
        update = rest;
        let mut row = own + four;
        while row + 2 <= shape.height {
            update_columns::<2>(shape, front, l, columns, own + four, row);
            row += 2;
        }
        if row < shape.height {
            update_columns::<1>(shape, front, l, columns, own + four, row);
        }
    }
}

/// Computes four columns and some quads of rows of the update matrix.
#[inline(always)]
fn update_columns<const N: usize>(
    shape: SupernodeShape,
    front: &[Quad],
    l: &[Quad],
    update: &mut [Quad],
    at: usize,
    row: usize,
) {
    let mut sums = [[[0.0; QUAD]; N]; QUAD];
    for c in 0..QUAD {
        let from = (shape.columns + QUAD * (at - shape.own()) + c) * shape.height + row;
        sums[c].copy_from_slice(&front[from..from + N]);
    }
    for four in 0..shape.own() {
        subtract(shape, front, l, four, at, row, &mut sums);
    }
    let length = shape.height - at;
    for c in 0..QUAD {
        let to = c * length + row - at;
        update[to..to + N].copy_from_slice(&sums[c]);
    }
}

/// Solves L y = x for the own rows and updates the rows below; x has full height.
#[inline(always)]
pub(crate) fn forward(shape: SupernodeShape, l: &[Quad], x: &mut [Quad]) {
    for four in 0..shape.own() {
        let (length, l, x) = (shape.height - four, &l[shape.columns_of(four)], &mut x[four..shape.height]);
        match shape.columns - QUAD * four {
            4.. => forward_columns::<4>(length, l, x),
            3 => forward_columns::<3>(length, l, x),
            2 => forward_columns::<2>(length, l, x),
            _ => forward_columns::<1>(length, l, x),
        }
    }
}

#[inline(always)]
fn forward_columns<const N: usize>(length: usize, l: &[Quad], x: &mut [Quad]) {
    let columns: [&[Quad]; N] = std::array::from_fn(|c| &l[c * length..(c + 1) * length]);
    let mut own = x[0];
    for c in 0..N {
        let s = own[c];
        add_product(&mut own, -s, &columns[c][0]);
    }
    x[0] = own;
    for q in 1..length {
        let mut rows = x[q];
        for c in 0..N {
            add_product(&mut rows, -own[c], &columns[c][q]);
        }
        x[q] = rows;
        keep_quads();
    }
}

/// Solves Lᵀ y = x for the own rows with known rows below; x has full height.
#[inline(always)]
pub(crate) fn backward(shape: SupernodeShape, l: &[Quad], x: &mut [Quad]) {
    for four in (0..shape.own()).rev() {
        let (length, l, x) = (shape.height - four, &l[shape.columns_of(four)], &mut x[four..shape.height]);
        match shape.columns - QUAD * four {
            4.. => backward_columns::<4>(length, l, x),
            3 => backward_columns::<3>(length, l, x),
            2 => backward_columns::<2>(length, l, x),
            _ => backward_columns::<1>(length, l, x),
        }
    }
}

#[inline(always)]
fn backward_columns<const N: usize>(length: usize, l: &[Quad], x: &mut [Quad]) {
    let columns: [&[Quad]; N] = std::array::from_fn(|c| &l[c * length..(c + 1) * length]);
    let mut sums = [[0.0; QUAD]; N];
    for q in 1..length {
        for c in 0..N {
            add_products(&mut sums[c], &columns[c][q], &x[q]);
        }
        keep_quads();
    }
    let mut own = x[0];
    for c in (0..N).rev() {
        let mut rest = own[c] - sum(&sums[c]);
        for i in c + 1..N {
            rest = mul_add(-columns[c][0][i], own[i], rest);
        }
        own[c] = rest;
    }
    x[0] = own;
}

/// Adds A x of a symmetric supernode to y; x and y have full height.
#[inline(always)]
pub(crate) fn multiply(shape: SupernodeShape, a: &[Quad], x: &[Quad], y: &mut [Quad]) {
    for four in 0..shape.own() {
        let (length, a) = (shape.height - four, &a[shape.columns_of(four)]);
        let (x, y) = (&x[four..shape.height], &mut y[four..shape.height]);
        match shape.columns - QUAD * four {
            4.. => multiply_columns::<4>(length, a, x, y),
            3 => multiply_columns::<3>(length, a, x, y),
            2 => multiply_columns::<2>(length, a, x, y),
            _ => multiply_columns::<1>(length, a, x, y),
        }
    }
}

#[inline(always)]
fn multiply_columns<const N: usize>(length: usize, a: &[Quad], x: &[Quad], y: &mut [Quad]) {
    let columns: [&[Quad]; N] = std::array::from_fn(|c| &a[c * length..(c + 1) * length]);
    let (own, mut sums) = (x[0], [[0.0; QUAD]; N]);
    for q in 1..length {
        let mut rows = y[q];
        for c in 0..N {
            add_product(&mut rows, own[c], &columns[c][q]);
            add_products(&mut sums[c], &columns[c][q], &x[q]);
        }
        y[q] = rows;
        keep_quads();
    }
    for c in 0..N {
        y[0][c] += sum(&sums[c]) + columns[c][0][c] * own[c];
        for i in c + 1..N {
            y[0][i] = mul_add(columns[c][0][i], own[c], y[0][i]);
            y[0][c] = mul_add(columns[c][0][i], own[i], y[0][c]);
        }
    }
}
