use nalgebra::{DMatrix, DVector};

/// Largest number of GMRES iterations.
const ITERATIONS: usize = 60;
/// Residual at which they end, relative to the right-hand side.
const TOLERANCE: f64 = 1e-10;

/// Turns the solution z = K⁻¹ f into that of (K + A) z = f for a skew part A of the stiffness, with solutions by the factors of K.
/// Returns true if the iteration converged; else z is its last iterate.
///
/// `entries` are the lower entries of A, and `solve` computes K⁻¹. With the coordinates p of A and S = A_pp,
///
/// (I + (K⁻¹)_pp S) z_p = (K⁻¹ f)_p,   z = K⁻¹ f − (K⁻¹)_p S z_p.
///
/// The equations of z_p are solved by GMRES, in at most as many iterations as there are coordinates p.
///
/// # Errors
/// If `solve` fails.
///
/// Source: Saad & Schultz (1986).
pub(crate) fn include_skew_part<E>(
    entries: &[(usize, usize, f64)],
    z: &mut [f64],
    mut solve: impl FnMut(&mut [f64]) -> Result<(), E>,
) -> Result<bool, E> {
    let mut places: Vec<usize> = entries.iter().flat_map(|&(i, j, _)| [i, j]).collect();
    places.sort_unstable();
    places.dedup();
    let at = |coordinate: usize| places.partition_point(|place| *place < coordinate);
    let picked = |z: &[f64]| DVector::from_iterator(places.len(), places.iter().map(|place| z[*place]));
    let size = z.len();
    let mut image = |y: &DVector<f64>| {
        let mut x = vec![0.0; size];
        for &(i, j, value) in entries {
            x[i] += value * y[at(j)];
            x[j] -= value * y[at(i)];
        }
        solve(&mut x).map(|()| x)
    };
    let target = picked(z);
    let length = target.norm();
    if length == 0.0 {
        return Ok(true);
    }
    let mut basis = vec![target / length];
    let mut projection = DMatrix::zeros(1, 0);
    let (mut weights, mut is_solved) = (DVector::zeros(0), false);
    for k in 0..ITERATIONS.min(places.len()) {
        let mut next = &basis[k] + picked(&image(&basis[k])?);
        projection = projection.resize(k + 2, k + 1, 0.0);
        // Gram-Schmidt, twice against rounding errors.
        for _ in 0..2 {
            for (i, own) in basis.iter().enumerate() {
                let part = own.dot(&next);
                projection[(i, k)] += part;
                next.axpy(-part, own, 1.0);
            }
        }
        let rest = next.norm();
        projection[(k + 1, k)] = rest;
        let mut right = DVector::zeros(k + 2);
        right[0] = length;
        let factors = projection.clone().qr();
        let Some(found) = factors.r().solve_upper_triangular(&(factors.q().transpose() * &right)) else {
            break;
        };
        is_solved = (&projection * &found - right).norm() <= TOLERANCE * length;
        weights = found;
        if is_solved || rest == 0.0 {
            break;
        }
        basis.push(next / rest);
    }
    let y = basis.iter().zip(weights.iter()).map(|(own, weight)| own * *weight).sum::<DVector<f64>>();
    let correction = image(&y)?;
    z.iter_mut().zip(&correction).for_each(|(z, x)| *z -= x);
    Ok(is_solved)
}
