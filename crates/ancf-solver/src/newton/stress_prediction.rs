use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, negative_eigenvalues};
use crate::sparse::SparseMatrix;

/// Stresses of the tangent in statics: those that the last linear system predicted, in place of those of the iterate.
///
/// An increment along straight tangents stretches the axis of a slender body by the square of its rotation. The stress of this
/// stretch, 16 (L/d)² times that of bending, is not that of an equilibrium, but it dominates the stiffness at the iterate: the
/// next increments are small, and the number of iterations grows with L/d. The stress n(q₀) + ∂n/∂q (q − q₀) that the linear system
/// at the last iterate q₀ predicted is in equilibrium with the loads to first order. This is Newton's method for stresses
/// and displacements as independent unknowns, without the stresses in the equations. The residual remains that of the displacements,
/// and near a solution both tangents agree to the second order of the increment.
///
/// The predicted stresses may be compressive in slack bodies. If the matrix is then indefinite, the iteration uses the stresses of
/// the iterate.
///
/// A slack cable on a straight line has no stiffness across it but that of bending, with L⁴/EI below rounding errors in long cables.
/// If the first increment turns its sections too far, the first two tangents have an axial strain of at least ε₀ in the cables.
/// It is chosen so that the sections turn by 4° to 48°.
///
/// Source: Magisano, Leonetti & Garcea (2017), mixed integration points.
#[derive(Debug)]
pub(crate) struct StressPrediction {
    /// Last iterate, or the equilibrium before the prediction of the first one.
    from: State,
    is_active: bool,
    /// Number of tangents of the solution so far.
    tangents: u32,
    /// True if the first iterate is the last equilibrium.
    starts_there: bool,
    /// Least axial strain ε₀ of cables in the first tangents, and the number of its trials.
    least: Option<f64>,
    trials: u32,
    /// State after the first increment of a model with cables.
    trial: Option<State>,
}

/// Rotation of the first increment above which cables get a tension. A slope of 16, relative to the largest rotation of 120°.
const TOO_FAR: f64 = 0.72;
/// Rotations of the first increment that are sought with the tension.
const SOUGHT: [f64; 2] = [0.03, 0.4];
/// First strain, and the factor to the next one.
const FIRST_STRAIN: f64 = 1e-6;
const FACTOR: f64 = 30.0;
/// Largest number of strains.
const TRIALS: u32 = 5;
/// Number of tangents with a least strain.
const WITH_TENSION: u32 = 2;

impl StressPrediction {
    /// Storage for states of the size of `s`.
    pub(super) fn new(s: &State) -> Self {
        Self {
            from: s.clone(),
            is_active: false,
            tangents: 0,
            starts_there: false,
            least: None,
            trials: 0,
            trial: None,
        }
    }

    /// Starts a solution from an equilibrium.
    pub(super) fn start(&mut self, from: &State) {
        self.from.copy_from(from);
        (self.is_active, self.tangents, self.least, self.trials) = (true, 0, None, 0);
    }

    /// Ends a solution.
    pub(super) fn end(&mut self) {
        self.is_active = false;
    }

    /// Computes and factorises the tangent with the predicted stresses. Returns false if they are not used.
    pub(super) fn factorise(
        &mut self,
        eom: &dyn EquationsOfMotion,
        s: &State,
        (matrix, factor): (&mut SparseMatrix, &mut Factor),
    ) -> bool {
        let is_start = self.from.q == s.q;
        self.tangents += 1;
        self.starts_there = is_start && self.tangents == 1;
        let least = self.least.filter(|_| self.tangents <= WITH_TENSION);
        if !self.is_active || (is_start && least.is_none()) {
            return false;
        }
        eom.predicted_stiffness(s, &self.from, matrix);
        if let Some(least) = least {
            eom.add_least_tension(s, &self.from, least, matrix);
        }
        self.from.copy_from(s);
        let is_factorised = factor.factorise(matrix).is_ok();
        is_factorised && negative_eigenvalues(matrix, factor) == Some(eom.multipliers())
    }

    /// Chooses the least strain of cables after the increment `z` of the first tangent. Returns true if it has changed: the increment
    /// is then computed again.
    pub(super) fn choose_least_strain(&mut self, eom: &dyn EquationsOfMotion, s: &State, z: &[f64]) -> bool {
        if !self.is_active || !self.starts_there || self.trials > TRIALS || !eom.has_cables() {
            return false;
        }
        let trial = self.trial.get_or_insert_with(|| s.clone());
        trial.copy_from(s);
        trial.add(z, Weights::STIFFNESS);
        let size = eom.rotation(s, trial).size;
        self.least = match self.least {
            None if size > TOO_FAR => Some(FIRST_STRAIN),
            None => return false,
            // What turns too far with any tension is no cable.
            Some(_) if self.trials == TRIALS => None,
            Some(least) if size > SOUGHT[1] => Some(least * FACTOR),
            Some(least) if size < SOUGHT[0] => Some(least / FACTOR.sqrt()),
            Some(_) => return false,
        };
        self.trials += 1;
        self.tangents = 0;
        true
    }
}
