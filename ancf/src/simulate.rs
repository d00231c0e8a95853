mod pace;

use std::io;
use std::ops::ControlFlow;

use serde::Serialize;
use thiserror::Error;

use crate::analysis::{SolveError, StepReport};
use crate::model::{self, Analysis, Assembly, Chosen, Model, ModelErrors};
use crate::record::Sink;
use crate::rows::Rows;
use crate::scales::Scales;
use crate::system::{Energy, EquationsOfMotion, State};
use pace::Pace;

/// Why a run could not be done or recorded. That the numerics gave up is not an error but an [`Outcome`].
#[derive(Debug, Error)]
pub enum Error {
    /// The model is not valid.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// A sink could not record.
    #[error("results could not be written")]
    Sink(#[from] io::Error),
}

/// How a run ended. Whatever was recorded until then stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Outcome {
    /// The whole duration was computed.
    Finished,
    /// A sink asked to stop.
    Stopped,
    /// The equations of a step could not be solved.
    Failed {
        /// Time that was to be reached.
        time: f64,
        /// Why, and what may help.
        reason: String,
        /// What the worst equation belongs to.
        at: String,
    },
}

impl Outcome {
    /// Whether the whole duration was computed.
    pub const fn is_finished(&self) -> bool {
        matches!(self, Self::Finished)
    }
}

/// A run in a few numbers, in the user's units.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// How it ended.
    pub outcome: Outcome,
    /// Time reached.
    pub time: f64,
    /// Steps done.
    pub steps: u64,
    /// Steps that had to be divided because Newton's method failed.
    pub divided_steps: u64,
    /// Steps that were tried but found too inaccurate.
    pub rejected_steps: u64,
    /// Steps in which the rounding error of the residual ended the iteration.
    pub floor_steps: u64,
    /// Newton iterations in all.
    pub iterations: u64,
    /// The most iterations of one step.
    pub most_iterations: u32,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Number of multipliers.
    pub multipliers: usize,
    /// Units in which the equations were solved.
    pub scales: Scales,
    /// How the units were chosen.
    pub scales_reason: String,
}

impl Summary {
    fn new(assembly: &Assembly, chosen: Chosen) -> Self {
        Self {
            outcome: Outcome::Finished,
            time: 0.0,
            steps: 0,
            divided_steps: 0,
            rejected_steps: 0,
            floor_steps: 0,
            iterations: 0,
            most_iterations: 0,
            coordinates: assembly.system.coordinates(),
            multipliers: assembly.system.multipliers(),
            scales: chosen.scales,
            scales_reason: chosen.reason,
        }
    }

    fn count(&mut self, report: &StepReport) {
        self.steps += 1;
        self.divided_steps += u64::from(report.substeps > 1);
        self.rejected_steps += u64::from(report.rejected);
        self.floor_steps += u64::from(report.floor);
        self.iterations += u64::from(report.iterations);
        self.most_iterations = self.most_iterations.max(report.iterations);
    }
}

/// Runs a model: check, scale, assemble, integrate, record.
///
/// Columns are those of [`Rows`]; the run ends with the duration, by a shorter step if that is no multiple of the step.
///
/// # Errors
/// If the model is not valid or a sink fails. A step that cannot be solved is an [`Outcome`], with all before it recorded.
pub fn simulate(model: &Model, sink: &mut dyn Sink) -> Result<Summary, Error> {
    model.check()?;
    let chosen = model.scales();
    let scaled = model.scaled(&chosen.scales);
    let assembly = scaled.assemble()?;
    let Analysis::Dynamics(settings) = &scaled.analysis;
    let mut rows = Rows::new(&assembly, chosen.scales);
    let mut summary = Summary::new(&assembly, chosen);
    sink.begin(rows.columns())?;
    let integrated = integrate(&scaled, settings, &assembly, &mut summary, |state, energy, report| {
        sink.record(rows.fill(&assembly, state, energy, report))
    });
    // What was recorded is completed even if recording broke off.
    let finished = sink.finish();
    summary.outcome = outcome(integrated?, &assembly, summary.scales);
    summary.time *= summary.scales.time;
    finished?;
    Ok(summary)
}

/// How an integration ended, in the units of the solver.
type Integrated = Result<ControlFlow<()>, SolveError>;

fn outcome(ended: Integrated, assembly: &Assembly, scales: Scales) -> Outcome {
    match ended {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(error) => Outcome::Failed {
            time: error.t * scales.time,
            reason: error.to_string(),
            at: assembly.name_of(error.worst),
        },
    }
}

/// Steps through a dynamic analysis, handing every recorded instant to `record`.
fn integrate(
    model: &Model,
    settings: &model::Dynamics,
    assembly: &Assembly,
    summary: &mut Summary,
    mut record: impl FnMut(&State, Energy, &StepReport) -> io::Result<ControlFlow<()>>,
) -> io::Result<Integrated> {
    // The loads of a model are constant so far: none jumps.
    let mut pace = match Pace::new(model, settings, assembly, Vec::new()) {
        Ok(pace) => pace,
        Err(error) => return Ok(Err(error)),
    };
    let mut report = StepReport::default();
    loop {
        let flow = record(pace.dynamics().state(), pace.dynamics().energy(), &report)?;
        if flow.is_break() {
            // A sink that breaks on the last instant has stopped nothing.
            return Ok(Ok(if pace.is_over() { ControlFlow::Continue(()) } else { flow }));
        }
        let advanced = pace.advance(|step| summary.count(step));
        summary.time = pace.dynamics().state().t;
        match advanced {
            Ok(Some(done)) => report = done,
            Ok(None) => return Ok(Ok(ControlFlow::Continue(()))),
            Err(error) => return Ok(Err(error)),
        }
    }
}
