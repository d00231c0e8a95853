use nalgebra::Matrix3;

/// Derivatives by up to N vectors of an element.
pub(super) type Blocks<const N: usize> = [[Matrix3<f64>; N]; N];

/// Skew entries of this size, relative to the derivative, are rounding errors.
const NEGLIGIBLE: f64 = 1e-13;

/// Returns an entry by its row and column.
pub(super) fn entry<const N: usize>(blocks: &Blocks<N>, row: usize, column: usize) -> f64 {
    blocks[row / 3][column / 3][(row % 3, column % 3)]
}

/// Calls `visit` with the row and the column of each entry of the lower triangle.
pub(super) fn each_entry(rows: usize, mut visit: impl FnMut(usize, usize)) {
    (0..rows).for_each(|row| (0..=row).for_each(|column| visit(row, column)));
}

/// Visits the lower entries of the skew part of a derivative.
pub(super) fn visit_skew<const N: usize>(
    blocks: &Blocks<N>,
    rows: usize,
    visit: &mut dyn FnMut(usize, usize, f64),
) {
    let largest = blocks.iter().flatten().map(Matrix3::amax).fold(0.0, f64::max);
    each_entry(rows, |row, column| {
        let value = 0.5 * (entry(blocks, row, column) - entry(blocks, column, row));
        if row > column && value.abs() > NEGLIGIBLE * largest {
            visit(row, column, value);
        }
    });
}
