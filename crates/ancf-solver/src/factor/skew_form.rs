use super::factorisation::{Factor, SingularMatrix};
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Number of motions on which the form is examined.
const EXAMINED: usize = 4;
/// Number of refinements of each motion. Coordinates that the constraints hold are rounding errors of all others before.
const REFINEMENTS: usize = 2;
/// Form yᵀ A w, relative to the sum of the absolute values of its terms, that is zero but for rounding errors.
const ROUNDING: f64 = 1e-11;
/// Form of coordinates that the constraints hold, relative to that of the largest coordinates.
const HELD: f64 = 1e-20;

/// Returns true if the constraints leave nothing of a skew part A of the stiffness: the form yᵀ A w is a rounding error for random
/// motions y and w that satisfy them. The loads then have a potential.
///
/// A pressure on a surface whose edges are held, or are in planes of symmetry, is an example. `entries` are the lower entries of A,
/// `factor` has the factors of a stiffness matrix over the coordinates and the multipliers after them.
///
/// # Errors
/// If the factors do not solve.
pub(crate) fn is_zero_on_motions(
    entries: &[(usize, usize, f64)],
    coordinates: usize,
    matrix: &SparseMatrix,
    factor: &mut Factor,
) -> Result<bool, SingularMatrix> {
    if entries.is_empty() {
        return Ok(true);
    }
    let mut random = PseudoRandom(31);
    let motion = |_| {
        let mut force = vec![0.0; matrix.pattern().size()];
        force[..coordinates].fill_with(|| random.number());
        let mut x = force.clone();
        factor.solve(matrix, &mut x)?;
        for _ in 0..REFINEMENTS {
            x = factor.refined(matrix, &force, &x)?;
        }
        Ok::<_, SingularMatrix>(x)
    };
    let motions = (0..EXAMINED).map(motion).collect::<Result<Vec<_>, _>>()?;
    let largest = |x: &[f64]| x[..coordinates].iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    let of_held = HELD * entries.iter().map(|(.., value)| value.abs()).sum::<f64>();
    let form = |y: &[f64], w: &[f64]| {
        let products = |&(i, j, value): &(usize, usize, f64)| [y[i] * value * w[j], -y[j] * value * w[i]];
        let terms = entries.iter().flat_map(products);
        terms.fold([0.0, 0.0], |[sum, size]: [f64; 2], term| [sum + term, size + term.abs()])
    };
    let mut pairs = motions.iter().enumerate().flat_map(|(k, y)| motions[..k].iter().map(move |w| (y, w)));
    Ok(pairs.all(|(y, w)| {
        let [sum, size] = form(y, w);
        sum.abs() <= ROUNDING * size + of_held * largest(y) * largest(w)
    }))
}
