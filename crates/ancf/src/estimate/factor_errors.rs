use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::sparse::SparseMatrix;

use super::gap_field::GapField;
use super::movement::{moved, sizes_of};
use super::shape_gaps::ShapeGaps;
use crate::model::Model;

/// Largest movement by the loads before buckling, as an angle, that is small.
const SMALL: f64 = 1e-2;
/// Movement by the loads between which the gaps are differentiated, as an angle.
const DIFFERENCE: f64 = 1e-5;
/// Cosine between the shapes without and with deformation before buckling below which they are different.
const SAME: f64 = 0.99;
/// Relative change of a factor below which it is not accurate.
const LARGE: f64 = 0.5;

/// Estimated errors of critical load factors of linear buckling.
///
/// With the forces g of the gaps and the response z₁ of the structure to those of the loads, the stiffness K₀ + s K_g changes by
/// −∂g/∂q at the stresses of the factor s, and by the stiffness s K_g[z₁] of other stresses. The exact factor is s/(1 + δ) with
/// δ = xᵀ (∂g/∂q − s K_g[z₁]) x/xᵀ K₀ x.
pub(crate) struct FactorErrors<'a> {
    gaps: ShapeGaps<'a>,
    field: &'a GapField<'a>,
    /// Movement by the loads at factor one, and its size.
    response: &'a [f64],
    size: f64,
    /// K₀, and the stiffness of the error of the stresses at factor one.
    stiffness: SparseMatrix,
    stresses: SparseMatrix,
    mass: SparseMatrix,
    factor: Factor,
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

impl<'a> FactorErrors<'a> {
    /// Examines the response to the loads of a structure in the state of the gaps; `None` if gaps are not known.
    pub(crate) fn new(model: &'a Model, field: &'a GapField<'a>, response: &'a [f64]) -> Option<Self> {
        let (assembly, about) = (field.assembly, field.state);
        if !field.has_estimate() || response.is_empty() {
            return None;
        }
        let system = &assembly.system;
        let size = sizes_of(assembly, about, response).into_iter().fold(0.0, f64::max);
        let mut errors = Self {
            gaps: ShapeGaps { model, assembly, about },
            field,
            response,
            size,
            stiffness: system.matrix(),
            stresses: system.matrix(),
            mass: system.matrix(),
            factor: Factor::new(system.matrix().pattern()).ok()?,
        };
        system.tangent(about, Weights::STIFFNESS, &mut errors.stiffness);
        system.tangent(about, Weights::MASS, &mut errors.mass);
        let h = if size > 0.0 { DIFFERENCE / size } else { 1.0 };
        let [before, after] = [-h, h].map(|h| errors.loaded(h));
        let [before, after] =
            [before, after].map(|state| GapField::new(model, assembly, &state).forces().total);
        let mut error: Vec<f64> = before.iter().zip(&after).map(|(a, b)| (b - a) / (2.0 * h)).collect();
        errors.factor.factorise(&errors.stiffness).ok()?;
        errors.factor.solve(&errors.stiffness, &mut error).ok()?;
        let mut by = State::rest(system.coordinates(), system.multipliers());
        by.load = 0.0;
        by = moved(&by, &error, 1.0);
        system.stress_stiffness(about, &by, &mut errors.stresses);
        Some(errors)
    }

    /// Computes M x for a shape.
    fn mass_times(&self, shape: &[f64]) -> Vec<f64> {
        let mut x = shape.to_vec();
        x.resize(self.mass.pattern().size(), 0.0);
        self.mass.times(&x)
    }

    /// State under the loads at a factor.
    fn loaded(&self, factor: f64) -> State {
        let mut state = moved(self.gaps.about, self.response, factor);
        state.load += factor;
        state
    }

    /// Estimates the exact factor, relative to the computed one, less one; `None` if the change is large.
    pub(crate) fn relative(&mut self, shape: &[f64], factor: f64) -> Option<f64> {
        let (about, shape) = self.buckled(shape, factor)?;
        let works = ShapeGaps { about: &about, ..self.gaps }.work(&shape, 0.0)?;
        let delta = (works - factor * form(&self.stresses, &shape)) / form(&self.stiffness, &shape);
        (delta > -LARGE).then(|| (1.0 + delta).recip() - 1.0)
    }

    /// Parts of the elements of each body in the relative error of a factor.
    pub(crate) fn contributions(&mut self, shape: &[f64], factor: f64) -> Option<Vec<Vec<f64>>> {
        let (about, shape) = self.buckled(shape, factor)?;
        let mut works = ShapeGaps { about: &about, ..self.gaps }.works(&shape, 0.0)?;
        let stiffness = form(&self.stiffness, &shape);
        works.iter_mut().flatten().for_each(|work| *work /= -stiffness);
        Some(works)
    }

    /// State under the critical loads, and the shape of the deformed structure; `None` if the deformation is not small.
    fn buckled(&mut self, shape: &[f64], factor: f64) -> Option<(State, Vec<f64>)> {
        let is_large = factor.abs() * self.size > SMALL;
        if is_large || self.gaps.is_distortion(self.field, shape) {
            return None;
        }
        let about = self.loaded(factor);
        let mass = self.mass_times(shape);
        let mut next = mass.clone();
        let system = &self.gaps.assembly.system;
        let mut stiffness = system.matrix();
        system.tangent(&about, Weights::STIFFNESS, &mut stiffness);
        self.factor.factorise(&stiffness).ok()?;
        self.factor.solve(&stiffness, &mut next).ok()?;
        next.truncate(shape.len());
        let size = dot(&next, &self.mass_times(&next)).sqrt();
        next.iter_mut().for_each(|x| *x /= size);
        (dot(&next, &mass).abs() >= SAME).then_some((about, next))
    }
}

/// Computes xᵀ A x for a shape x.
fn form(matrix: &SparseMatrix, shape: &[f64]) -> f64 {
    let mut x = shape.to_vec();
    x.resize(matrix.pattern().size(), 0.0);
    dot(&matrix.times(&x), &x)
}
