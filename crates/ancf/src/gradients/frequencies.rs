use std::f64::consts::TAU;

use ancf_solver::eigen::{EigenError, Mode, modes};
use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::newton::Interrupt;
use ancf_solver::sparse::SparseMatrix;
use nalgebra::DVector;

use super::differences::Derivatives;
use super::eigenvalue_groups::{EigenvalueGroups, product, square, with_reactions};
use crate::assembly::Assembly;
use crate::failure::RunFailure;
use crate::simulate::Kinks;

/// Largest residual of a mode.
const MAX_RESIDUAL: f64 = 1e-6;

/// Vibrations about a state with their frequencies.
pub(super) struct Frequencies {
    /// Numbers of the modes from 0, ω² and shapes with their reactions, one for each row of the groups.
    numbers: Vec<usize>,
    squared: Vec<f64>,
    vectors: Vec<DVector<f64>>,
    pub(super) groups: EigenvalueGroups,
    /// Numbers of the requested modes with ω² < 0.
    pub(super) unstable: usize,
    /// Number of coordinates.
    coordinates: usize,
}

impl Frequencies {
    /// Computes modes about a state, with all modes of equal frequencies.
    ///
    /// # Errors
    /// If there are no undamped modes, or they are not accurate.
    pub(super) fn new(
        assembly: &Assembly,
        s: &State,
        count: usize,
        interrupt: &Interrupt,
    ) -> Result<Self, RunFailure> {
        let system = &assembly.system;
        if !system.skew_damping(s).is_empty() {
            return Err(EigenError::Gyroscopic.into());
        }
        if !system.skew_stiffness(s).is_empty() {
            return Err(EigenError::Nonconservative.into());
        }
        let search = |count| Ok::<_, EigenError>(modes(system, system.matrix(), s, count, interrupt)?.modes);
        let vibrations = |found: &[Mode]| -> Vec<usize> {
            (0..found.len()).filter(|&number| found[number].omega_squared > 0.0).collect()
        };
        let group = |found: &[Mode]| {
            let numbers = vibrations(found);
            let squared: Vec<f64> = numbers.iter().map(|&number| found[number].omega_squared).collect();
            EigenvalueGroups::new(&squared, numbers.partition_point(|number| *number < count))
        };
        let (found, groups) = EigenvalueGroups::complete(count, search, group)?;
        if found.iter().take(count).any(|mode| mode.residual > MAX_RESIDUAL) {
            return Err(EigenError::Unresolved.into());
        }
        let kinks = Kinks::new(system, s);
        if found.iter().any(|mode| kinks.has_kink(&mode.shape)) {
            return Err(EigenError::NotDifferentiable.into());
        }
        let vibrations = vibrations(&found);
        let numbers: Vec<usize> = groups.numbers.iter().map(|place| vibrations[*place]).collect();
        let rows = || numbers.iter().map(|number| &found[*number]);
        let mut reactions = Reactions::new(assembly, s)?;
        let vectors = rows().map(|mode| reactions.with_shape(&mode.shape, mode.omega_squared));
        Ok(Self {
            vectors: vectors.collect::<Result<_, _>>()?,
            squared: rows().map(|mode| mode.omega_squared).collect(),
            groups,
            unstable: found.iter().take(count).filter(|mode| mode.omega_squared < 0.0).count(),
            coordinates: s.q.len(),
            numbers,
        })
    }

    /// Names of the rows.
    pub(super) fn names(&self) -> Vec<String> {
        self.numbers.iter().map(|number| format!("frequency[{number}]")).collect()
    }

    /// Frequencies of the rows in solver units.
    pub(super) fn values(&self) -> Vec<f64> {
        self.squared.iter().map(|squared| squared.sqrt() / TAU).collect()
    }

    /// Computes xᵀ (K − ω² M) x + 2 μᵀ Φ_q x of the shapes and reactions.
    pub(super) fn squares(&self, assembly: &Assembly, s: &State) -> Vec<f64> {
        let (system, mut matrix) = (&assembly.system, assembly.system.matrix());
        let (rows, vectors): (Vec<_>, Vec<_>) = self.groups.vectors(&self.vectors).unzip();
        let elastic = system.stiffness_products(s, &vectors).squares;
        let mut last = None;
        let terms = rows.into_iter().zip(vectors).zip(elastic);
        let form = |((row, z), elastic): ((usize, DVector<f64>), f64)| {
            if last.replace(row) != Some(row) {
                system.tangent(s, Weights { q: 0.0, v: 0.0, a: -self.squared[row] }, &mut matrix);
            }
            elastic + square(&matrix, &z)
        };
        terms.map(form).collect()
    }

    /// Returns the size of each square, as the parts xᵀ K x.
    pub(super) fn sizes(&self) -> Vec<f64> {
        self.groups.vectors(&self.vectors).map(|(row, _)| self.squared[row]).collect()
    }

    /// Computes the derivatives of the frequencies, and their errors, from those of the squares.
    pub(super) fn derivatives(&self, forms: &Derivatives) -> Vec<[f64; 2]> {
        let unit: Vec<f64> =
            self.groups.vectors(&self.vectors).map(|(row, z)| self.square_of_unit(row, &z)).collect();
        let found = self.groups.derivatives(forms, &unit);
        let of_frequency = |([value, error], squared): ([f64; 2], &f64)| {
            let factor = 1.0 / (2.0 * TAU * squared.sqrt());
            [value * factor, error * factor]
        };
        found.into_iter().zip(&self.squared).map(of_frequency).collect()
    }

    /// Square xᵀ M x of a shape or of the sum of two orthogonal ones.
    fn square_of_unit(&self, row: usize, z: &DVector<f64>) -> f64 {
        let n = self.coordinates;
        if z.rows(0, n) == self.vectors[row].rows(0, n) { 1.0 } else { 2.0 }
    }
}

/// Solutions for the reactions of modes.
struct Reactions<'a> {
    assembly: &'a Assembly,
    s: &'a State,
    mass: SparseMatrix,
    shifted: SparseMatrix,
    factor: Factor,
}

impl<'a> Reactions<'a> {
    fn new(assembly: &'a Assembly, s: &'a State) -> Result<Self, EigenError> {
        let [mut mass, shifted] = [assembly.system.matrix(), assembly.system.matrix()];
        assembly.system.tangent(s, Weights::MASS, &mut mass);
        let factor = Factor::new(mass.pattern())?;
        Ok(Self { assembly, s, mass, shifted, factor })
    }

    /// Appends the reactions μ of a mode, K x + Φ_qᵀ μ = ω² M x, to its shape.
    fn with_shape(&mut self, shape: &[f64], squared: f64) -> Result<DVector<f64>, EigenError> {
        // K + 2 ω² M is not singular for rigid motions.
        let force = product(&self.mass, shape, 3.0 * squared);
        let weights = Weights { q: 1.0, v: 0.0, a: 2.0 * squared };
        self.assembly.system.tangent(self.s, weights, &mut self.shifted);
        self.factor.factorise(&self.shifted)?;
        with_reactions(shape, force, (&self.shifted, &mut self.factor))
    }
}
