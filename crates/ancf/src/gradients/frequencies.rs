use std::f64::consts::TAU;
use std::ops::Range;

use ancf_solver::eigen::{EigenError, modes};
use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::factor::Factor;
use ancf_solver::newton::Interrupt;
use nalgebra::DVector;

use super::differences::Derivatives;
use super::eigenvalue_groups::EigenvalueGroups;
use crate::assembly::Assembly;
use crate::failure::RunFailure;
use crate::simulate::Kinks;

/// Number of modes beyond the requested ones, which show whether the last ones have equal frequencies.
const FURTHER: usize = 2;
/// Largest residual of a mode.
const MAX_RESIDUAL: f64 = 1e-6;

/// Vibrations about a state with their frequencies.
pub(super) struct Frequencies {
    /// Numbers of the modes from 0, ω² and shapes with their reactions, for ω² > 0.
    numbers: Vec<usize>,
    squared: Vec<f64>,
    vectors: Vec<DVector<f64>>,
    groups: EigenvalueGroups,
    /// Number of modes whose derivatives are computed.
    count: usize,
    /// Number of coordinates.
    coordinates: usize,
}

impl Frequencies {
    /// Computes modes about a state.
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
        let found = modes(system, system.matrix(), s, count + FURTHER, interrupt)?.modes;
        if found.iter().take(count).any(|mode| mode.residual > MAX_RESIDUAL) {
            return Err(EigenError::Unresolved.into());
        }
        let kinks = Kinks::new(system, s);
        if found.iter().any(|mode| kinks.has_kink(&mode.shape)) {
            return Err(EigenError::NotDifferentiable.into());
        }
        let vibrations: Vec<_> =
            found.iter().enumerate().filter(|(_, mode)| mode.omega_squared > 0.0).collect();
        let squared: Vec<f64> = vibrations.iter().map(|(_, mode)| mode.omega_squared).collect();
        let mut groups = EigenvalueGroups::new(&squared);
        let requested = vibrations.iter().filter(|(number, _)| *number < count).count();
        groups.groups.retain(|group| group.start < requested);
        let vectors =
            vibrations.iter().map(|(_, mode)| with_reactions(assembly, s, &mode.shape, mode.omega_squared));
        Ok(Self {
            numbers: vibrations.iter().map(|(number, _)| *number).collect(),
            vectors: vectors.collect::<Result<_, _>>()?,
            squared,
            groups,
            count: requested,
            coordinates: s.q.len(),
        })
    }

    /// Names of the quantities.
    pub(super) fn names(&self) -> Vec<String> {
        self.numbers[..self.count].iter().map(|number| format!("frequency[{number}]")).collect()
    }

    /// Frequencies in solver units.
    pub(super) fn values(&self) -> Vec<f64> {
        self.squared[..self.count].iter().map(|squared| squared.sqrt() / TAU).collect()
    }

    /// Groups of equal results, by their rows.
    pub(super) fn equal(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        self.groups
            .groups
            .iter()
            .filter(|group| group.len() > 1)
            .map(|group| group.start..group.end.min(self.count))
    }

    /// Computes xᵀ (K − ω² M) x + 2 μᵀ Φ_q x of the shapes and reactions.
    pub(super) fn squares(&self, assembly: &Assembly, s: &State) -> Vec<f64> {
        let (system, mut matrix) = (&assembly.system, assembly.system.matrix());
        let (modes, vectors): (Vec<_>, Vec<_>) = self.groups.vectors(&self.vectors).unzip();
        let elastic = system.stiffness_products(s, &vectors).squares;
        let mut last = None;
        let terms = modes.into_iter().zip(vectors).zip(elastic);
        let square = |((mode, z), elastic): ((usize, DVector<f64>), f64)| {
            if last.replace(mode) != Some(mode) {
                system.tangent(s, Weights { q: 0.0, v: 0.0, a: -self.squared[mode] }, &mut matrix);
            }
            elastic + product(z.as_slice(), &matrix.times(z.as_slice()))
        };
        terms.map(square).collect()
    }

    /// Computes the derivatives of the frequencies, and their errors, from those of the squares.
    pub(super) fn derivatives(&self, forms: &Derivatives) -> Vec<[f64; 2]> {
        let unit: Vec<f64> =
            self.groups.vectors(&self.vectors).map(|(mode, z)| self.square_of_unit(mode, &z)).collect();
        let found = self.groups.derivatives(forms, &unit);
        let of_frequency = |([value, error], squared): ([f64; 2], &f64)| {
            let factor = 1.0 / (2.0 * TAU * squared.sqrt());
            [value * factor, error * factor]
        };
        found.into_iter().zip(&self.squared).map(of_frequency).take(self.count).collect()
    }

    /// Square xᵀ M x of a shape or of the sum of two orthogonal ones.
    fn square_of_unit(&self, mode: usize, z: &DVector<f64>) -> f64 {
        let n = self.coordinates;
        if z.rows(0, n) == self.vectors[mode].rows(0, n) { 1.0 } else { 2.0 }
    }
}

/// Appends the reactions μ of a mode, K x + Φ_qᵀ μ = ω² M x, to its shape.
fn with_reactions(
    assembly: &Assembly,
    s: &State,
    shape: &[f64],
    squared: f64,
) -> Result<DVector<f64>, EigenError> {
    let system = &assembly.system;
    let n = shape.len();
    let mut matrix = system.matrix();
    let mut x = shape.to_vec();
    x.resize(n + s.lambda.len(), 0.0);
    system.tangent(s, Weights::MASS, &mut matrix);
    let mut solution = matrix.times(&x);
    solution[n..].fill(0.0);
    // K + 2 ω² M is not singular for rigid motions.
    solution.iter_mut().for_each(|force| *force *= 3.0 * squared);
    system.tangent(s, Weights { q: 1.0, v: 0.0, a: 2.0 * squared }, &mut matrix);
    let mut factor = Factor::new(matrix.pattern())?;
    factor.factorise(&matrix)?;
    factor.solve(&matrix, &mut solution)?;
    x[n..].copy_from_slice(&solution[n..]);
    Ok(DVector::from_vec(x))
}

fn product(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}
