use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::sparse::SparseMatrix;
use ancf_solver::statics::stiffness_solution;

use super::differences::{Derivatives, DifferencePair, extrapolated, kink};
use super::error::GradientError;
use super::varied_models::VariedModels;
use crate::assembly::Assembly;
use crate::estimate::moved;

/// Maximum number of corrections of an equilibrium and of its change.
const CORRECTIONS: usize = 12;
/// Size of a correction relative to the one before it above which corrections have no further effect.
const PROGRESS: f64 = 0.5;

/// Equilibrium to rounding errors, with the factors of its stiffness K.
pub(super) struct AccurateEquilibrium<'a> {
    pub(super) assembly: &'a Assembly,
    pub(super) state: State,
    matrix: SparseMatrix,
    factor: Factor,
}

/// Derivative z of the coordinates and multipliers of an equilibrium with respect to a number of the model.
pub(super) struct EquilibriumChange {
    pub(super) z: Vec<f64>,
    /// Last correction, which bounds the error of z.
    correction: Vec<f64>,
}

impl<'a> AccurateEquilibrium<'a> {
    /// Removes the error of the stopping rule of an equilibrium.
    ///
    /// # Errors
    /// If the stiffness is singular.
    pub(super) fn new(assembly: &'a Assembly, state: State) -> Result<Self, GradientError> {
        let system = &assembly.system;
        let singular = |_| GradientError::failed(SINGULAR);
        let matrix = system.matrix();
        let factor = Factor::new(matrix.pattern()).map_err(singular)?;
        let mut own = Self { assembly, state, matrix, factor };
        own.factorise().map_err(singular)?;
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let correction = own.response(&own.residual(assembly, &own.state))?;
            let size = largest(&correction);
            if size >= PROGRESS * last || size == 0.0 {
                break;
            }
            own.state = moved(&own.state, &correction, -1.0);
            last = size;
        }
        own.factorise().map_err(singular)?;
        Ok(own)
    }

    fn factorise(&mut self) -> Result<(), ancf_solver::factor::SingularMatrix> {
        self.assembly.system.tangent(&self.state, Weights::STIFFNESS, &mut self.matrix);
        self.factor.factorise(&self.matrix)
    }

    fn residual(&self, of: &Assembly, s: &State) -> Vec<f64> {
        let mut residual = vec![0.0; s.q.len() + s.lambda.len()];
        of.system.residual(s, &mut residual);
        residual
    }

    /// Solves K z = f.
    fn response(&mut self, force: &[f64]) -> Result<Vec<f64>, GradientError> {
        let solved =
            stiffness_solution(&self.assembly.system, &self.state, (&self.matrix, &mut self.factor), force);
        solved.ok_or_else(|| GradientError::failed(SINGULAR))
    }

    /// Computes the change of the equilibrium with a number p of the model: r(x + h z, p + h) = o(h) for the residual r.
    ///
    /// The first solution has the derivative of the residual at the fixed state, z = −K⁻¹ ∂r/∂p. Corrections have that along z. It is
    /// the sum of nearly equal parts at the fixed state, whose rounding errors the corrections remove.
    ///
    /// `None` if forces or constraints have a kink.
    ///
    /// # Errors
    /// If the stiffness is singular.
    pub(super) fn change(
        &mut self,
        models: &VariedModels,
    ) -> Result<Option<EquilibriumChange>, GradientError> {
        let size = self.state.q.len() + self.state.lambda.len();
        let (mut z, mut last, mut kept) = (vec![0.0; size], f64::INFINITY, vec![0.0; size]);
        for _ in 0..CORRECTIONS {
            let correction = self.response(&extrapolated(&self.residuals(models, &z)).values)?;
            let found = largest(&correction);
            let is_better = found < PROGRESS * last;
            if is_better {
                z.iter_mut().zip(&correction).for_each(|(z, correction)| *z -= correction);
                last = found;
            }
            kept = correction;
            if !is_better || found == 0.0 {
                break;
            }
        }
        let change = EquilibriumChange { z, correction: kept };
        Ok((!self.has_kink(models, &change.z)).then_some(change))
    }

    /// Residuals of changed models in the states x + h z.
    fn residuals(&self, models: &VariedModels, z: &[f64]) -> Vec<DifferencePair> {
        models.pairs(|assembly, h| self.residual(assembly, &moved(&self.state, z, h)))
    }

    /// True if residuals have a kink along the change of the equilibrium.
    fn has_kink(&self, models: &VariedModels, z: &[f64]) -> bool {
        let mut rounding = vec![0.0; z.len()];
        models.pairs(|assembly, h| {
            let mut own = vec![0.0; z.len()];
            assembly.system.rounding(&moved(&self.state, z, h), &mut own);
            rounding.iter_mut().zip(own).for_each(|(bound, own)| *bound = f64::max(*bound, ROUNDING * own));
            Vec::new()
        });
        let centre = self.residual(self.assembly, &self.state);
        kink(&self.residuals(models, z), &centre, &rounding).is_some()
    }

    /// Computes the derivatives of functions of the equilibrium and the model, given a number that changes.
    ///
    /// Errors contain that of the change of the equilibrium.
    pub(super) fn derivatives(
        &self,
        models: &VariedModels,
        change: &EquilibriumChange,
        mut of: impl FnMut(&Assembly, &State) -> Vec<f64>,
    ) -> Derivatives {
        let EquilibriumChange { z, correction } = change;
        let mut along =
            |z: &[f64]| extrapolated(&models.pairs(|assembly, h| of(assembly, &moved(&self.state, z, h))));
        let mut found = along(z);
        if correction.iter().any(|x| *x != 0.0) {
            let corrected: Vec<f64> =
                z.iter().zip(correction).map(|(z, correction)| z - correction).collect();
            let other = along(&corrected).values;
            for ((error, value), other) in found.errors.iter_mut().zip(&found.values).zip(other) {
                *error += (value - other).abs();
            }
        }
        found
    }
}

/// Multiple of the bounds of rounding errors that residuals of neighbouring models may have.
const ROUNDING: f64 = 16.0;

const SINGULAR: &str = "the stiffness of the equilibrium is singular, so its derivatives do not exist";

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |largest, x| x.abs().max(largest))
}
