use nalgebra::DVector;

use super::krylov::{EigenError, Operator};
use crate::equations::{EquationsOfMotion, State, StiffnessProducts, Weights};
use crate::factor::Factor;
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Matrices K and M of a state, and K − σM with its factors.
pub(super) struct Pencil<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    stiffness: SparseMatrix,
    mass: SparseMatrix,
    shifted: SparseMatrix,
    factor: Factor,
    interrupt: &'a Interrupt,
}

impl<'a> Pencil<'a> {
    pub(super) fn new(
        eom: &'a dyn EquationsOfMotion,
        matrix: SparseMatrix,
        s: &'a State,
        interrupt: &'a Interrupt,
    ) -> Result<Self, EigenError> {
        let (mut stiffness, mut mass) = (matrix.clone(), matrix.clone());
        eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
        eom.tangent(s, Weights::MASS, &mut mass);
        let factor = Factor::new(matrix.pattern())?;
        Ok(Self { eom, s, stiffness, mass, shifted: matrix, factor, interrupt })
    }

    /// Estimates the highest ω² by the largest K_ii / M_ii. Returns one without stiffness.
    pub(super) fn highest(&self) -> f64 {
        let ratio = |i| match self.mass.diagonal_of(i) {
            mass if mass > 0.0 => self.stiffness.diagonal_of(i).abs() / mass,
            _ => 0.0,
        };
        let highest = (0..self.eom.coordinates()).map(ratio).fold(0.0, f64::max);
        if highest > 0.0 { highest } else { 1.0 }
    }

    /// Factorises K − σM for the first of σ, 4σ, 16σ, ... below all ω². Returns this shift.
    pub(super) fn factorise(&mut self, mut shift: f64) -> Result<f64, EigenError> {
        // 4¹⁰⁰ exceeds any spectrum.
        for _ in 0..100 {
            self.eom.tangent(self.s, Weights { q: 1.0, v: 0.0, a: -shift }, &mut self.shifted);
            self.factor.factorise(&self.shifted)?;
            match self.factor.negative_pivots() {
                Some(negative) if negative > self.eom.multipliers() => shift *= 4.0,
                _ => return Ok(shift),
            }
        }
        Err(EigenError::Singular)
    }

    pub(super) fn operator(&mut self) -> Operator<'_> {
        let Self { eom, mass, shifted, factor, interrupt, .. } = self;
        let coordinates = eom.coordinates();
        Operator { factor, left: shifted, right: mass, inner: mass, coordinates, interrupt }
    }

    /// Computes K X and Xᵀ K X term by term.
    pub(super) fn stiffness_products(&self, x: &[DVector<f64>]) -> StiffnessProducts {
        self.eom.stiffness_products(self.s, x)
    }

    /// Returns eight times the rounding error of xᵀ K x with the assembled matrix.
    pub(super) fn rounding(&self, x: &DVector<f64>) -> f64 {
        8.0 * f64::EPSILON * self.stiffness.magnitude(x.as_slice())
    }

    /// Computes M x.
    pub(super) fn mass_times(&self, x: &DVector<f64>) -> DVector<f64> {
        DVector::from(self.mass.times(x.as_slice()))
    }

    /// Number of coordinates.
    pub(super) fn coordinates(&self) -> usize {
        self.eom.coordinates()
    }

    /// Counts the ω² below a value by the negative eigenvalues of K − value · M. Returns `None` without LDLᵀ factors.
    pub(super) fn count_below(&mut self, value: f64) -> Result<Option<usize>, EigenError> {
        self.eom.tangent(self.s, Weights { q: 1.0, v: 0.0, a: -value }, &mut self.shifted);
        self.factor.factorise(&self.shifted)?;
        let multipliers = self.eom.multipliers();
        Ok(self.factor.negative_pivots().map(|negative| negative.saturating_sub(multipliers)))
    }

    /// Computes √(xᵀ M x).
    pub(super) fn size(&self, x: &DVector<f64>) -> f64 {
        x.dot(&self.mass_times(x)).max(0.0).sqrt()
    }

    /// Returns the sign of the first of the largest entries. Entries within a relative 10⁻⁶ count as equal.
    pub(super) fn sign(&self, x: &DVector<f64>) -> f64 {
        let weighed = |i: usize| x[i] * self.mass.diagonal_of(i).abs().sqrt();
        let all = 0..self.eom.coordinates();
        let largest = all.clone().map(|i| weighed(i).abs()).fold(0.0, f64::max);
        let first = all.clone().find(|&i| weighed(i).abs() >= (1.0 - 1e-6) * largest);
        first.map_or(1.0, |i| x[i].signum())
    }
}
