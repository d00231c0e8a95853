//! Stability of a state by the inertia of its tangent stiffness.

use ancf_solver::equations::State;
use ancf_solver::statics::Stability;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;

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
pub(crate) fn instability(assembly: &Assembly, s: &State) -> Option<Instability> {
    if !s.q.iter().chain(&s.lambda).all(|x| x.is_finite()) {
        return None;
    }
    let stability = Stability::new(&assembly.system, s).filter(|stability| stability.unstable > 0)?;
    let (count, x) = (stability.unstable, stability.neutral_direction()?);
    let vectors = assembly.bodies().flat_map(|(_, body)| body.vectors(s));
    let positions =
        vectors.filter(|vector| vector.is_position()).flat_map(|vector| vector.first..vector.first + 3);
    let at = positions.max_by(|a, b| x[*a].abs().total_cmp(&x[*b].abs()))?;
    Some(Instability { count, at })
}

/// Unloaded initial state.
pub(crate) fn unloaded(assembly: &Assembly) -> State {
    State { load: 0.0, ..assembly.initial() }
}
