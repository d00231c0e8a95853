//! Arithmetic on dense panels, in quads: to be called within [`pulp::Arch::dispatch`], hence all inline.

use super::panel::{LANES, Quad, Shape};

/// y += s x.
#[inline(always)]
fn add_product(y: &mut Quad, s: f64, x: &Quad) {
    for lane in 0..LANES {
        y[lane] = s.mul_add(x[lane], y[lane]);
    }
}

/// y += x ∘ z.
#[inline(always)]
fn add_products(y: &mut Quad, x: &Quad, z: &Quad) {
    for lane in 0..LANES {
        y[lane] = x[lane].mul_add(z[lane], y[lane]);
    }
}

#[inline(always)]
fn sum(x: &Quad) -> f64 {
    (x[0] + x[2]) + (x[1] + x[3])
}

/// Eliminates the columns of a panel from one another: A = L D Lᵀ for the own rows, L for those below.
///
/// In `front`, whose columns are of full height, they become L D; `l` becomes L, zero on and above the diagonal; `inverse`
/// D⁻¹. Returns whether all pivots are such: finite, their inverse too, and not just the rounding error of what was subtracted
/// from them, the largest part of which is kept in `sizes` (quads of its own rows).
#[inline(always)]
pub(super) fn eliminate(
    shape: Shape,
    front: &mut [Quad],
    l: &mut [Quad],
    inverse: &mut [f64],
    sizes: &mut [Quad],
) -> bool {
    let (height, columns) = (shape.height, shape.columns);
    let mut good = true;
    sizes.fill([0.0; LANES]);
    for k in 0..columns {
        let (before, after) = front.split_at_mut((k + 1) * height);
        let four = k / LANES;
        let pivots = &before[k * height + four..];
        let pivot = pivots[0][k % LANES];
        let by = 1.0 / pivot;
        good &= pivot.is_finite() && by.is_finite() && pivot.abs() >= f64::EPSILON * sizes[four][k % LANES];
        inverse[k] = by;
        let column = &mut l[shape.column(k)];
        for (l, x) in column.iter_mut().zip(pivots) {
            for lane in 0..LANES {
                // What a division gives: rows that are equal stay equal, and their difference zero (Markstein 1990).
                let near = by * x[lane];
                l[lane] = (-near).mul_add(pivot, x[lane]).mul_add(by, near);
            }
        }
        for lane in 0..LANES {
            column[0][lane] = if lane > k % LANES { column[0][lane] } else { 0.0 };
        }
        for ((size, l), x) in sizes[four..].iter_mut().zip(&*column).zip(pivots) {
            for lane in 0..LANES {
                let part = (l[lane] * x[lane]).abs();
                size[lane] = if part > size[lane] { part } else { size[lane] };
            }
        }
        for (j, target) in (k + 1..columns).zip(after.chunks_exact_mut(height)) {
            let s = -column[j / LANES - four][j % LANES];
            for (y, x) in target[j / LANES..].iter_mut().zip(&pivots[j / LANES - four..]) {
                add_product(y, s, x);
            }
        }
    }
    good
}

/// What an eliminated panel leaves to later ones: A − L D Lᵀ of the rows below.
#[inline(always)]
pub(super) fn update(shape: Shape, front: &[Quad], l: &[Quad], update: &mut [Quad]) {
    let below = shape.below();
    let mut update = update;
    for four in 0..below {
        let (own, rest) = update.split_at_mut(LANES * (below - four));
        update = rest;
        let mut row = four;
        while row + 2 <= below {
            tile::<2>(shape, front, l, own, four, row);
            row += 2;
        }
        if row < below {
            tile::<1>(shape, front, l, own, four, row);
        }
    }
}

/// Four columns and some quads of rows of it.
#[inline(always)]
fn tile<const N: usize>(
    shape: Shape,
    front: &[Quad],
    l: &[Quad],
    update: &mut [Quad],
    four: usize,
    row: usize,
) {
    let (own, height, columns) = (shape.own(), shape.height, shape.columns);
    let mut sums = [[[0.0; LANES]; N]; LANES];
    for (c, sums) in sums.iter_mut().enumerate() {
        let from = (columns + LANES * four + c) * height + own + row;
        sums.copy_from_slice(&front[from..from + N]);
    }
    for k in 0..columns {
        let factors = l[shape.column(k).start + own + four - k / LANES];
        let from = k * height + own + row;
        let rows: [Quad; N] = std::array::from_fn(|n| front[from + n]);
        for c in 0..LANES {
            for n in 0..N {
                add_product(&mut sums[c][n], -factors[c], &rows[n]);
            }
        }
    }
    let length = shape.below() - four;
    for (c, sums) in sums.iter().enumerate() {
        let to = c * length + row - four;
        update[to..to + N].copy_from_slice(sums);
    }
}

