//! Stability of a state by the inertia of its tangent stiffness.

use ancf_solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf_solver::factor::{Factor, inertia, is_zero_on_motions};
use ancf_solver::sparse::SparseMatrix;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;

/// Iterations of the inverse iteration for the eigenvector of the eigenvalue nearest to zero.
const INVERSE_ITERATIONS: u32 = 12;

/// Unstable directions of a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Instability {
    /// Number of negative eigenvalues of the tangent stiffness projected onto the constraints.
    pub(crate) count: usize,
    /// Coordinate of a position with the largest component in the direction nearest to neutral.
    pub(crate) at: usize,
}

impl Instability {
    /// Number of directions, as text.
    pub(crate) fn directions(&self) -> String {
        directions(self.count)
    }
}

/// Number of directions, as text.
pub(crate) fn directions(count: usize) -> String {
    if count == 1 { "1 direction".to_owned() } else { format!("{count} directions") }
}

/// True if joints and stiffness support all bodies in the reference state. Mechanisms also have unstable positions without
/// buckling.
pub(crate) fn is_supported(assembly: &Assembly) -> bool {
    assembly.free_motions(&unloaded(assembly)).is_some_and(|motions| motions.is_empty())
}

/// Instability of a state under its loads and inertia forces; `None` also with loads without a potential, where an indefinite symmetric
/// part of the stiffness does not imply instability. The model must be [supported](is_supported).
///
/// Source: Sylvester's law of inertia (1852), applied to the factors of [K, Φ_qᵀ; Φ_q, 0].
pub(crate) fn instability(assembly: &Assembly, s: &State) -> Option<Instability> {
    if !s.q.iter().chain(&s.lambda).all(|x| x.is_finite()) {
        return None;
    }
    let TangentInertia { k, mut factor, count } = TangentInertia::of(assembly, s)?;
    if count == 0 {
        return None;
    }
    let n = s.q.len();
    // Pseudo-random start vector: components along all eigenvectors.
    let mut x: Vec<f64> =
        (0..k.pattern().size()).map(|i| ((i + 1) as f64 * 0.754_877_67).fract() - 0.5).collect();
    for _ in 0..INVERSE_ITERATIONS {
        x[n..].fill(0.0);
        let largest = x.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        x.iter_mut().for_each(|x| *x /= largest);
        factor.solve(&k, &mut x).ok()?;
    }
    let vectors = assembly.bodies().flat_map(|(_, body)| body.vectors(s));
    let positions =
        vectors.filter(|vector| vector.is_position()).flat_map(|vector| vector.first..vector.first + 3);
    let at = positions.max_by(|a, b| x[*a].abs().total_cmp(&x[*b].abs()))?;
    Some(Instability { count, at })
}

/// Returns the number of unstable directions of a state, without the condition on the model; `None` if it is unknown.
pub(crate) fn unstable_directions(assembly: &Assembly, s: &State) -> Option<usize> {
    TangentInertia::of(assembly, s).map(|inertia| inertia.count)
}

/// Tangent stiffness of a state with its factors.
struct TangentInertia {
    k: SparseMatrix,
    factor: Factor,
    /// Number of negative eigenvalues of the stiffness projected onto the constraints.
    count: usize,
}

impl TangentInertia {
    /// Inertia with all contacts that are active in the state.
    fn of(assembly: &Assembly, s: &State) -> Option<Self> {
        match assembly.system.with_active_terms(s) {
            Some((complete, _)) => Self::new(&complete, s),
            None => Self::new(&assembly.system, s),
        }
    }

    /// Counts the negative eigenvalues; `None` if the factors do not tell their number, or if it does not determine the stability.
    fn new(system: &System, s: &State) -> Option<Self> {
        let mut k = system.matrix();
        system.tangent(s, Weights::STIFFNESS, &mut k);
        let mut factor = Factor::new(k.pattern()).ok()?;
        factor.factorise(&k).ok()?;
        let count = factor.negative_pivots().or_else(|| inertia(&k))?.checked_sub(system.multipliers())?;
        let decides =
            count == 0 || is_zero_on_motions(&system.skew_stiffness(s), s.q.len(), &k, &mut factor).ok()?;
        decides.then_some(Self { k, factor, count })
    }
}

/// Unloaded initial state.
pub(crate) fn unloaded(assembly: &Assembly) -> State {
    State { load: 0.0, ..assembly.initial() }
}
