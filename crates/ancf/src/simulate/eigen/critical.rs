use ancf_solver::eigen::{CriticalLoad, CriticalLoads, EigenError, buckling};
use ancf_solver::equations::{EquationsOfMotion, State};

use super::shapes::{BUCKLING_COLUMNS, MAX_RESIDUAL};
use crate::estimate::{DiscretisationErrors, FactorErrors, GapField};
use crate::failure::{prebuckling_warning, require_support, unloaded};
use crate::model::{Buckling, Model};
use crate::simulate::run::EigenvalueCount;
use crate::simulate::run::{AnalysisRun, RunResult};

/// Critical load factor that may be a rounding error.
const LARGE_FACTOR: f64 = 1e9;

/// Warning of buckling without a result.
const NO_CRITICAL_LOAD: &str = "there is no critical load factor: the loads do not soften the structure in this direction, beyond \
    rounding errors";

impl AnalysisRun<'_> {
    /// Computes critical loads, one row per load.
    pub(crate) fn buckling(&mut self, model: &Model, settings: &Buckling) -> RunResult {
        self.begin(&BUCKLING_COLUMNS)?;
        let (system, s) = (&self.assembly.system, unloaded(self.assembly));
        let found = require_support(self.assembly, &s, self.summary.scales).and_then(|()| {
            let (count, sense) = (settings.count as usize, settings.sense.into());
            Ok(match system.with_active_terms(&s) {
                Some((complete, matrix)) => buckling(&complete, matrix, &s, count, sense, self.interrupt)?,
                None => buckling(system, system.matrix(), &s, count, sense, self.interrupt)?,
            })
        });
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
                let errors = self.estimate_factors(model, &s, &found);
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
