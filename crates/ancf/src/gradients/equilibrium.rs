use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::{Factor, SingularMatrix, add_skew_product};
use ancf_solver::sparse::SparseMatrix;
use ancf_solver::statics::stiffness_solution;

use super::differences::{Derivatives, DifferencePair, extrapolated, has_kink};
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

/// Derivative of the residual along a change of an equilibrium.
struct ResidualDerivative {
    derivatives: Derivatives,
    /// True if it consists of rounding errors.
    is_rounding: bool,
}

/// Derivative z of the coordinates and multipliers of an equilibrium with respect to a number of the model.
pub(super) struct EquilibriumChange {
    pub(super) z: Vec<f64>,
    /// Estimated error of z.
    deviation: Vec<f64>,
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
            let correction = own.response(&residual(assembly, &own.state))?;
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

    fn factorise(&mut self) -> Result<(), SingularMatrix> {
        self.assembly.system.tangent(&self.state, Weights::STIFFNESS, &mut self.matrix);
        self.factor.factorise(&self.matrix)
    }

    /// Solves K z = f.
    fn response(&mut self, force: &[f64]) -> Result<Vec<f64>, GradientError> {
        let solved =
            stiffness_solution(&self.assembly.system, &self.state, (&self.matrix, &mut self.factor), force);
        solved.ok_or_else(|| GradientError::failed(SINGULAR))
    }

    /// Computes the change z of the equilibrium with a number p of the model: r(x + h z, p + h) = o(h) for the residual r.
    ///
    /// z = −K⁻¹ ∂r/∂p has few rounding errors: those of equal positions cancel in differences at a fixed state. The stiffness may lack
    /// small parts, of forces that depend on reactions. Corrections by the derivative of the residual along z remove their effect, if
    /// the derivative exceeds rounding errors.
    ///
    /// `None` if forces or constraints have a kink.
    ///
    /// # Errors
    /// If the stiffness is singular.
    pub(super) fn change(
        &mut self,
        models: &VariedModels,
    ) -> Result<Option<EquilibriumChange>, GradientError> {
        let fixed = extrapolated(&models.pairs(|assembly, _| residual(assembly, &self.state)));
        if fixed.values.iter().any(|x| !x.is_finite()) {
            return Err(GradientError::failed(NOT_FINITE));
        }
        let mut z = self.response(&fixed.values.iter().map(|r| -r).collect::<Vec<_>>())?;
        // The errors of the extrapolation and of the solution.
        let mut rest = self.product(&z);
        rest.iter_mut().zip(&fixed.others).for_each(|(rest, other)| *rest += other);
        let mut deviation = self.response(&rest)?;
        let mut last = f64::INFINITY;
        for _ in 0..CORRECTIONS {
            let Some(along) = self.derivative_along(models, &z) else { return Ok(None) };
            if along.is_rounding {
                break;
            }
            let correction = self.response(&along.derivatives.values)?;
            let size = largest(&correction);
            if size >= PROGRESS * last {
                deviation = correction;
                break;
            }
            z.iter_mut().zip(&correction).for_each(|(z, correction)| *z -= correction);
            deviation = self.response(&along.derivatives.others)?;
            last = size;
        }
        Ok(Some(EquilibriumChange { z, deviation }))
    }

    /// Computes K z with the skew part of the stiffness.
    fn product(&self, z: &[f64]) -> Vec<f64> {
        let mut product = self.matrix.times(z);
        add_skew_product(&self.assembly.system.skew_stiffness(&self.state), z, &mut product);
        product
    }

    /// Bounds the effect of the rounding errors of the coordinates on the residual, of their largest one on the constraints.
    fn rounding_of_coordinates(&self) -> Vec<f64> {
        let State { q, lambda, .. } = &self.state;
        let coordinates: Vec<f64> = q.iter().chain(lambda).copied().collect();
        let mut rounding = self.matrix.magnitudes(&coordinates);
        let of_largest = self.matrix.magnitudes(&vec![largest(q); rounding.len()]);
        rounding[q.len()..].copy_from_slice(&of_largest[q.len()..]);
        rounding.iter_mut().for_each(|bound| *bound *= f64::EPSILON);
        rounding
    }

    /// Computes the derivative of the residual along the change of the equilibrium; `None` at a kink.
    fn derivative_along(&self, models: &VariedModels, z: &[f64]) -> Option<ResidualDerivative> {
        let mut rounding = self.rounding_of_coordinates();
        let pairs = models.pairs(|assembly, h| {
            let (there, mut own) = (moved(&self.state, z, h), vec![0.0; z.len()]);
            assembly.system.rounding(&there, &mut own);
            rounding.iter_mut().zip(own).for_each(|(bound, own)| *bound = f64::max(*bound, ROUNDING * own));
            residual(assembly, &there)
        });
        if has_kink(&pairs, &residual(self.assembly, &self.state), &rounding) {
            return None;
        }
        let derivatives = extrapolated(&pairs);
        let smallest = pairs.last().map_or(f64::INFINITY, |pair| pair.step);
        let bound = |(rounding, error): (&f64, &f64)| rounding / smallest + error;
        let mut bounds = rounding.iter().zip(&derivatives.errors).map(bound);
        let is_rounding =
            derivatives.values.iter().all(|value| bounds.next().is_some_and(|bound| value.abs() <= bound));
        Some(ResidualDerivative { derivatives, is_rounding })
    }

    /// Computes the derivatives of functions of the equilibrium and the model, given a number that changes, from their values along z.
    ///
    /// Errors contain that of the change of the equilibrium.
    pub(super) fn derivatives(
        &self,
        models: &VariedModels,
        EquilibriumChange { z, deviation }: &EquilibriumChange,
        mut of: impl FnMut(&Assembly, &State) -> Vec<f64>,
    ) -> (Vec<DifferencePair>, Derivatives) {
        let mut along = |z: &[f64]| models.pairs(|assembly, h| of(assembly, &moved(&self.state, z, h)));
        let pairs = along(z);
        let mut found = extrapolated(&pairs);
        if deviation.iter().any(|x| *x != 0.0) {
            let deviating: Vec<f64> = z.iter().zip(deviation).map(|(z, deviation)| z - deviation).collect();
            let other = extrapolated(&along(&deviating)).values;
            for ((error, value), other) in found.errors.iter_mut().zip(&found.values).zip(other) {
                *error += (value - other).abs();
            }
        }
        (pairs, found)
    }
}

/// Multiple of the bounds of rounding errors that residuals of neighbouring models may have.
const ROUNDING: f64 = 16.0;

const NOT_FINITE: &str = "the equations of a model with a changed number are not finite: a smaller size of its change may be possible";

const SINGULAR: &str = "the stiffness of the equilibrium is singular, so its derivatives do not exist";

fn residual(of: &Assembly, s: &State) -> Vec<f64> {
    let mut residual = vec![0.0; s.q.len() + s.lambda.len()];
    of.system.residual(s, &mut residual);
    residual
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |largest, x| x.abs().max(largest))
}
