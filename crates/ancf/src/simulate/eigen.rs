use std::io;
use std::ops::ControlFlow;

use ancf_solver::eigen::{
    ComplexMode, CriticalLoad, CriticalLoads, EigenError, Mode, SturmCount, buckling, modes,
    nonconservative_modes,
};
use ancf_solver::equations::{EquationsOfMotion, State};

use super::run::{AnalysisRun, RunResult};
use super::summary::EigenvalueCount;
use crate::assembly::Assembly;
use crate::estimate::{DiscretisationErrors, FactorErrors, FrequencyErrors, GapField};
use crate::failure::{RunFailure, prebuckling_warning, require_support, unloaded};
use crate::initial::EquilibriumSearch;
use crate::model::{About, Buckling, Model, Modes, Statics};
use crate::results::Column;
use crate::units::{Dimension, UnitQuantity};

/// Upper limit on the relative residual of a mode.
const MAX_RESIDUAL: f64 = 1e-3;

/// Critical load factor that may be a rounding error.
const LARGE_FACTOR: f64 = 1e9;

/// Warning of buckling without a result.
const NO_CRITICAL_LOAD: &str = "there is no critical load factor: the loads do not soften the structure in this direction, beyond \
    rounding errors";

/// Warning of modes whose number is not verified.
const UNVERIFIED: &str = "the number of modes is not verified: the inertia of the shifted stiffness is not known beyond rounding errors. \
    Frequencies may be missing";

/// Columns of the solver for modes.
pub(crate) const MODE_COLUMNS: [&str; 4] = ["frequency", "squared", "residual", "frequency_error"];
/// Columns of the solver for buckling.
pub(crate) const BUCKLING_COLUMNS: [&str; 3] = ["factor", "residual", "factor_error"];

/// Columns of shapes: number, columns of the solver, displacements of the probes.
pub(crate) fn columns(assembly: &Assembly, solver: &[&str]) -> Vec<Column> {
    let dimension = |name: &str| match name {
        "frequency" | "frequency_error" => Some(Dimension::RATE),
        "squared" => Some(Dimension::new(0, -2, 0)),
        _ => None,
    };
    let mut columns = vec![Column::new("mode", None)];
    let quantity = |name: &str| match name {
        "frequency" | "frequency_error" => UnitQuantity::Frequency,
        _ => UnitQuantity::Other,
    };
    columns
        .extend(solver.iter().map(|&name| Column::new(name, dimension(name)).with_quantity(quantity(name))));
    for (probe, _) in &assembly.probes {
        columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("{probe}.{axis}"), None)));
    }
    columns
}

/// Mode under loads with or without a potential.
struct FoundMode {
    /// Frequency, or NaN for an unstable mode.
    frequency: f64,
    /// Real part of ω².
    squared: f64,
    /// Frequency and growth rate of flutter.
    flutter: Option<[f64; 2]>,
    shape: Vec<f64>,
    residual: f64,
    /// Estimated error of the frequency, relative to it; NaN if it is not known.
    error: f64,
}

/// Modes of a state.
struct FoundModes {
    modes: Vec<FoundMode>,
    /// Number of zero frequencies.
    rigid: usize,
    sturm: Option<SturmCount>,
    /// True if the loads have no potential.
    is_nonconservative: bool,
}

impl From<Mode> for FoundMode {
    fn from(mode: Mode) -> Self {
        let frequency = mode.frequency().unwrap_or(f64::NAN);
        let Mode { omega_squared: squared, shape, residual } = mode;
        Self { frequency, squared, flutter: None, shape, residual, error: f64::NAN }
    }
}

impl From<ComplexMode> for FoundMode {
    fn from(mode: ComplexMode) -> Self {
        let [frequency, growth] = mode.frequency_and_growth();
        let flutter = (mode.omega_squared.im != 0.0).then_some([frequency, growth]);
        let frequency = if mode.is_unstable() { f64::NAN } else { frequency };
        let ComplexMode { omega_squared, shape, residual } = mode;
        Self { frequency, squared: omega_squared.re, flutter, shape, residual, error: f64::NAN }
    }
}

impl FoundMode {
    /// Values of [`MODE_COLUMNS`].
    fn values(&self, rate: f64) -> Vec<f64> {
        let frequency = self.frequency * rate;
        vec![frequency, self.squared * rate * rate, self.residual, frequency * self.error]
    }

    /// Warning of flutter.
    fn flutter_text(&self, number: usize, rate: f64) -> Option<String> {
        let [frequency, growth] = self.flutter?.map(|x| x * rate);
        Some(format!(
            "mode {number} flutters under loads without a potential: frequency {frequency:.6e}, growth rate {growth:.6e}"
        ))
    }
}

