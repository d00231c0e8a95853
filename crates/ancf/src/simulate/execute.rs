use std::io;

use super::checkpoint::{Checkpoint, Mismatch};
use super::error::Error;
use super::observer::Observer;
use super::outcome::outcome;
use super::run::{Ended, Run};
use super::simulation::Simulation;
use super::summary::Summary;
use super::{dynamics, eigen, equilibria};
use crate::failure::Watch;
use crate::model::{Analysis, Model};
use crate::record::Sink;
use crate::results::{Column, LOAD, TIME, columns};

/// Runs a model: check, scale, assemble, analyse, record; the rows are those of [`Simulation::run`].
///
/// # Errors
/// If the model is not valid or a sink fails. What cannot be solved is an [`Outcome`](crate::Outcome), with all before it recorded.
pub fn simulate(model: &Model, mut sink: &mut dyn Sink) -> Result<Summary, Error> {
    Ok(Simulation::new(model)?.run(&mut sink)?)
}

impl Simulation {
    /// Carries the analysis out.
    ///
    /// Rows are states of motion or equilibrium with the columns of [`Rows`](crate::results::Rows), or modes and critical loads with
    /// those of the table below. Motion ends with the duration, by a shorter step if that is no multiple of the step.
    ///
    /// | modes, buckling | what |
    /// |---|---|
    /// | `mode` | number from 1 |
    /// | `frequency`, `squared` | ω/2π, not a number where the state is unstable; ω² |
    /// | `factor` | critical load factor |
    /// | `p.x p.y p.z` | displacement of each probe in the shape x, xᵀ M x = 1 |
    ///
    /// # Errors
    /// If the observer fails. What cannot be solved is an [`Outcome`](crate::Outcome), with all before it recorded.
    pub fn run(&self, observer: &mut dyn Observer) -> io::Result<Summary> {
        let (mut run, scaled) = (self.begin(observer), &self.scaled);
        let ended = match &scaled.analysis {
            Analysis::Dynamics(settings) => run.dynamics(self, settings),
            Analysis::Statics(settings) => run.statics(settings),
            Analysis::Path(settings) => run.path(settings),
            Analysis::Modes(settings) => run.modes(scaled, settings),
            Analysis::Buckling(settings) => run.buckling(settings),
        };
        self.end(run, ended)
    }

    /// Goes on with a motion from a checkpoint, to the last bit as if it had never stopped: the observer is told the columns,
    /// and receives the rows from number [`Checkpoint::rows`] on; the summary is that of the whole run.
    ///
    /// Analyses other than motions keep no checkpoints; they are carried out anew.
    ///
    /// # Errors
    /// If the checkpoint is not one of this model, or damaged: nothing is recorded then. If the observer fails.
    pub fn resume(&self, from: &Checkpoint, observer: &mut dyn Observer) -> Result<Summary, Error> {
        let settings = self.scaled.analysis.dynamics().ok_or(Mismatch::Analysis)?;
        let mut run = self.begin(observer);
        let motion = run.restored(self, settings, from)?;
        let ended = run.go_on(motion);
        Ok(self.end(run, ended)?)
    }

    fn begin<'a>(&'a self, observer: &'a mut dyn Observer) -> Run<'a> {
        let Self { chosen, assembly, interrupt, .. } = self;
        let summary = Summary::new(assembly, chosen.clone());
        Run { summary, assembly, interrupt, observer, watch: Watch::over(&self.scaled) }
    }

    fn end(&self, mut run: Run<'_>, ended: Ended) -> io::Result<Summary> {
        // What was recorded is completed even if recording broke off.
        let finished = run.observer.finish();
        let warning = run.watch.warning(run.assembly, run.summary.scales);
        run.summary.warnings.extend(warning);
        let Run { mut summary, .. } = run;
        summary.outcome = outcome(ended?, &self.scaled, &self.assembly, summary.scales);
        if self.scaled.analysis.dynamics().is_some() {
            summary.time *= summary.scales.time;
        }
        finished?;
        Ok(summary)
    }

    /// The columns of its rows.
    pub fn columns(&self) -> Vec<Column> {
        let assembly = &self.assembly;
        match &self.scaled.analysis {
            Analysis::Dynamics(_) => columns(assembly, TIME, &dynamics::OWN),
            Analysis::Statics(_) => columns(assembly, LOAD, &equilibria::OWN),
            Analysis::Path(_) => {
                columns(assembly, LOAD, &[equilibria::OWN.as_slice(), &equilibria::PATH].concat())
            }
            Analysis::Modes(_) => eigen::columns(assembly, &eigen::MODES),
            Analysis::Buckling(_) => eigen::columns(assembly, &eigen::BUCKLING),
        }
    }
}
