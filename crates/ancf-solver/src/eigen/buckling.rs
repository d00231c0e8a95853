use nalgebra::DVector;

use super::krylov::{EigenError, EigenSearch, Operator, krylov};
use super::modes::modes;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::Factor;
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Critical load factor with its buckling shape.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalLoad {
    /// Critical factor s of the loads at load factor one, in addition to the loads already applied in the state.
    pub factor: f64,
    /// Buckling shape x over the coordinates with xᵀ M x = 1.
    pub shape: Vec<f64>,
}

/// Direction of the loads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadDirection {
    /// Stated direction: s > 0.
    #[default]
    Stated,
    /// Reversed direction: s < 0.
    Reversed,
    /// Both directions, by increasing magnitude.
    Either,
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-7;
/// Number of block vectors in addition to the requested factors.
const GUARD: usize = 4;
/// Number of blocks per Krylov space.
const DEPTH: usize = 16;
/// Maximum number of restarts.
const PASSES: usize = 8;
/// Smallest significant eigenvalue 1/s, relative to the largest. Smaller ones belong to unloaded parts.
const MIN_EIGENVALUE: f64 = 1e-6;
/// Smallest significant work of the loads, relative to the sum of their work on isolated coordinates.
const MIN_WORK: f64 = 1e-12;

/// Computes the `count` lowest critical load factors of a stable equilibrium by linear buckling analysis:
/// K₀ x + Φ_qᵀ μ = −s K_g x, Φ_q x = 0.
///
/// K_g is the stiffness of the stresses and multipliers that the loads at load factor one cause in first order,
/// [K₀, Φ_qᵀ; Φ_q, 0] (q₁, λ₁) = −∂r/∂(load factor), at the configuration of the state
/// ([`EquationsOfMotion::stress_stiffness`]).
///
/// The reference configuration is an equilibrium at load factor zero. There the analysis is the classical theory, which
/// neglects prebuckling deformation. It gives Euler's load of a column except for P/EA, and the loads of Prandtl and
/// Michell for lateral buckling of a strip. In-plane bending before buckling raises the load of such a strip by about
/// 1/√((1 − EI₂/EI₁)(1 − GJ/EI₁)) if both ratios are small.
///
/// For an equilibrium under load, K₀ includes the displacement so far. The remaining factor is zero where the nonlinear
/// path is critical. [`ArcLength`](crate::statics::ArcLength) finds that point by the negative pivots of K.
///
/// Returns fewer than `count` factors if the loads have no more in this direction. `matrix` is any matrix of the
/// pattern of `eom`.
///
/// Source: Bathe (2014), section 6.8.2, with stresses of first order only; Timoshenko & Gere (1961), chapters 2, 6;
/// Trahair & Woolcock (1973). The largest 1/s of −K₀⁻¹ K_g, self-adjoint in the inner product of K₀, are found by block
/// Krylov spaces.
///
/// # Errors
/// If K₀ is singular or not positive definite, the loads have no potential, the iteration does not converge, or it is
/// interrupted.
pub fn buckling(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    sense: LoadDirection,
    interrupt: &Interrupt,
) -> Result<Vec<CriticalLoad>, EigenError> {
    let lowest = modes(eom, matrix.clone(), s, 1, interrupt)?.modes;
    match lowest.first().map(|mode| mode.omega_squared) {
        None => return Ok(Vec::new()),
        Some(0.0) => return Err(EigenError::Singular),
        Some(squared) if squared < 0.0 => return Err(EigenError::Indefinite),
        Some(_) => {}
    }
    if !eom.skew_stiffness(&State { load: 1.0, ..s.clone() }).is_empty() {
        return Err(EigenError::Nonconservative);
    }
    let (mut stiffness, n) = (matrix.clone(), eom.coordinates());
    eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
    let mut factor = Factor::new(matrix.pattern())?;
    factor.factorise(&stiffness)?;
    let Some(increment) = first_order(eom, s, &stiffness, &mut factor)? else { return Ok(Vec::new()) };
    let mut softening = matrix.clone();
    eom.stress_stiffness(s, &increment, &mut softening);
    softening.values_mut().iter_mut().for_each(|value| *value = -*value);
    let inner = &stiffness;
    let factor = &mut factor;
    let mut op = Operator { factor, left: inner, right: &softening, inner, coordinates: n, interrupt };
    let key: fn(f64) -> f64 = match sense {
        LoadDirection::Stated => |theta| theta,
        LoadDirection::Reversed => |theta| -theta,
        LoadDirection::Either => f64::abs,
    };
    let search = EigenSearch { count, key, least: MIN_EIGENVALUE, tolerance: TOLERANCE, depth: DEPTH };
    let mut start = op.start(count + GUARD)?;
    let mut mass = matrix;
    eom.tangent(s, Weights::MASS, &mut mass);
    for _ in 0..PASSES {
        let found = krylov(&mut op, start, &search)?;
        if found.converged {
            // A final application of T makes x satisfy the constraints to the accuracy of the linear solver.
            let shapes: Result<Vec<_>, _> =
                found.pairs[..found.requested].iter().map(|pair| op.apply(&pair.vector)).collect();
            return Ok(shapes?.iter().map(|x| critical(x, &stiffness, &softening, &mass, n)).collect());
        }
        start = found.pairs.into_iter().map(|pair| pair.vector).collect();
    }
    Err(EigenError::NotConverged)
}

/// Computes s = xᵀ K₀ x / −xᵀ K_g x, with an error quadratic in that of x, and x with xᵀ M x = 1.
fn critical(
    x: &DVector<f64>,
    stiffness: &SparseMatrix,
    softening: &SparseMatrix,
    mass: &SparseMatrix,
    n: usize,
) -> CriticalLoad {
    let product = |matrix: &SparseMatrix| x.dot(&DVector::from(matrix.times(x.as_slice())));
    let size = product(mass).max(0.0).sqrt();
    let shape = x.iter().take(n).map(|x| x / size).collect();
    CriticalLoad { factor: product(stiffness) / product(softening), shape }
}

/// Computes the first-order response (q₁, λ₁) to the loads at load factor one. Returns `None` for loads without effect.
fn first_order(
    eom: &dyn EquationsOfMotion,
    s: &State,
    stiffness: &SparseMatrix,
    factor: &mut Factor,
) -> Result<Option<State>, EigenError> {
    let (n, m) = (eom.coordinates(), eom.multipliers());
    let residual = |load| {
        let (mut moved, mut r) = (s.clone(), vec![0.0; n + m]);
        moved.load = load;
        eom.residual(&moved, &mut r);
        r
    };
    // The residual is affine in the load factor.
    let (here, there) = (residual(s.load), residual(s.load + 1.0));
    let force: Vec<f64> = here.iter().zip(&there).map(|(here, there)| here - there).collect();
    let mut direction = force.clone();
    factor.solve(stiffness, &mut direction)?;
    let held = |i: usize| match stiffness.diagonal_of(i).abs() {
        0.0 => 0.0,
        stiffness => force[i].powi(2) / stiffness,
    };
    let work: f64 = (0..n).map(|i| force[i] * direction[i]).sum();
    let mut increment = State::rest(n, m);
    increment.add(&direction, Weights::STIFFNESS);
    Ok((work.abs() > MIN_WORK * (0..n).map(held).sum::<f64>()).then_some(increment))
}
