use super::contact_pairs::Met;
use super::energy::{Energy, Level, Power};
use super::state::{State, Weights};
use crate::sparse::{Pattern, SparseMatrix};

/// Index-3 equations of motion M a + f(q, v, t) + Φ_qᵀ λ = 0, Φ(q, t) = 0 with symmetric derivatives.
///
/// The waist of the hourglass: elements and joints above know nothing of schemes, schemes below nothing of elements.
///
/// Shapes: with n coordinates and m multipliers, residuals have n + m entries, tangents are (n + m)².
pub trait EquationsOfMotion {
    /// Number n of coordinates.
    fn coordinates(&self) -> usize;

    /// Number m of multipliers.
    fn multipliers(&self) -> usize;

    /// r = [M a + f + Φ_qᵀ λ; Φ].
    fn residual(&self, s: &State, r: &mut [f64]);

    /// The constraints alone, at a cost proportional to their number: one entry for each multiplier.
    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]);

    /// A bound of the rounding error of each entry of the residual: ε times the sum of the magnitudes it is made of.
    fn rounding(&self, s: &State, floor: &mut [f64]);

    /// Where tangents have entries.
    fn pattern(&self) -> &Pattern;

    /// The symmetric matrix [w_q ∂(f + Φ_qᵀ λ)/∂q + w_v ∂f/∂v + w_a M, Φ_qᵀ; Φ_q, 0].
    fn tangent(&self, s: &State, w: Weights, k: &mut SparseMatrix);

    /// The stiffness of initial stresses: of those stresses, multipliers and loads that come in first order with the increment
    /// `by` of a state's q, λ and load factor, at the configuration of the state ([`Term::stress_stiffness`]).
    ///
    /// [`Term::stress_stiffness`]: super::term::Term::stress_stiffness
    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix);

    /// A coordinate of a term that cannot be in this state, if there is one: equations of motion have such solutions too.
    fn inadmissible(&self, _s: &State) -> Option<usize> {
        None
    }

    /// These equations with the terms that may soon act, and a matrix of their pattern, if one near this state is not here: to be
    /// asked before a step. Terms such as contacts come and go ([`Encounters`](super::contact_pairs::Encounters)).
    fn ahead(&self, _s: &State) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// These equations with all terms that act in this state, and a matrix of their pattern, if one is not here: to be asked
    /// after a step, which is to be repeated with them.
    fn completed(&self, _s: &State) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// The pairs whose terms came and are here, in ascending order.
    fn met(&self) -> Vec<Met> {
        Vec::new()
    }

    /// These equations with the terms of just these pairs, and a matrix of their pattern; none if there are no such pairs.
    fn having_met(&self, _met: &[Met]) -> Option<(Self, SparseMatrix)>
    where
        Self: Sized,
    {
        None
    }

    /// Number of motions that the constraints leave in a state: n less their rank.
    fn freedoms(&self, _s: &State) -> usize {
        self.coordinates().saturating_sub(self.multipliers())
    }

    /// Kinetic, strain and potential energy.
    fn energy(&self, s: &State) -> Energy;

    /// What loads and prescribed motions supply and what is dissipated, per time.
    fn power(&self, _s: &State) -> Power {
        Power::default()
    }
}
