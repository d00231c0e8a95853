use std::io;

use super::error::Error;
use super::run::{AnalysisRun, Checkpoint, Observer, ResumeError, RunResult, Simulation, Summary, outcome};
use super::{dynamics, eigen, equilibria};
use crate::failure::{EquilibriumStability, StabilityMonitor};
use crate::initial::StartState;
use crate::model::{Analysis, Model, Modes};
use crate::record::Sink;
use crate::results::{Column, LOAD, TIME, columns};

/// Checks, scales and assembles a model, runs its analysis and records the rows of [`Simulation::run`].
///
/// # Errors
/// If the model is not valid or the sink fails. A failed computation is an [`Outcome`](crate::Outcome); earlier rows are
/// recorded.
pub fn simulate(model: &Model, mut sink: &mut dyn Sink) -> Result<Summary, Error> {
    Ok(Simulation::new(model)?.run(&mut sink)?)
}

impl Simulation {
    /// Runs the analysis.
    ///
    /// Rows of dynamics, statics and paths are states with the columns of [`Rows`](crate::results::Rows). Rows of modes and
    /// buckling have the columns of the table. The last time step is shorter if the duration is not a multiple of the step, and up
    /// to 1 % longer if the remainder is smaller than that.
    ///
    /// | modes, buckling | content |
    /// |---|---|
    /// | `mode` | number from 1 |
    /// | `frequency`, `squared` | ω/2π, NaN if ω² < 0; ω² |
    /// | `factor` | critical load factor |
    /// | `frequency_error`, `factor_error` | estimate of the exact value less the computed one; NaN if it is not known |
    /// | `p.x p.y p.z` | displacement of each probe in the shape x, xᵀ M x = 1 |
    ///
    /// # Errors
    /// If the observer fails. A failed computation is an [`Outcome`](crate::Outcome); earlier rows are recorded.
    pub fn run(&self, observer: &mut dyn Observer) -> io::Result<Summary> {
        self.run_with(None, observer)
    }

    /// Runs the analysis from a given state instead of the state of the model.
    ///
    /// Dynamics starts there at `initial.start_time`: positions and velocities are projected onto the constraints, and the initial
    /// velocities of the bodies of the model are added. Statics and modes about an equilibrium release the positions to the
    /// equilibrium in proportion to the load factor. Paths and critical loads ignore the state.
    ///
    /// # Errors
    /// As [`run`](Self::run).
    pub fn run_from(&self, start: &StartState, observer: &mut dyn Observer) -> io::Result<Summary> {
        self.run_with(Some(start), observer)
    }

    fn run_with(&self, start: Option<&StartState>, observer: &mut dyn Observer) -> io::Result<Summary> {
        let (mut run, scaled) = (self.begin(observer), &self.scaled);
        let result = match &scaled.analysis {
            Analysis::Dynamics(settings) => run.dynamics(self, settings, start),
            Analysis::Statics(settings) => run.statics(scaled, settings, start),
            Analysis::Path(settings) => run.path(settings),
            Analysis::Modes(settings) => run.modes(scaled, settings, start),
            Analysis::Buckling(settings) => run.buckling(scaled, settings),
        };
        self.end(run, result)
    }

    /// Continues a dynamic analysis from a checkpoint. Results are bit-identical to an uninterrupted run.
    ///
    /// The observer receives the columns, and the rows from number [`Checkpoint::rows`] on. The summary is that of the whole
    /// run. Analyses of other kinds have no checkpoints.
    ///
    /// # Errors
    /// If the checkpoint belongs to another model or is damaged: nothing is recorded. If the observer fails.
    pub fn resume(&self, from: &Checkpoint, observer: &mut dyn Observer) -> Result<Summary, Error> {
        let settings = self.scaled.analysis.dynamics().ok_or(ResumeError::Analysis)?;
        let mut run = self.begin(observer);
        let motion = run.restored(self, settings, from)?;
        let result = run.continue_dynamics(motion);
        Ok(self.end(run, result)?)
    }

    fn begin<'a>(&'a self, observer: &'a mut dyn Observer) -> AnalysisRun<'a> {
        let Self { chosen, assembly, interrupt, .. } = self;
        let mut summary = Summary::new(assembly, chosen.clone());
        summary.warnings = self.warnings.clone();
        summary.inputs = self.scaled.inputs.iter().map(|input| (input.name.clone(), input.value)).collect();
        let (monitor, stability) = (StabilityMonitor::new(&self.scaled), EquilibriumStability::default());
        AnalysisRun { summary, assembly, interrupt, observer, monitor, stability }
    }

    fn end(&self, mut run: AnalysisRun<'_>, result: RunResult) -> io::Result<Summary> {
        // The record is completed even if recording failed.
        let finished = run.observer.finish();
        let warning = run.monitor.warning(run.assembly, run.summary.scales);
        run.summary.warnings.extend(warning);
        let AnalysisRun { mut summary, .. } = run;
        summary.outcome = outcome(result?, &self.scaled, &self.assembly, summary.scales);
        if self.scaled.analysis.dynamics().is_some() {
            summary.time *= summary.scales.time;
        }
        finished?;
        Ok(summary)
    }

    /// Columns of the rows.
    pub fn columns(&self) -> Vec<Column> {
        let assembly = &self.assembly;
        match &self.scaled.analysis {
            Analysis::Dynamics(_) => columns(assembly, TIME, &dynamics::COLUMNS),
            Analysis::Statics(_) => columns(assembly, LOAD, &equilibria::COLUMNS),
            Analysis::Path(_) => {
                columns(assembly, LOAD, &[equilibria::COLUMNS.as_slice(), &equilibria::PATH_COLUMNS].concat())
            }
            Analysis::Modes(Modes { damped: true, .. }) => eigen::columns(assembly, &eigen::DAMPED_COLUMNS),
            Analysis::Modes(_) => eigen::columns(assembly, &eigen::MODE_COLUMNS),
            Analysis::Buckling(_) => eigen::columns(assembly, &eigen::BUCKLING_COLUMNS),
        }
    }
}
