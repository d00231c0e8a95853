//! Whether the stiffness of a state holds it: what tells buckling from other failures, and from none.

use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;

/// Passes of inverse iteration, which find the direction that is next to neutral.
const PASSES: u32 = 12;

/// Directions in which loads push a state on instead of back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Instability {
    /// Their number: negative eigenvalues of the tangent stiffness along the constraints.
    pub(crate) count: usize,
    /// The coordinate of a position that moves most in the one nearest to neutral.
    pub(crate) at: usize,
}

impl Instability {
    /// In how many directions, in words.
    pub(crate) fn directions(&self) -> String {
        if self.count == 1 { "1 direction".to_owned() } else { format!("{} directions", self.count) }
    }
}

/// Bodies beyond which it takes too long to find out what is free.
const MANY: usize = 300;

/// Whether joints and stiffness hold all bodies in the reference state: mechanisms are unstable by nature in some positions.
pub(crate) fn is_held(assembly: &Assembly) -> bool {
    assembly.bodies().count() <= MANY && assembly.free_motions(&unloaded(assembly)).is_empty()
}

/// The instability of a state under its loads and forces of inertia, if it has one; to be asked of what is held.
///
/// Source: Sylvester (1852), the law of inertia, by the factors of [K, Φ_qᵀ; Φ_q, 0].
pub(crate) fn instability(assembly: &Assembly, s: &State) -> Option<Instability> {
    if !s.q.iter().chain(&s.lambda).all(|x| x.is_finite()) {
        return None;
    }
    match assembly.system.with_active_terms(s) {
        Some((complete, _)) => of(&complete, assembly, s),
        None => of(&assembly.system, assembly, s),
    }
}

fn of(system: &ancf_solver::equations::System, assembly: &Assembly, s: &State) -> Option<Instability> {
    let mut k = system.matrix();
    system.tangent(s, Weights::STIFFNESS, &mut k);
    let mut factor = Factor::new(k.pattern()).ok()?;
    factor.factorise(&k).ok()?;
    let count = factor.negative_pivots()?.checked_sub(system.multipliers())?;
    if count == 0 {
        return None;
    }
    let n = s.q.len();
    // Any start that is orthogonal to nothing: as far as numbers go, one without pattern.
    let mut x: Vec<f64> =
        (0..k.pattern().size()).map(|i| ((i + 1) as f64 * 0.754_877_67).fract() - 0.5).collect();
    for _ in 0..PASSES {
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

/// The unloaded reference state.
pub(crate) fn unloaded(assembly: &Assembly) -> State {
    State { load: 0.0, ..assembly.initial() }
}
