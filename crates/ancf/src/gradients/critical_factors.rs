use ancf_solver::eigen::{CriticalLoad, EigenError, LoadDirection, buckling, softening};
use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::newton::Interrupt;
use ancf_solver::sparse::SparseMatrix;
use nalgebra::DVector;

use super::differences::Derivatives;
use super::eigenvalue_groups::{EigenvalueGroups, product, square, with_reactions};
use crate::assembly::Assembly;
use crate::failure::RunFailure;

/// Largest residual of a buckling shape.
const MAX_RESIDUAL: f64 = 1e-6;

/// Critical load factors of a state.
pub(super) struct CriticalFactors {
    /// Factors and shapes with their reactions, one for each row of the groups.
    factors: Vec<f64>,
    vectors: Vec<DVector<f64>>,
    pub(super) groups: EigenvalueGroups,
    /// Squares xᵀ S x with the loss of stiffness S of the loads.
    softened: Vec<f64>,
}

impl CriticalFactors {
    /// Computes the critical factors of a state, with all equal ones.
    ///
    /// # Errors
    /// If the factors are not found or not accurate.
    pub(super) fn new(
        assembly: &Assembly,
        s: &State,
        (count, sense): (usize, LoadDirection),
        interrupt: &Interrupt,
    ) -> Result<Self, RunFailure> {
        let system = &assembly.system;
        let search =
            |count| Ok::<_, EigenError>(buckling(system, system.matrix(), s, count, sense, interrupt)?.loads);
        let group = |found: &[CriticalLoad]| {
            let factors: Vec<f64> = found.iter().map(|load| load.factor).collect();
            EigenvalueGroups::new(&factors, count)
        };
        let (found, groups) = EigenvalueGroups::complete(count, search, group)?;
        if found.iter().take(count).any(|load| load.residual > MAX_RESIDUAL) {
            return Err(EigenError::Unresolved.into());
        }
        let mut parts = Parts::new(assembly, s)?;
        let loads = || groups.numbers.iter().map(|number| &found[*number]);
        let vectors = loads().map(|load| parts.with_reactions(&load.shape, load.factor));
        let vectors = vectors.collect::<Result<Vec<_>, _>>()?;
        let softened = groups.vectors(&vectors).map(|(_, z)| square(&parts.softening, &z)).collect();
        Ok(Self { factors: loads().map(|load| load.factor).collect(), vectors, groups, softened })
    }

    /// Names of the rows.
    pub(super) fn names(&self) -> Vec<String> {
        self.groups.numbers.iter().map(|number| format!("factor[{number}]")).collect()
    }

    /// Factors of the rows.
    pub(super) fn values(&self) -> &[f64] {
        &self.factors
    }

    /// Computes xᵀ (K − s S) x + 2 μᵀ Φ_q x of the shapes and reactions, NaN if the stiffness is singular.
    pub(super) fn squares(&self, assembly: &Assembly, s: &State) -> Vec<f64> {
        let (numbers, vectors): (Vec<_>, Vec<_>) = self.groups.vectors(&self.vectors).unzip();
        let Ok(parts) = Parts::new(assembly, s) else { return vec![f64::NAN; numbers.len()] };
        let elastic = assembly.system.stiffness_products(s, &vectors).squares;
        let terms = numbers.into_iter().zip(&vectors).zip(elastic);
        let sum = |((number, z), elastic): ((usize, &DVector<f64>), f64)| {
            let mut constraints = 0.0;
            for (multiplier, c, entry) in parts.stiffness.constraints() {
                constraints += z[multiplier] * entry * z[c];
            }
            elastic + 2.0 * constraints - self.factors[number] * square(&parts.softening, z)
        };
        terms.map(sum).collect()
    }

    /// Returns the size of each square, as the parts xᵀ s S x.
    pub(super) fn sizes(&self) -> Vec<f64> {
        let rows = self.groups.vectors(&self.vectors).map(|(row, _)| row);
        rows.zip(&self.softened).map(|(row, softened)| (self.factors[row] * softened).abs()).collect()
    }

    /// Computes the derivatives of the factors, and their errors, from those of the squares.
    pub(super) fn derivatives(&self, forms: &Derivatives) -> Vec<[f64; 2]> {
        self.groups.derivatives(forms, &self.softened)
    }
}

/// Stiffness K of a state with its factors, and its loss S by the loads at load factor one.
struct Parts {
    stiffness: SparseMatrix,
    factor: Factor,
    softening: SparseMatrix,
}

impl Parts {
    fn new(assembly: &Assembly, s: &State) -> Result<Self, EigenError> {
        let system = &assembly.system;
        let mut stiffness = system.matrix();
        system.tangent(s, Weights::STIFFNESS, &mut stiffness);
        let mut factor = Factor::new(stiffness.pattern())?;
        factor.factorise(&stiffness)?;
        let (softening, _) = softening(system, s, &stiffness, &mut factor)?;
        Ok(Self { stiffness, factor, softening })
    }

    /// Appends the reactions μ of a shape, K x + Φ_qᵀ μ = s S x, to the shape.
    fn with_reactions(&mut self, shape: &[f64], factor: f64) -> Result<DVector<f64>, EigenError> {
        let force = product(&self.softening, shape, factor);
        with_reactions(shape, force, (&self.stiffness, &mut self.factor))
    }
}
