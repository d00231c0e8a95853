use nalgebra::{Cholesky, DMatrix};

/// Largest pivot of a dependent row, relative to the largest entry of the row at first.
const RANK: f64 = 1e-8;

/// Basis Z of the null space of a matrix G, orthonormal with respect to a mass matrix: G Z = 0, Zᵀ M Z = I.
///
/// Elimination with full pivoting determines the rank. `None` if Zᵀ M Z is not positive definite: a motion has no mass.
pub(super) fn null_space(g: &DMatrix<f64>, mass: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = g.ncols();
    let (reduced, pivots) = reduced_rows(g);
    let mut is_dependent = vec![false; n];
    pivots.iter().for_each(|&column| is_dependent[column] = true);
    let free: Vec<usize> = (0..n).filter(|&column| !is_dependent[column]).collect();
    let mut z = DMatrix::zeros(n, free.len());
    for (j, &column) in free.iter().enumerate() {
        z[(column, j)] = 1.0;
        for (row, &pivot) in pivots.iter().enumerate() {
            z[(pivot, j)] = -reduced[(row, column)];
        }
    }
    // Z L⁻ᵀ with L Lᵀ = Zᵀ M Z, repeated once against rounding.
    for _ in 0..2 {
        let gram = z.tr_mul(&(mass * &z));
        let lower = Cholesky::new((&gram + gram.transpose()) * 0.5)?.unpack();
        let mut transposed = z.transpose();
        if !lower.solve_lower_triangular_mut(&mut transposed) {
            return None;
        }
        z = transposed.transpose();
    }
    Some(z)
}

/// Reduced echelon form of the independent rows, and the column of the pivot of each.
fn reduced_rows(g: &DMatrix<f64>) -> (DMatrix<f64>, Vec<usize>) {
    let mut rows = g.clone();
    for mut row in rows.row_iter_mut() {
        let largest = row.amax();
        if largest > 0.0 {
            row /= largest;
        }
    }
    let (m, n) = rows.shape();
    let mut pivots = Vec::new();
    while pivots.len() < m.min(n) {
        let at = pivots.len();
        let rest = rows.view((at, 0), (m - at, n));
        let (row, column) = rest.iamax_full();
        if rest[(row, column)].abs() <= RANK {
            break;
        }
        rows.swap_rows(at, at + row);
        let pivot = rows[(at, column)];
        rows.row_mut(at).scale_mut(pivot.recip());
        let own = rows.row(at).into_owned();
        for other in (0..m).filter(|&other| other != at) {
            let factor = rows[(other, column)];
            if factor != 0.0 {
                rows.row_mut(other).zip_apply(&own, |x, own| *x -= factor * own);
            }
        }
        pivots.push(column);
    }
    (rows.rows(0, pivots.len()).into_owned(), pivots)
}
