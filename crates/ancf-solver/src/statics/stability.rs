use crate::equations::{EquationsOfMotion, State, System, Weights};
use crate::factor::{Factor, is_zero_on_motions, negative_eigenvalues};
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Iterations of the inverse iteration for the eigenvector of the eigenvalue nearest to zero.
const INVERSE_ITERATIONS: u32 = 12;

/// Returns the number of unstable directions of a state by the factors of its tangent stiffness: the negative eigenvalues on the motions
/// that the constraints permit.
///
/// It is `None` if the factors do not provide the inertia, and with loads without a potential, where an indefinite symmetric part does
/// not imply instability.
///
/// Source: Sylvester's law of inertia (1852), applied to the factors of [K, Φ_qᵀ; Φ_q, 0].
pub(crate) fn unstable_directions(
    eom: &dyn EquationsOfMotion,
    s: &State,
    matrix: &SparseMatrix,
    factor: &mut Factor,
) -> Option<usize> {
    let count = negative_eigenvalues(matrix, factor)?.checked_sub(eom.multipliers())?;
    let (skew, n) = (eom.skew_stiffness(s), eom.coordinates());
    let is_decided = count == 0 || is_zero_on_motions(&skew, n, matrix, factor).ok()?;
    is_decided.then_some(count)
}

/// Stability of a state by its tangent stiffness.
#[derive(Debug)]
pub struct Stability {
    matrix: SparseMatrix,
    factor: Factor,
    coordinates: usize,
    /// Number of unstable directions: the negative eigenvalues of the stiffness on the motions that the constraints permit.
    pub unstable: usize,
}

impl Stability {
    /// Counts the unstable directions of a state with all contacts that are active in it.
    ///
    /// It is `None` if the stiffness is singular or its factors do not provide the inertia, and with loads without a potential, where an
    /// indefinite symmetric part does not imply instability.
    pub fn new(system: &System, s: &State) -> Option<Self> {
        let complete = system.with_active_terms(s).map(|(complete, _)| complete);
        let system = complete.as_ref().unwrap_or(system);
        let mut matrix = system.matrix();
        system.tangent(s, Weights::STIFFNESS, &mut matrix);
        let mut factor = Factor::new(matrix.pattern()).ok()?;
        factor.factorise(&matrix).ok()?;
        let unstable = unstable_directions(system, s, &matrix, &mut factor)?;
        Some(Self { matrix, factor, coordinates: system.coordinates(), unstable })
    }

    /// Returns the direction nearest to neutral, by inverse iteration; `None` if the factors do not solve.
    pub fn neutral_direction(mut self) -> Option<Vec<f64>> {
        let mut x = PseudoRandom(17).vector(self.matrix.pattern().size());
        for _ in 0..INVERSE_ITERATIONS {
            x[self.coordinates..].fill(0.0);
            let largest = x.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            x.iter_mut().for_each(|x| *x /= largest);
            self.factor.solve(&self.matrix, &mut x).ok()?;
        }
        x.truncate(self.coordinates);
        Some(x)
    }
}
