use std::io;
use std::ops::ControlFlow;

use ancf_solver::equations::State;
use ancf_solver::newton::Newton;
use ancf_solver::statics::{ArcLengthSteps, EndConditions, Equilibrium, LimitPoint, PathPoint, Response};

use super::finer_equilibria::FinerEquilibria;
use super::run::{AnalysisRun, RunResult, turn_warning};
use crate::assembly::Assembly;
use crate::errors::short;
use crate::estimate::{DiscretisationErrors, GapField, HalvedModel};
use crate::failure::{RunFailure, require_support, unloaded};
use crate::initial::{
    StartState, StaticStart, TurnCounter, equilibrium_failure, load_stepper, require_alignment,
};
use crate::model::{Model, Path, Statics};
use crate::results::{AngleRates, LOAD, Rows};
use crate::units::Scales;

/// Columns of the solver at an equilibrium.
pub(crate) const COLUMNS: [&str; 4] = ["iterations", "residual", "increment", "unstable"];
/// Additional columns of a path.
pub(crate) const PATH_COLUMNS: [&str; 3] = ["length", "slope", "limit"];

/// Values of [`COLUMNS`]. `unstable` is NaN if the factorisation does not determine the inertia.
fn solver_values(found: &Equilibrium) -> [f64; 4] {
    let unstable = found.unstable.map_or(f64::NAN, |count| count as f64);
    [f64::from(found.iterations), found.residual, found.increment, unstable]
}

/// Estimates the errors of the mesh at an equilibrium; those of models with shells on request only, by a second solution.
fn estimate(
    (model, assembly): (&Model, &Assembly),
    s: &State,
    scales: Scales,
    finer: &mut Option<FinerEquilibria<'_>>,
    response: &mut Response<'_>,
) -> Option<DiscretisationErrors> {
    match finer {
        Some(finer) => Some(finer.compare(s)),
        None if model.has_shells() => None,
        None => DiscretisationErrors::new(&GapField::new(model, assembly, s), scales, response),
    }
}

