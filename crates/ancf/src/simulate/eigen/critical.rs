use ancf_solver::eigen::{CriticalLoad, CriticalLoads, EigenError, buckling};
use ancf_solver::equations::{EquationsOfMotion, State};
use ancf_solver::newton::Interrupt;

use super::finer_values::of_equal_signs;
use super::shapes::{BUCKLING_COLUMNS, MAX_RESIDUAL};
use crate::assembly::Assembly;
use crate::estimate::{DiscretisationErrors, FactorErrors, GapField, HalvedModel};
use crate::failure::{RunFailure, prebuckling_warning, require_support, unloaded};
use crate::model::{Buckling, Model};
use crate::simulate::run::{AnalysisRun, EigenvalueCount, RunResult, finer_failure};
use crate::units::Scales;

/// Critical load factor that may be a rounding error.
const LARGE_FACTOR: f64 = 1e9;

/// Warning of buckling without a result.
pub(crate) const NO_CRITICAL_LOAD: &str = "there is no critical load factor: the loads do not soften the structure in this direction, beyond \
    rounding errors";

/// Computes the critical loads of the unloaded state.
fn critical_loads(
    assembly: &Assembly,
    scales: Scales,
    settings: &Buckling,
    interrupt: &Interrupt,
) -> Result<CriticalLoads, RunFailure> {
    let (system, s) = (&assembly.system, unloaded(assembly));
    require_support(assembly, &s, scales)?;
    let (count, sense) = (settings.count as usize, settings.sense.into());
    Ok(match system.with_active_terms(&s) {
        Some((complete, matrix)) => buckling(&complete, matrix, &s, count, sense, interrupt)?,
        None => buckling(system, system.matrix(), &s, count, sense, interrupt)?,
    })
}

impl AnalysisRun<'_> {
    /// Computes critical loads, one row per load.
    pub(crate) fn buckling(&mut self, model: &Model, settings: &Buckling) -> RunResult {
        self.begin(&BUCKLING_COLUMNS)?;
        let s = unloaded(self.assembly);
        let found = critical_loads(self.assembly, self.summary.scales, settings, self.interrupt);
        match found {
            Ok(found) if found.loads.iter().any(|load| load.residual > MAX_RESIDUAL) => {
                Ok(Err(EigenError::NotConverged.into()))
            }
            Ok(found) => {
                self.summary.eigenvalues = found.sturm.map(|sturm| EigenvalueCount::new(sturm, 1.0));
                if found.loads.is_empty() {
                    self.summary.warnings.push(NO_CRITICAL_LOAD.to_owned());
                }
                let large = found.loads.iter().filter(|load| load.factor.abs() > LARGE_FACTOR);
                self.summary.warnings.extend(large.map(|load| {
                    format!(
                        "the critical load factor {:.3e} is so large that it may be a rounding error of the stresses: the \
                         loads hardly affect the stability",
                        load.factor
                    )
                }));
                let scales = self.summary.scales;
                self.summary.warnings.extend(prebuckling_warning(self.assembly, &s, &found, scales));
                let errors = match model.has_shells() {
                    true => self.compare_factors(model, settings, &found),
                    false => self.estimate_factors(model, &s, &found),
                };
                let row = |(load, error): (&CriticalLoad, &f64)| {
                    vec![load.factor, load.residual, load.factor * error]
                };
                let rows: Vec<_> = found.loads.iter().zip(&errors).map(row).collect();
                let shapes = found.loads.iter().map(|load| load.shape.as_slice());
                self.shapes(s, rows.into_iter().zip(shapes))
            }
            Err(reason) => Ok(Err(reason)),
        }
    }

    /// Estimates the errors of critical load factors of a model with shells on request, relative to them, by a second solution.
    fn compare_factors(&mut self, model: &Model, settings: &Buckling, found: &CriticalLoads) -> Vec<f64> {
        let (scales, interrupt) = (self.summary.scales, self.interrupt);
        let values =
            |found: &CriticalLoads| -> Vec<f64> { found.loads.iter().map(|load| load.factor).collect() };
        let given = values(found);
        let solution = |halved: &HalvedModel| {
            let finer = critical_loads(&halved.assembly, scales, settings, interrupt);
            let finer = finer.map_err(|error| finer_failure(error, halved, scales))?;
            Ok(of_equal_signs(&given, &values(&finer)))
        };
        self.compare_eigenvalues(model, ("factor", &given), None, solution)
    }

    /// Estimates the errors of critical load factors, relative to them.
    fn estimate_factors(&mut self, model: &Model, s: &State, found: &CriticalLoads) -> Vec<f64> {
        let field = GapField::new(model, self.assembly, s);
        let mut errors = FactorErrors::new(model, &field, &found.response);
        let mut relative = |load: &CriticalLoad| errors.as_mut()?.relative(&load.shape, load.factor);
        let relative: Vec<_> = found.loads.iter().map(|load| relative(load).unwrap_or(f64::NAN)).collect();
        let values: Vec<_> =
            found.loads.iter().zip(&relative).map(|(load, error)| [load.factor, *error]).collect();
        let works = |number: usize| {
            let load = &found.loads[number];
            errors.as_mut()?.contributions(&load.shape, load.factor)
        };
        self.summary.errors = DiscretisationErrors::of_eigenvalues(&field, "factor", &values, works);
        relative
    }
}
