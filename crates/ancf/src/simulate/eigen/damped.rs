use ancf_solver::eigen::{DampedMode, DampedModes, EigenError, damped_modes};
use ancf_solver::equations::{EquationsOfMotion, State, Weights};
use ancf_solver::sparse::SparseMatrix;
use nalgebra::DVector;

use super::kinks::Kinks;
use super::shapes::{DAMPED_COLUMNS, MAX_RESIDUAL};
use crate::failure::instability;
use crate::initial::StartState;
use crate::model::{About, Model, Modes};
use crate::simulate::run::{AnalysisRun, RunResult};

/// Velocity of finite differences, in model lengths per unit of time.
const DIFFERENCE: f64 = 1e-6;
/// Largest deviation of C x from finite differences, relative to the sum of the magnitudes of its parts.
const DEVIATION: f64 = 1e-3;

impl AnalysisRun<'_> {
    /// Computes damped modes, one row per mode.
    pub(super) fn damped_modes(
        &mut self,
        model: &Model,
        settings: &Modes,
        given: Option<&StartState>,
    ) -> RunResult {
        self.begin(&DAMPED_COLUMNS)?;
        let count = settings.count as usize;
        let found = self.state_about(model, settings.about, given).and_then(|s| {
            let system = &self.assembly.system;
            let complete = system.with_active_terms(&s);
            let (system, matrix) = complete
                .as_ref()
                .map_or((system, system.matrix()), |(system, matrix)| (system, matrix.clone()));
            let found = damped_modes(system, matrix.clone(), &s, count, self.interrupt)?;
            let mut damping = matrix;
            system.tangent(&s, Weights::DAMPING, &mut damping);
            let kinks = Kinks::new(system, &s);
            let is_smooth = |mode: &DampedMode| {
                is_differentiable(system, &damping, &s, mode) && !mode.shape.iter().any(|x| kinks.has_kink(x))
            };
            if !found.modes.iter().all(is_smooth) {
                return Err(EigenError::NotDifferentiable.into());
            }
            Ok((s, found))
        });
        let (about, DampedModes { modes, is_complete }) = match found {
            Ok((_, found)) if found.modes.iter().any(|mode| mode.residual > MAX_RESIDUAL) => {
                return Ok(Err(EigenError::Unresolved.into()));
            }
            Ok(found) => found,
            Err(reason) => return Ok(Err(reason)),
        };
        if !is_complete {
            self.summary.warnings.push(format!(
                "{} of {count} damped modes are known: the next eigenvalues are too close to each other, as those of strain damping at \
                 -1/tau",
                modes.len()
            ));
        }
        let rate = self.summary.scales.time.recip();
        let warning = |(k, mode): (usize, &DampedMode)| growth_text(k + 1, mode, rate);
        self.summary.warnings.extend(modes.iter().enumerate().filter_map(warning));
        let grows = modes.iter().any(|mode| mode.eigenvalue.re > 0.0);
        if let Some(found) =
            instability(self.assembly, &about).filter(|_| settings.about == About::Equilibrium && !grows)
        {
            self.summary.warnings.push(format!(
                "the equilibrium is unstable without velocities in {}, most at {}: forces that depend on velocities stabilise it, and \
                 damping of the structure may not; the initial state decides which equilibrium is found",
                found.directions(),
                self.assembly.name_in(found.at, self.summary.scales.length)
            ));
        }
        let values = |mode: &DampedMode| {
            vec![mode.frequency() * rate, mode.damping_ratio(), mode.eigenvalue.re * rate, mode.residual]
        };
        let of = |mode| (values(mode), mode.shape.each_ref().map(Vec::as_slice));
        self.complex_shapes(about, modes.iter().map(of))
    }
}

/// Warning of a mode that grows.
fn growth_text(number: usize, mode: &DampedMode, rate: f64) -> Option<String> {
    let (frequency, growth) = (mode.frequency() * rate, mode.eigenvalue.re * rate);
    (growth > 0.0).then(|| match frequency {
        0.0 => format!("mode {number} is unstable without oscillation: growth rate {growth:.6e}"),
        _ => format!("mode {number} is unstable: frequency {frequency:.6e}, growth rate {growth:.6e}"),
    })
}

/// True if the change of the forces with the velocities of a shape is that of the matrices of the modes, or approaches it with
/// decreasing velocities, as that of drag in a fluid at rest.
fn is_differentiable(
    system: &dyn EquationsOfMotion,
    damping: &SparseMatrix,
    s: &State,
    mode: &DampedMode,
) -> bool {
    mode.shape.iter().all(|shape| {
        let largest = shape.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
        if largest == 0.0 {
            return true;
        }
        let residual = |h: f64| {
            let mut there = s.clone();
            there.v.iter_mut().zip(shape).for_each(|(v, x)| *v = h * x);
            let mut r = vec![0.0; s.q.len() + s.lambda.len()];
            system.residual(&there, &mut r);
            DVector::from_vec(r).rows(0, s.q.len()).into_owned()
        };
        let (expected, size) = damping_forces(system, damping, s, shape);
        let mut floor = vec![0.0; s.q.len() + s.lambda.len()];
        system.rounding(s, &mut floor);
        // Largest deviation above rounding errors, and its limit.
        let deviation = |h: f64| {
            let difference = (residual(h) - residual(-h)) / (2.0 * h);
            let above = |i: usize| (difference[i] - expected[i]).abs() - 8.0 * floor[i] / h;
            let deviation = (0..s.q.len()).map(above).fold(0.0, f64::max);
            (deviation, DEVIATION * size.max(difference.amax()))
        };
        let h = DIFFERENCE / largest;
        let (near, limit) = deviation(h);
        near <= limit || deviation(4.0 * h).0 > 2.0 * near
    })
}

/// Returns C x and the largest sum of magnitudes of its rows.
fn damping_forces(
    system: &dyn EquationsOfMotion,
    matrix: &SparseMatrix,
    s: &State,
    x: &[f64],
) -> (DVector<f64>, f64) {
    let mut whole = x.to_vec();
    whole.resize(matrix.pattern().size(), 0.0);
    let mut forces = DVector::from_vec(matrix.times(&whole)).rows(0, x.len()).into_owned();
    let mut magnitudes = matrix.magnitudes(&whole);
    magnitudes.truncate(x.len());
    for (i, j, value) in system.skew_damping(s) {
        forces[i] += value * x[j];
        forces[j] -= value * x[i];
        magnitudes[i] += (value * x[j]).abs();
        magnitudes[j] += (value * x[i]).abs();
    }
    (forces, magnitudes.into_iter().fold(0.0, f64::max))
}