impl AnalysisRun<'_> {
    fn count_equilibrium(&mut self, load: f64, found: &Equilibrium) {
        let summary = &mut self.summary;
        summary.time = load;
        summary.steps += 1;
        summary.divided_steps += u64::from(found.attempts > 1);
        summary.floor_steps += u64::from(found.floor);
        summary.iterations += u64::from(found.iterations);
        summary.most_iterations = summary.most_iterations.max(found.iterations);
        self.stability.add(load, found.unstable);
    }

    /// Adds the warnings of unstable equilibria up to the last one, `s`.
    fn warn_of_instability(&mut self, s: &State, path: bool) {
        let warnings = self.stability.warnings(self.assembly, s, self.summary.scales, path);
        self.summary.warnings.extend(warnings);
    }

    /// Runs a static analysis by load increments, from a given state or the undeformed one, and records each equilibrium.
    pub(crate) fn statics(
        &mut self,
        model: &Model,
        settings: &Statics,
        given: Option<&StartState>,
    ) -> RunResult {
        let assembly = self.assembly;
        let mut rows = Rows::new(assembly, self.summary.scales, LOAD, &COLUMNS);
        if let Some(given) = given {
            rows.start_turns(&given.angles);
        }
        self.observer.begin(&rows.columns())?;
        let StaticStart { state, system } = match StaticStart::new((model, settings.load), assembly, given) {
            Ok(start) => start,
            Err(reason) => return Ok(Err(reason)),
        };
        if let Err(reason) = require_support(assembly, &state, self.summary.scales) {
            return Ok(Err(reason));
        }
        self.summary.initial = given.map(StartState::released);
        let prepared = load_stepper(&system, settings, state, self.interrupt).and_then(|mut statics| {
            statics.include_near_terms()?;
            TurnCounter::new(&system, statics.state(), &rows).map(|turns| (statics, turns))
        });
        let (mut statics, mut turns) = match prepared {
            Ok(prepared) => prepared,
            Err(error) => return Ok(Err(error.into())),
        };
        turns.count(&mut rows, statics.state());
        let (none, energy) = (solver_values(&Equilibrium::default()), statics.energy());
        let first = rows.fill(assembly, statics.state(), 0.0, &none, energy, None);
        let mut written = self.observer.record(first, statics.state());
        if flow(&written).is_break() {
            return conclude(written?, false, Ok::<_, RunFailure>(()));
        }
        let (scales, start) = (self.summary.scales, (settings, given.is_some()));
        let halved = HalvedModel::requested(model);
        let new = |halved| FinerEquilibria::new((model, assembly, scales), halved, start, self.interrupt);
        let mut finer = halved.as_ref().map(new);
        let ended = statics.advance_with(settings.load, |s, found, response| {
            self.count_equilibrium(s.load, found);
            turns.count(&mut rows, s);
            if assembly.output.errors {
                let errors = estimate((model, assembly), s, scales, &mut finer, response);
                let values = errors.iter().flat_map(|errors| &errors.values);
                rows.set_errors(values.map(|value| (value.column.as_str(), value.error)));
            }
            written = self
                .observer
                .record(rows.fill(assembly, s, s.load, &solver_values(found), found.energy, None), s);
            flow(&written)
        });
        self.warn_of_instability(statics.state(), false);
        let ended = match ended {
            Ok(_) => {
                let mut found = statics.into_response();
                let (state, mut response) = found.parts();
                let errors = estimate((model, assembly), state, scales, &mut finer, &mut response);
                self.summary.warnings.extend(errors.iter().filter_map(DiscretisationErrors::warning));
                self.summary.errors = errors;
                require_alignment(assembly, state)
            }
            Err(error) => Err(equilibrium_failure(assembly, statics.state(), error)),
        };
        self.summary.warnings.extend(turn_warning(&rows, "load factor", 1.0));
        conclude(written?, settings.load == self.summary.time, ended)
    }

    /// Traces an equilibrium path and records each point.
    pub(crate) fn path(&mut self, settings: &Path) -> RunResult {
        let assembly = self.assembly;
        let mut rows =
            Rows::new(assembly, self.summary.scales, LOAD, &[COLUMNS.as_slice(), &PATH_COLUMNS].concat());
        self.observer.begin(&rows.columns())?;
        let start = unloaded(assembly);
        if let Err(reason) = require_support(assembly, &start, self.summary.scales) {
            return Ok(Err(reason));
        }
        let steps = ArcLengthSteps { largest: settings.largest, ..ArcLengthSteps::from(settings.first) };
        let system = &assembly.system;
        let newton = Newton::new(system.matrix(), settings.stop.into(), settings.max_iterations);
        let path = newton
            .map_err(RunFailure::from)
            .map(|newton| newton.with_interrupt(self.interrupt.clone()))
            .and_then(|newton| {
                ancf_solver::statics::ArcLength::new(system, newton, steps, start).map_err(RunFailure::from)
            });
        let mut path = match path {
            Ok(path) => path,
            Err(reason) => return Ok(Err(reason)),
        };
        rows.count_turns(0.0, path.state(), AngleRates::Differences);
        let none = [solver_values(&Equilibrium::default()).as_slice(), &[0.0; 3]].concat();
        let first = rows.fill(assembly, path.state(), 0.0, &none, path.energy(), None);
        let mut written = self.observer.record(first, path.state());
        if flow(&written).is_break() {
            return conclude(written?, false, Ok::<_, RunFailure>(()));
        }
        let until =
            EndConditions { load: Some(settings.load), points: settings.points, length: f64::INFINITY };
        let ended = path.follow(&until, |s, point| {
            self.count_equilibrium(s.load, &point.equilibrium);
            rows.count_turns(point.length, s, AngleRates::Differences);
            let (values, energy) = (path_values(point), point.equilibrium.energy);
            written = self.observer.record(rows.fill(assembly, s, s.load, &values, energy, None), s);
            flow(&written)
        });
        self.warn_of_instability(path.state(), true);
        let ended = ended.map_err(|error| equilibrium_failure(assembly, path.state(), error));
        if ended.is_ok() && flow(&written).is_continue() && self.summary.time != settings.load {
            self.summary.warnings.push(format!(
                "the path ended after {} points (`analysis.points`) at load factor {}, before it reached {}",
                settings.points,
                short(self.summary.time),
                short(settings.load)
            ));
        }
        self.summary.warnings.extend(turn_warning(&rows, "arc length", 1.0));
        conclude(written?, settings.load == self.summary.time, ended)
    }
}

/// Values of [`COLUMNS`] and [`PATH_COLUMNS`]. `limit` is 1 at a maximum of the load, −1 at a minimum, 0 elsewhere.
fn path_values(point: &PathPoint) -> Vec<f64> {
    let limit = match point.limit {
        None => 0.0,
        Some(LimitPoint::Maximum) => 1.0,
        Some(LimitPoint::Minimum) => -1.0,
    };
    [solver_values(&point.equilibrium).as_slice(), &[point.length, point.slope, limit]].concat()
}

fn flow(written: &io::Result<ControlFlow<()>>) -> ControlFlow<()> {
    written.as_ref().map_or(ControlFlow::Break(()), |flow| *flow)
}

/// Result of a static analysis. A stop request at the last equilibrium has no effect.
fn conclude<T, E: Into<RunFailure>>(written: ControlFlow<()>, done: bool, ended: Result<T, E>) -> RunResult {
    Ok(match ended {
        Err(error) => Err(error.into()),
        Ok(_) if done => Ok(ControlFlow::Continue(())),
        Ok(_) => Ok(written),
    })
}
