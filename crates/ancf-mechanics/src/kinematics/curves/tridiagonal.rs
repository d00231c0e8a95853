use nalgebra::Vector3;

/// Row of a tridiagonal system with a vector as its right-hand side.
#[derive(Clone, Copy, Debug)]
pub struct TridiagonalRow {
    /// Coefficient of the unknown before.
    pub lower: f64,
    /// Coefficient of the own unknown.
    pub diagonal: f64,
    /// Coefficient of the next unknown.
    pub upper: f64,
    /// Right-hand side.
    pub right: Vector3<f64>,
}

/// Solves a tridiagonal system by elimination without pivoting.
///
/// The pivots of the systems of splines are positive.
pub fn solve_tridiagonal(mut rows: Vec<TridiagonalRow>) -> Vec<Vector3<f64>> {
    for i in 1..rows.len() {
        let before = rows[i - 1];
        let factor = rows[i].lower / before.diagonal;
        rows[i].diagonal -= factor * before.upper;
        rows[i].right -= before.right * factor;
    }
    let mut next = Vector3::zeros();
    for row in rows.iter_mut().rev() {
        next = (row.right - next * row.upper) / row.diagonal;
        row.right = next;
    }
    rows.into_iter().map(|row| row.right).collect()
}

/// Solves a system of at least three unknowns whose first row has its lower coefficient in the last column, and whose last row has its
/// upper coefficient in the first column.
///
/// Source: Sherman & Morrison (1950), for the two corners.
pub fn solve_cyclic_tridiagonal(mut rows: Vec<TridiagonalRow>) -> Vec<Vector3<f64>> {
    let last = rows.len() - 1;
    let (corners, pivot) = ([rows[0].lower, rows[last].upper], -rows[0].diagonal);
    rows[0].diagonal -= pivot;
    rows[last].diagonal -= corners[0] * corners[1] / pivot;
    let mut columns = rows.clone();
    columns.iter_mut().for_each(|row| row.right = Vector3::zeros());
    (columns[0].right.x, columns[last].right.x) = (pivot, corners[1]);
    let (mut solution, column) = (solve_tridiagonal(rows), solve_tridiagonal(columns));
    let factor = corners[0] / pivot;
    let part = (solution[0] + solution[last] * factor) / (1.0 + column[0].x + column[last].x * factor);
    solution.iter_mut().zip(column).for_each(|(x, column)| *x -= part * column.x);
    solution
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A x of a solution is the right-hand side.
    #[test]
    fn solutions_satisfy_the_equations() {
        let row = |i: usize| {
            let x = i as f64;
            let right = Vector3::new(1.0 + x, 2.0 - x * x, (3.0 * x).sin());
            TridiagonalRow {
                lower: 1.0 + 0.1 * x,
                diagonal: 5.0 + (7.0 * x).cos(),
                upper: 2.0 - 0.2 * x,
                right,
            }
        };
        for n in [3, 4, 9] {
            let rows: Vec<_> = (0..n).map(row).collect();
            for is_cyclic in [false, true] {
                let solve = if is_cyclic { solve_cyclic_tridiagonal } else { solve_tridiagonal };
                let x = solve(rows.clone());
                for (i, row) in rows.iter().enumerate() {
                    let [has_lower, has_upper] =
                        [is_cyclic || i > 0, is_cyclic || i + 1 < n].map(|has| f64::from(u8::from(has)));
                    let found = x[(i + n - 1) % n] * (row.lower * has_lower)
                        + x[i] * row.diagonal
                        + x[(i + 1) % n] * (row.upper * has_upper);
                    assert!((found - row.right).norm() < 1e-12, "{n}, {is_cyclic}, row {i}: {found}");
                }
            }
        }
    }
}