/// Solves L y = x for the own rows and takes what they make of those below: x is of full height.
#[inline(always)]
pub(super) fn forward(shape: Shape, l: &[Quad], x: &mut [Quad]) {
    fours(shape, l, |from, columns, length, l| {
        let x = &mut x[from..from + length];
        match columns {
            4 => forward_columns::<4>(length, l, x),
            3 => forward_columns::<3>(length, l, x),
            2 => forward_columns::<2>(length, l, x),
            _ => forward_columns::<1>(length, l, x),
        }
    });
}

/// Calls for each four columns: the first quad, the number of columns, their height and their values.
#[inline(always)]
fn fours(shape: Shape, values: &[Quad], mut work: impl FnMut(usize, usize, usize, &[Quad])) {
    for four in 0..shape.own() {
        let columns = LANES.min(shape.columns - LANES * four);
        let (start, length) = (shape.column(LANES * four).start, shape.height - four);
        work(four, columns, length, &values[start..start + columns * length]);
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
    }
}

/// Solves Lᵀ y = x for the own rows, those below being known: x is of full height.
#[inline(always)]
pub(super) fn backward(shape: Shape, l: &[Quad], x: &mut [Quad]) {
    for four in (0..shape.own()).rev() {
        let columns = LANES.min(shape.columns - LANES * four);
        let (start, length) = (shape.column(LANES * four).start, shape.height - four);
        let (l, x) = (&l[start..start + columns * length], &mut x[four..four + length]);
        match columns {
            4 => backward_columns::<4>(length, l, x),
            3 => backward_columns::<3>(length, l, x),
            2 => backward_columns::<2>(length, l, x),
            _ => backward_columns::<1>(length, l, x),
        }
    }
}

#[inline(always)]
fn backward_columns<const N: usize>(length: usize, l: &[Quad], x: &mut [Quad]) {
    let columns: [&[Quad]; N] = std::array::from_fn(|c| &l[c * length..(c + 1) * length]);
    let mut sums = [[0.0; LANES]; N];
    for q in 1..length {
        for c in 0..N {
            add_products(&mut sums[c], &columns[c][q], &x[q]);
        }
    }
    let mut own = x[0];
    for c in (0..N).rev() {
        let mut rest = own[c] - sum(&sums[c]);
        for i in c + 1..N {
            rest = (-columns[c][0][i]).mul_add(own[i], rest);
        }
        own[c] = rest;
    }
    x[0] = own;
}

/// y += A x of a symmetric panel: x and y are of full height.
#[inline(always)]
pub(super) fn multiply(shape: Shape, a: &[Quad], x: &[Quad], y: &mut [Quad]) {
    fours(shape, a, |from, columns, length, a| {
        let (x, y) = (&x[from..from + length], &mut y[from..from + length]);
        match columns {
            4 => multiply_columns::<4>(length, a, x, y),
            3 => multiply_columns::<3>(length, a, x, y),
            2 => multiply_columns::<2>(length, a, x, y),
            _ => multiply_columns::<1>(length, a, x, y),
        }
    });
}

#[inline(always)]
fn multiply_columns<const N: usize>(length: usize, a: &[Quad], x: &[Quad], y: &mut [Quad]) {
    let columns: [&[Quad]; N] = std::array::from_fn(|c| &a[c * length..(c + 1) * length]);
    let (own, mut sums) = (x[0], [[0.0; LANES]; N]);
    for q in 1..length {
        let mut rows = y[q];
        for c in 0..N {
            add_product(&mut rows, own[c], &columns[c][q]);
            add_products(&mut sums[c], &columns[c][q], &x[q]);
        }
        y[q] = rows;
    }
    for c in 0..N {
        y[0][c] += sum(&sums[c]) + columns[c][0][c] * own[c];
        for i in c + 1..N {
            y[0][i] = columns[c][0][i].mul_add(own[c], y[0][i]);
            y[0][c] = columns[c][0][i].mul_add(own[i], y[0][c]);
        }
    }
}