impl AnalysisRun<'_> {
    /// Computes the state about which the model is linearised.
    fn state_about(&self, model: &Model, about: About) -> Result<State, RunFailure> {
        if about == About::Reference {
            return Ok(unloaded(self.assembly));
        }
        let (assembly, interrupt, scales) = (self.assembly, self.interrupt, self.summary.scales);
        let settings = &Statics::default();
        EquilibriumSearch { model, scales, assembly, settings, interrupt }.run(&mut |_, _| ())
    }

    /// Computes natural modes, one row per mode.
    pub(crate) fn modes(&mut self, model: &Model, settings: &Modes) -> RunResult {
        self.begin(&MODE_COLUMNS)?;
        let count = settings.count as usize;
        let found = self.state_about(model, settings.about).and_then(|s| {
            let system = &self.assembly.system;
            let complete = system.with_active_terms(&s);
            let (system, matrix) = complete
                .as_ref()
                .map_or((system, system.matrix()), |(system, matrix)| (system, matrix.clone()));
            if !system.skew_stiffness(&s).is_empty() {
                let found = nonconservative_modes(system, matrix, &s, count, self.interrupt)?;
                let modes = found.into_iter().map(FoundMode::from).collect();
                return Ok((s, FoundModes { modes, rigid: 0, sturm: None, is_nonconservative: true }));
            }
            let found = modes(system, matrix, &s, count, self.interrupt)?;
            let modes = found.modes.into_iter().map(FoundMode::from).collect();
            Ok((s, FoundModes { modes, rigid: found.rigid, sturm: found.sturm, is_nonconservative: false }))
        });
        let rate = self.summary.scales.time.recip();
        match found {
            // Large residuals indicate an undetected motion without stiffness.
            Ok((_, found)) if found.modes.iter().any(|mode| mode.residual > MAX_RESIDUAL) => {
                Ok(Err(EigenError::NotConverged.into()))
            }
            Ok((about, mut found)) => {
                if !found.is_nonconservative {
                    self.estimate(model, &about, &mut found.modes);
                }
                self.summary.warnings.extend(self.held_but_zero(&about, found.rigid));
                if found.sturm.is_none() && !found.is_nonconservative && !found.modes.is_empty() {
                    self.summary.warnings.push(UNVERIFIED.to_owned());
                }
                let counted = |sturm: SturmCount| EigenvalueCount::new(sturm, rate * rate);
                self.summary.eigenvalues = found.sturm.map(counted);
                let flutter = |(k, mode): (usize, &FoundMode)| mode.flutter_text(k + 1, rate);
                self.summary.warnings.extend(found.modes.iter().enumerate().filter_map(flutter));
                self.shapes(about, found.modes.iter().map(|mode| (mode.values(rate), mode.shape.as_slice())))
            }
            Err(reason) => Ok(Err(reason)),
        }
    }

    /// Estimates the errors of the frequencies.
    fn estimate(&mut self, model: &Model, about: &State, modes: &mut [FoundMode]) {
        let field = GapField::new(model, self.assembly, about);
        let mut errors = FrequencyErrors::new(model, &field);
        let rate = self.summary.scales.time.recip();
        for (number, mode) in modes.iter_mut().enumerate() {
            let relative =
                errors.as_mut().and_then(|errors| errors.relative(number, &mode.shape, mode.squared));
            mode.error = relative.unwrap_or(f64::NAN);
        }
        let found: Vec<_> = modes.iter().map(|mode| [mode.frequency * rate, mode.error]).collect();
        let works = |number: usize| {
            let mode = &modes[number];
            errors.as_ref()?.contributions(&mode.shape, mode.squared)
        };
        self.summary.errors = DiscretisationErrors::of_eigenvalues(&field, "frequency", &found, works);
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

    /// Warns of zero frequencies beyond the rigid-body motions that the geometry leaves free.
    fn held_but_zero(&self, s: &State, zeros: usize) -> Option<String> {
        if zeros == 0 {
            return None;
        }
        let free = self.assembly.free_motions(s)?.len();
        (zeros > free).then(|| {
            format!(
                "{zeros} frequencies are zero, but the rigid bodies and joints leave {free} motions free: \
                the others have no stiffness beyond the rounding error"
            )
        })
    }

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

    fn begin(&mut self, solver: &[&str]) -> io::Result<()> {
        let columns = columns(self.assembly, solver).into_iter().map(|column| column.name);
        self.observer.begin(&columns.collect::<Vec<_>>())
    }

    /// Records values and shapes about a state.
    fn shapes<'s>(
        &mut self,
        mut about: State,
        found: impl Iterator<Item = (Vec<f64>, &'s [f64])>,
    ) -> RunResult {
        // xᵀ M x = 1: with the unit of mass m, the unit of displacements is 1/√m.
        let scales = self.summary.scales;
        let mass = scales.force * scales.time.powi(2) / scales.length;
        let as_velocity = scales.time / scales.length / mass.sqrt();
        let mut found = found.enumerate().peekable();
        while let Some((number, (values, shape))) = found.next() {
            let mut row = vec![(number + 1) as f64];
            row.extend(values);
            for (_, point) in &self.assembly.probes {
                row.extend(point.variation(&about, shape).iter().map(|x| x / mass.sqrt()));
            }
            about.v.iter_mut().zip(shape).for_each(|(v, x)| *v = x * as_velocity);
            self.summary.steps += 1;
            // A stop request at the last shape has no effect.
            if self.observer.record(&row, &about)?.is_break() && found.peek().is_some() {
                return Ok(Ok(ControlFlow::Break(())));
            }
        }
        Ok(Ok(ControlFlow::Continue(())))
    }
}
