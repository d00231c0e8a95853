use super::factorisation::SingularMatrix;
use crate::vectors::{dot, norm};

/// Largest number of GMRES iterations.
const ITERATIONS: usize = 60;
/// Residual at which they end, relative to the right-hand side.
const TOLERANCE: f64 = 1e-10;

/// Solution with the factors of K: replaces f by K⁻¹ f.
type Solve<'a> = &'a mut dyn FnMut(&mut [f64]) -> Result<(), SingularMatrix>;

/// Solves (K + A) z = f for a skew part A of the stiffness, with solutions by the factors of K. `z` is f on entry. Returns true if the
/// iteration converged; else z is its last iterate.
///
/// `entries` are the lower entries of A. With the coordinates p of A and S = A_pp,
///
/// (I + (K⁻¹)_pp S) z_p = (K⁻¹ f)_p,   z = K⁻¹ f − (K⁻¹)_p S z_p.
///
/// The equations of z_p are solved by GMRES, in at most as many iterations as there are coordinates p.
///
/// # Errors
/// If `solve` fails.
///
/// Source: Saad & Schultz (1986).
pub(crate) fn solve_with_skew_part(
    entries: &[(usize, usize, f64)],
    z: &mut [f64],
    solve: Solve<'_>,
) -> Result<bool, SingularMatrix> {
    solve(z)?;
    let mut places: Vec<usize> = entries.iter().flat_map(|&(i, j, _)| [i, j]).collect();
    places.sort_unstable();
    places.dedup();
    let at = |coordinate: usize| places.partition_point(|place| *place < coordinate);
    let picked = |z: &[f64]| -> Vec<f64> { places.iter().map(|place| z[*place]).collect() };
    let size = z.len();
    let mut image = |y: &[f64]| {
        let mut x = vec![0.0; size];
        for &(i, j, value) in entries {
            x[i] += value * y[at(j)];
            x[j] -= value * y[at(i)];
        }
        solve(&mut x).map(|()| x)
    };
    let target = picked(z);
    let length = norm(&target);
    if length == 0.0 {
        return Ok(true);
    }
    let mut basis: Vec<Vec<f64>> = vec![scaled(&target, 1.0 / length)];
    let mut projection = Projection { columns: Vec::new(), rotations: Vec::new(), right: vec![length] };
    for k in 0..ITERATIONS.min(places.len()) {
        let mut next = picked(&image(&basis[k])?);
        add(&mut next, 1.0, &basis[k]);
        let mut column = vec![0.0; k + 2];
        // Gram-Schmidt, twice against rounding errors.
        for _ in 0..2 {
            for (own, entry) in basis.iter().zip(&mut column) {
                let part = dot(own, &next);
                *entry += part;
                add(&mut next, -part, own);
            }
        }
        column[k + 1] = norm(&next);
        let rest = column[k + 1];
        projection.push(column);
        if projection.residual() <= TOLERANCE * length || rest == 0.0 {
            break;
        }
        basis.push(scaled(&next, 1.0 / rest));
    }
    let mut y = vec![0.0; places.len()];
    for (own, weight) in basis.iter().zip(projection.solution()) {
        add(&mut y, weight, own);
    }
    add(z, -1.0, &image(&y)?);
    Ok(projection.residual() <= TOLERANCE * length)
}

/// Adds A x for a skew matrix A with the given lower entries.
pub fn add_skew_product(entries: &[(usize, usize, f64)], x: &[f64], product: &mut [f64]) {
    for &(i, j, value) in entries {
        product[i] += value * x[j];
        product[j] -= value * x[i];
    }
}

fn scaled(x: &[f64], factor: f64) -> Vec<f64> {
    x.iter().map(|x| factor * x).collect()
}

fn add(sum: &mut [f64], factor: f64, x: &[f64]) {
    sum.iter_mut().zip(x).for_each(|(sum, x)| *sum += factor * x);
}

/// Least squares of the Hessenberg matrix of a Krylov space, by Givens rotations.
struct Projection {
    /// Columns of the triangular factor.
    columns: Vec<Vec<f64>>,
    /// Cosine and sine of each rotation.
    rotations: Vec<[f64; 2]>,
    right: Vec<f64>,
}

impl Projection {
    /// Adds a column of the matrix.
    fn push(&mut self, mut column: Vec<f64>) {
        let rotate = |[c, s]: [f64; 2], [x, y]: [f64; 2]| [c * x + s * y, c * y - s * x];
        for (i, rotation) in self.rotations.iter().enumerate() {
            [column[i], column[i + 1]] = rotate(*rotation, [column[i], column[i + 1]]);
        }
        let k = self.columns.len();
        let size = column[k].hypot(column[k + 1]);
        let rotation = if size > 0.0 { [column[k] / size, column[k + 1] / size] } else { [1.0, 0.0] };
        column[k] = size;
        let [own, next] = rotate(rotation, [self.right[k], 0.0]);
        self.right[k] = own;
        self.right.push(next);
        self.rotations.push(rotation);
        self.columns.push(column);
    }

    /// Returns the norm of the residual.
    fn residual(&self) -> f64 {
        self.right.last().map_or(0.0, |last| last.abs())
    }

    /// Returns the weights of the basis with the least residual. A column without a pivot has none.
    fn solution(&self) -> Vec<f64> {
        let mut weights = self.right.clone();
        for (k, column) in self.columns.iter().enumerate().rev() {
            weights[k] = if column[k] > 0.0 { weights[k] / column[k] } else { 0.0 };
            let weight = weights[k];
            weights[..k].iter_mut().zip(column).for_each(|(other, entry)| *other -= weight * entry);
        }
        weights.truncate(self.columns.len());
        weights
    }
}
