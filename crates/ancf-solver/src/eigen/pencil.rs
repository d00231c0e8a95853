use nalgebra::DVector;

use super::columns::Columns;
use super::full_rows::FullRows;
use super::operator::{EigenError, Operator};
use crate::equations::{EquationsOfMotion, State, StiffnessProducts, Weights};
use crate::factor::Factor;
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Number of shifts without a symmetric factorisation.
const TRIALS: usize = 3;

/// Matrix M of a state, the products with K, and K − σM with its factors.
pub(super) struct Pencil<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    mass: FullRows,
    /// Inverse roots of the masses, with ones for the multipliers. Coordinates and slopes have entries of one unit with them, so that
    /// pivots can be compared.
    scales: Vec<f64>,
    /// K − σM with these scales.
    shifted: SparseMatrix,
    factor: Factor,
    highest: f64,
    interrupt: &'a Interrupt,
}

impl<'a> Pencil<'a> {
    pub(super) fn new(
        eom: &'a dyn EquationsOfMotion,
        mut matrix: SparseMatrix,
        s: &'a State,
        interrupt: &'a Interrupt,
    ) -> Result<Self, EigenError> {
        eom.tangent(s, Weights::MASS, &mut matrix);
        let mass = FullRows::new(&matrix);
        eom.tangent(s, Weights::STIFFNESS, &mut matrix);
        let ratio = |i: usize| match mass.diagonal()[i] {
            mass if mass > 0.0 => matrix.diagonal_of(i).abs() / mass,
            _ => 0.0,
        };
        let highest = (0..eom.coordinates()).map(ratio).fold(0.0, f64::max);
        let factor = Factor::new(matrix.pattern())?;
        let scales = scales(&mass, eom.coordinates());
        Ok(Self { eom, s, mass, scales, shifted: matrix, factor, highest, interrupt })
    }

    /// Estimates the highest ω² by the largest K_ii / M_ii. Returns one without stiffness.
    pub(super) fn highest(&self) -> f64 {
        if self.highest > 0.0 { self.highest } else { 1.0 }
    }

    /// Factorises K − σM for the first of σ, 4σ, 16σ, ... below all ω². Returns this shift.
    ///
    /// Pivots may be rounding errors next to an eigenvalue. Some larger distances are therefore tried before factors without
    /// inertia are accepted.
    pub(super) fn factorise(&mut self, mut shift: f64) -> Result<f64, EigenError> {
        // 4¹⁰⁰ exceeds any spectrum.
        for trial in 0..100 {
            self.factorise_at(shift)?;
            match self.factor.negative_pivots() {
                None if trial < TRIALS => shift *= 4.0,
                Some(negative) if negative > self.eom.multipliers() => shift *= 4.0,
                _ => return Ok(shift),
            }
        }
        Err(EigenError::Singular)
    }

    fn factorise_at(&mut self, shift: f64) -> Result<(), EigenError> {
        self.eom.tangent(self.s, Weights { q: 1.0, v: 0.0, a: -shift }, &mut self.shifted);
        self.shifted.scale(&self.scales);
        // Next to ω² = 0 the inertia gives no scale to rigid bodies.
        self.shifted.set_inertia(false);
        Ok(self.factor.factorise(&self.shifted)?)
    }

    pub(super) fn operator(&mut self) -> Operator<'_> {
        let Self { eom, mass, scales, shifted, factor, interrupt, .. } = self;
        let coordinates = eom.coordinates();
        Operator { factor, left: shifted, scales, right: mass, inner: mass, coordinates, interrupt }
    }

    /// Computes K X and the diagonal of Xᵀ K X term by term.
    pub(super) fn stiffness_products(&self, x: &[DVector<f64>]) -> StiffnessProducts {
        self.eom.stiffness_products(self.s, x)
    }

    /// Computes M x.
    pub(super) fn mass_times(&self, x: &DVector<f64>) -> DVector<f64> {
        DVector::from(self.mass.times(x.as_slice()))
    }

    /// Computes M X.
    pub(super) fn images(&self, x: &[DVector<f64>]) -> Columns {
        let mut images = Columns::new(self.mass.diagonal().len());
        x.iter().for_each(|x| images.push(&self.mass.times(x.as_slice())));
        images
    }

    /// Number of coordinates and multipliers.
    pub(super) fn unknowns(&self) -> usize {
        self.mass.diagonal().len()
    }

    /// Number of coordinates.
    pub(super) fn coordinates(&self) -> usize {
        self.eom.coordinates()
    }

    /// Computes the relative change of T x by a step of iterative refinement with products term by term, for a normalised x.
    ///
    /// It is the rounding error of the factors, which grows with the ratio of the stiffness of single elements to K − σM.
    pub(super) fn factor_error(&mut self, x: &DVector<f64>, shift: f64) -> Result<f64, EigenError> {
        let (image, reactions) = self.operator().apply_with_reactions(x.as_slice())?;
        let product = self.stiffness_products(std::slice::from_ref(&image)).products.remove(0);
        let rest = self.mass_times(x) - product + self.mass_times(&image) * shift;
        let change = self.operator().correction(&image, -rest, Some(&(-reactions)))?;
        Ok(self.size(&change) / self.size(&image))
    }

    /// Counts the ω² below a value by the negative eigenvalues of K − value · M. Returns `None` without LDLᵀ factors.
    pub(super) fn count_below(&mut self, value: f64) -> Result<Option<usize>, EigenError> {
        self.factorise_at(value)?;
        let multipliers = self.eom.multipliers();
        Ok(self.factor.negative_pivots().map(|negative| negative.saturating_sub(multipliers)))
    }

    /// Computes √(xᵀ M x).
    pub(super) fn size(&self, x: &DVector<f64>) -> f64 {
        self.mass.square(x.as_slice()).max(0.0).sqrt()
    }

    /// Returns the sign of the first of the largest entries. Entries within a relative 10⁻⁶ count as equal.
    pub(super) fn sign(&self, x: &DVector<f64>) -> f64 {
        let sizes: Vec<f64> =
            self.mass.diagonal().iter().zip(x).map(|(mass, x)| (x * mass.abs().sqrt()).abs()).collect();
        let own = &sizes[..self.eom.coordinates()];
        let largest = own.iter().copied().fold(0.0, f64::max);
        let first = own.iter().position(|size| *size >= (1.0 - 1e-6) * largest);
        first.map_or(1.0, |i| x[i].signum())
    }
}

/// Returns the inverse roots of the masses of the coordinates, the largest one for those without mass, and ones for the multipliers.
fn scales(mass: &FullRows, coordinates: usize) -> Vec<f64> {
    let inverse = |mass: &f64| if *mass > 0.0 { mass.sqrt().recip() } else { 0.0 };
    let mut scales: Vec<f64> = mass.diagonal().iter().map(inverse).collect();
    let largest = scales.iter().copied().fold(0.0, f64::max);
    let of_massless = if largest > 0.0 { largest } else { 1.0 };
    scales.iter_mut().filter(|scale| **scale == 0.0).for_each(|scale| *scale = of_massless);
    scales[coordinates..].fill(1.0);
    scales
}
