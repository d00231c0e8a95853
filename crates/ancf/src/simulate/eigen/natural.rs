use ancf_solver::eigen::{ComplexMode, EigenError, Mode, SturmCount, modes, nonconservative_modes};
use ancf_solver::equations::{EquationsOfMotion, State};
use ancf_solver::newton::Interrupt;

use super::kinks::Kinks;
use super::shapes::{MAX_RESIDUAL, MODE_COLUMNS, state_about};
use crate::assembly::Assembly;
use crate::errors::short;
use crate::estimate::{DiscretisationErrors, FrequencyErrors, GIVEN_START, GapField, HalvedModel};
use crate::failure::RunFailure;
use crate::initial::StartState;
use crate::model::{Model, Modes};
use crate::simulate::run::{AnalysisRun, EigenvalueCount, RunResult, finer_failure};

/// Warning of modes whose number is not verified.
const UNVERIFIED: &str = "the number of modes is not verified: the inertia of the shifted stiffness is not known beyond rounding errors. \
    Frequencies may be missing";

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
    /// True if there are modes beyond the found ones, whose number is not verified.
    is_unverified: bool,
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
            "mode {number} flutters under loads without a potential: frequency {}, growth rate {}",
            short(frequency),
            short(growth)
        ))
    }
}

impl FoundModes {
    /// Computes a number of modes about a state.
    fn new(assembly: &Assembly, s: &State, count: usize, interrupt: &Interrupt) -> Result<Self, RunFailure> {
        let system = &assembly.system;
        let complete = system.with_active_terms(s);
        let (system, matrix) =
            complete.as_ref().map_or((system, system.matrix()), |(system, matrix)| (system, matrix.clone()));
        if !system.skew_damping(s).is_empty() {
            return Err(EigenError::Gyroscopic.into());
        }
        if !system.skew_stiffness(s).is_empty() {
            let found = nonconservative_modes(system, matrix, s, count, interrupt)?;
            let modes: Vec<_> = found.into_iter().map(FoundMode::from).collect();
            require_slopes(system, s, &modes)?;
            return Ok(Self { modes, rigid: 0, sturm: None, is_unverified: false, is_nonconservative: true });
        }
        let found = modes(system, matrix, s, count, interrupt)?;
        let modes: Vec<_> = found.modes.into_iter().map(FoundMode::from).collect();
        require_slopes(system, s, &modes)?;
        let is_unverified = found.sturm.is_none() && modes.len() < system.degrees_of_freedom(s);
        Ok(Self { modes, rigid: found.rigid, sturm: found.sturm, is_unverified, is_nonconservative: false })
    }
}

/// Rejects modes about a state in which forces have kinks along them: there is no stiffness.
fn require_slopes(system: &dyn EquationsOfMotion, s: &State, modes: &[FoundMode]) -> Result<(), RunFailure> {
    let kinks = Kinks::new(system, s);
    let is_smooth = modes.iter().all(|mode| !kinks.has_kink(&mode.shape));
    if is_smooth { Ok(()) } else { Err(EigenError::NotDifferentiable.into()) }
}

impl AnalysisRun<'_> {
    /// Computes natural modes about the undeformed state, or about an equilibrium that may start from a given state, one row per mode.
    pub(crate) fn modes(&mut self, model: &Model, settings: &Modes, given: Option<&StartState>) -> RunResult {
        if settings.damped {
            return self.damped_modes(model, settings, given);
        }
        self.begin(&MODE_COLUMNS)?;
        let found = self.state_about(model, settings.about, given).and_then(|s| {
            let found = FoundModes::new(self.assembly, &s, settings.count as usize, self.interrupt)?;
            Ok((s, found))
        });
        let rate = self.summary.scales.time.recip();
        match found {
            // Large residuals indicate an undetected motion without stiffness.
            Ok((_, found)) if found.modes.iter().any(|mode| mode.residual > MAX_RESIDUAL) => {
                Ok(Err(EigenError::Unresolved.into()))
            }
            Ok((about, mut found)) => {
                if model.has_shells() {
                    self.compare_frequencies((model, settings), given.is_some(), &mut found);
                } else if !found.is_nonconservative {
                    self.estimate(model, &about, &mut found.modes);
                }
                self.summary.warnings.extend(self.held_but_zero(&about, found.rigid));
                if found.is_unverified {
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

    /// Estimates the errors of the frequencies of a model with shells on request, by a second solution. `is_given` is true if the
    /// analysis starts in a given state.
    fn compare_frequencies(
        &mut self,
        (model, settings): (&Model, &Modes),
        is_given: bool,
        found: &mut FoundModes,
    ) {
        let (scales, interrupt) = (self.summary.scales, self.interrupt);
        let values = |found: &FoundModes| -> Vec<f64> {
            found.modes.iter().map(|mode| mode.frequency / scales.time).collect()
        };
        let finer = |HalvedModel { model, assembly }: &HalvedModel| {
            let about = state_about((model, assembly, scales), settings.about, None, interrupt)?;
            FoundModes::new(assembly, &about, settings.count as usize, interrupt)
        };
        let given = &*found;
        let compared = |finer: FoundModes| match given.sturm.is_some() && finer.sturm.is_some() {
            _ if finer.rigid != given.rigid => {
                Err("the numbers of zero frequencies of both meshes differ".into())
            }
            false => Err("the number of modes is not verified".to_owned()),
            true => Ok(values(&finer)),
        };
        let obstacle = match given.is_nonconservative {
            true => Some("the loads have no potential"),
            false => is_given.then_some(GIVEN_START),
        };
        let solution = |halved: &HalvedModel| {
            compared(finer(halved).map_err(|error| finer_failure(error, halved, scales))?)
        };
        let frequencies = values(given);
        let errors = self.compare_eigenvalues(model, ("frequency", &frequencies), obstacle, solution);
        found.modes.iter_mut().zip(errors).for_each(|(mode, error)| mode.error = error);
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
}
