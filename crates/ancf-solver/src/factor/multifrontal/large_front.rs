//! Blocked elimination of large fronts: panels of columns, and matrix products for the remaining columns.

use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::{Accum, MatMut, MatRef, Par};

use super::dense;
use crate::sparse::{QUAD, Quad, SupernodeShape};

/// Height in quads from which fronts are blocked. Smaller ones remain in the cache.
const LARGE: usize = 32;
/// Number of quads of columns of a panel.
const PANEL: usize = 8;

/// Minimum number of columns of a block that a thread updates.
const BLOCK: usize = 128;

/// Number of quads of rows that are processed at once within a panel.
const ROWS: usize = 4;

/// Returns true if fronts of a shape are eliminated in blocks.
#[inline(always)]
pub(crate) fn is_large(shape: SupernodeShape) -> bool {
    shape.height >= LARGE
}

/// Returns the number of quads of working storage for fronts of a shape: the factor of a panel.
pub(crate) fn storage(shape: SupernodeShape) -> usize {
    if is_large(shape) { QUAD * PANEL.min(shape.own()) * shape.height } else { 0 }
}

/// Factorises the columns of a supernode and computes its update matrix. Arguments and result are those of
/// [`dense::eliminate`] and [`dense::update`].
#[inline(always)]
pub(crate) fn eliminate(
    shape: SupernodeShape,
    front: &mut [Quad],
    l: &mut [Quad],
    inverse: &mut [f64],
    sizes: &mut [Quad],
    panel: &mut [Quad],
    update: &mut [Quad],
) -> bool {
    let mut good = true;
    sizes.fill([0.0; QUAD]);
    for first in (0..shape.own()).step_by(PANEL) {
        let end = (first + PANEL).min(shape.own());
        good &= dense::eliminate_quads::<ROWS>(shape, first..end, front, l, inverse, sizes);
        let columns = QUAD * first..shape.columns.min(QUAD * end);
        let rows = shape.height - end;
        if rows == 0 {
            continue;
        }
        for (column, target) in columns.clone().zip(panel.chunks_exact_mut(rows)) {
            let own = shape.column(column);
            target.copy_from_slice(&l[own.end - rows..own.end]);
        }
        let (factorised, rest) = front.split_at_mut(columns.end * shape.height);
        let factorised = &factorised[columns.start * shape.height..];
        let panel = &panel[..columns.len() * rows];
        subtract_products(shape, [columns.end, end], factorised, panel, rest);
    }
    copy_update(shape, front, update);
    good
}

/// Subtracts the products of a panel from the later columns: L D in `factorised`, with full height, and L in `panel`.
///
/// The panel ends before the given column and quad of rows.
fn subtract_products(
    shape: SupernodeShape,
    [column, quad]: [usize; 2],
    factorised: &[Quad],
    panel: &[Quad],
    rest: &mut [Quad],
) {
    let (height, count) = (QUAD * shape.height, factorised.len() / shape.height);
    let (own, below) = (shape.columns - column, QUAD * shape.below());
    let ld = MatRef::from_column_major_slice(factorised.as_flattened(), height, count);
    let (ld, l) = (
        ld.subrows(QUAD * quad, height - QUAD * quad),
        MatRef::from_column_major_slice(panel.as_flattened(), height - QUAD * quad, count),
    );
    let (of_own, of_below) = rest.split_at_mut(own * shape.height);
    let skipped = ld.nrows() - below;
    let parts = [(of_own, own, QUAD * quad, 0), (of_below, below, QUAD * shape.own(), skipped)];
    for (part, columns, first_row, skipped) in parts.into_iter().filter(|(_, columns, ..)| *columns > 0) {
        let part = MatMut::from_column_major_slice_mut(
            &mut part.as_flattened_mut()[..columns * height],
            height,
            columns,
        );
        let part = part.subrows_mut(first_row, height - first_row);
        let (ld, l) = (ld.subrows(skipped, ld.nrows() - skipped), l.subrows(skipped, columns));
        subtract_product(part, ld, l);
    }
}

/// Subtracts the lower trapezoid of L D Lᵀ, in parallel blocks of columns. The blocks, and therefore the results, do not depend on
/// the number of threads.
fn subtract_product(part: MatMut<'_, f64>, ld: MatRef<'_, f64>, l: MatRef<'_, f64>) {
    let columns = part.ncols();
    if columns >= 2 * BLOCK {
        let middle = columns / 2;
        let (left, right) = part.split_at_col_mut(middle);
        let right = right.subrows_mut(middle, ld.nrows() - middle);
        let (l_left, l_right) = l.split_at_row(middle);
        let one = || subtract_product(left, ld, l_left);
        let other = || subtract_product(right, ld.subrows(middle, ld.nrows() - middle), l_right);
        if rayon::current_num_threads() > 1 {
            rayon::join(one, other);
        } else {
            one();
            other();
        }
        return;
    }
    let (triangle, rectangle) = part.split_at_row_mut(columns);
    let ((ld_triangle, ld_rectangle), l) = (ld.split_at_row(columns), l.transpose());
    triangular::matmul(
        triangle,
        BlockStructure::TriangularLower,
        Accum::Add,
        ld_triangle,
        BlockStructure::Rectangular,
        l,
        BlockStructure::Rectangular,
        -1.0,
        Par::Seq,
    );
    if rectangle.nrows() > 0 {
        matmul(rectangle, Accum::Add, ld_rectangle, l, -1.0, Par::Seq);
    }
}

/// Copies the update matrix from the columns of the rows below.
#[inline(always)]
fn copy_update(shape: SupernodeShape, front: &[Quad], update: &mut [Quad]) {
    let below = SupernodeShape { columns: QUAD * shape.below(), height: shape.below() };
    let columns = front[shape.columns * shape.height..].chunks_exact(shape.height);
    for (j, column) in columns.take(below.columns).enumerate() {
        update[below.column(j)].copy_from_slice(&column[shape.own() + j / QUAD..]);
    }
}
