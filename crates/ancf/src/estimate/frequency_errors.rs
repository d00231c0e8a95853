use ancf_solver::equations::{EquationsOfMotion, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::sparse::SparseMatrix;

use super::gap_field::GapField;
use super::movement::{moved, sizes_of};
use super::shape_gaps::ShapeGaps;
use crate::model::Model;

/// Relative movement of the states between which forces are differentiated twice.
const SECOND_DIFFERENCE: f64 = 1e-3;
/// Error of the displacements of the equilibrium, relative to them, above which its effect is not linear.
const INACCURATE: f64 = 1e-2;
/// Error of an equilibrium without displacements, as an angle, that is a rounding error.
const ROUNDING: f64 = 1e-9;
/// Relative change of ω² about a stressed equilibrium above which it is not accurate.
const LARGE: f64 = 0.5;

/// Estimated errors of the frequencies of vibration about a state.
///
/// The exact ω² is ω²/(1 + δ) with δ = xᵀ (∂g/∂q) x/ω² for the forces g of the gaps and xᵀ M x = 1. For a structure without
/// stresses this is the quotient of Grammel. The error of a stressed equilibrium changes the stiffness, and δ accordingly.
///
/// Source: Grammel (1939); Collatz (1963), section 4.
pub(crate) struct FrequencyErrors<'a> {
    gaps: ShapeGaps<'a>,
    field: &'a GapField<'a>,
    shift: Option<EquilibriumError>,
    /// Number of modes that the mesh resolves.
    count: usize,
}

impl<'a> FrequencyErrors<'a> {
    /// Examines the gaps of the state; `None` if they are not known, or the error of the state is too large.
    pub(crate) fn new(model: &'a Model, field: &'a GapField<'a>) -> Option<Self> {
        let (assembly, about) = (field.assembly, field.state);
        if !field.has_estimate() {
            return None;
        }
        let shift = if about.load == 0.0 {
            None
        } else {
            Some(EquilibriumError::new(field).filter(|_| !field.is_rough())?)
        };
        let count = assembly.system.degrees_of_freedom(about) / 2;
        Some(Self { gaps: ShapeGaps { model, assembly, about }, field, shift, count })
    }

    /// Estimates the exact frequency of the mode with a number from zero, relative to the computed one, less one.
    ///
    /// `None` for rigid and unstable modes, for modes above half the number of degrees of freedom, and for modes in which the
    /// sections are distorted.
    pub(crate) fn relative(&mut self, number: usize, shape: &[f64], squared: f64) -> Option<f64> {
        let is_known = number < self.count && squared > 0.0 && !self.gaps.is_distortion(self.field, shape);
        if !is_known {
            return None;
        }
        let work = self.gaps.work(shape, squared)?;
        let change = match &mut self.shift {
            Some(shift) => shift.change(&self.gaps, shape, squared)?,
            None => 0.0,
        };
        let delta = (work - change) / squared;
        let is_accurate = delta > -LARGE && (self.shift.is_none() || delta < LARGE);
        is_accurate.then(|| (1.0 + delta).sqrt().recip() - 1.0)
    }

    /// Parts of the elements of each body in the relative error of a frequency.
    pub(crate) fn contributions(&self, shape: &[f64], squared: f64) -> Option<Vec<Vec<f64>>> {
        let mut works = self.gaps.works(shape, squared)?;
        works.iter_mut().flatten().for_each(|work| *work /= -2.0 * squared);
        Some(works)
    }
}

/// Error of the equilibrium about which a structure vibrates.
struct EquilibriumError {
    /// Error of coordinates and multipliers.
    error: Vec<f64>,
    stiffness: SparseMatrix,
    mass: SparseMatrix,
    factor: Factor,
}

impl EquilibriumError {
    /// Computes the error; `None` if it is large or the stiffness is singular.
    fn new(field: &GapField<'_>) -> Option<Self> {
        let (system, about) = (&field.assembly.system, field.state);
        let [mut stiffness, mut mass] = [system.matrix(), system.matrix()];
        system.tangent(about, Weights::STIFFNESS, &mut stiffness);
        system.tangent(about, Weights::MASS, &mut mass);
        // The rest of the residual has the effect of an error of the state.
        let mut error = field.forces().total;
        let mut residual = vec![0.0; error.len()];
        system.residual(about, &mut residual);
        error.iter_mut().zip(&residual).for_each(|(force, residual)| *force -= residual);
        let mut factor = Factor::new(stiffness.pattern()).ok()?;
        factor.factorise(&stiffness).ok()?;
        factor.solve(&stiffness, &mut error).ok()?;
        let size = |q: &[f64]| {
            let mut x = q[..about.q.len()].to_vec();
            x.resize(error.len(), 0.0);
            x.iter().zip(mass.times(&x)).map(|(x, y)| x * y).sum::<f64>().sqrt()
        };
        let is_rounding = || sizes_of(field.assembly, about, &error).iter().all(|size| *size < ROUNDING);
        (size(&error) <= INACCURATE * size(&about.q) || is_rounding()).then_some(())?;
        Some(Self { error, stiffness, mass, factor })
    }

    /// Returns the change xᵀ dK x of ω² by the error of the equilibrium, for a mode x with its multipliers.
    fn change(&mut self, gaps: &ShapeGaps<'_>, shape: &[f64], squared: f64) -> Option<f64> {
        let ShapeGaps { assembly, about, .. } = gaps;
        let (n, size) = (shape.len(), self.error.len());
        // K x + Φ_qᵀ μ = ω² M x.
        let mut mode = shape.to_vec();
        mode.resize(size, 0.0);
        mode = self.mass.times(&mode);
        mode.iter_mut().for_each(|x| *x *= squared);
        mode[n..].fill(0.0);
        self.factor.solve(&self.stiffness, &mut mode).ok()?;
        mode[..n].copy_from_slice(shape);
        let largest = |x: &[f64]| sizes_of(assembly, about, x).into_iter().fold(0.0, f64::max);
        let sizes = [largest(shape), largest(&self.error)];
        if sizes[1] == 0.0 {
            return Some(0.0);
        }
        let [h, k] = sizes.map(|size| SECOND_DIFFERENCE / size);
        let mut residual = vec![0.0; size];
        let mut work = |h: f64, k: f64| {
            let mut state = moved(&moved(about, &mode, h), &self.error, k);
            state.a.iter_mut().zip(shape).for_each(|(a, x)| *a = -squared * h * x);
            residual.fill(0.0);
            assembly.system.residual(&state, &mut residual);
            mode.iter().zip(&residual).map(|(x, r)| x * r).sum::<f64>()
        };
        let difference = work(h, k) - work(-h, k) - work(h, -k) + work(-h, -k);
        Some(difference / (4.0 * h * k))
    }
}
