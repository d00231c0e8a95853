mod blame;
mod dynamics;
mod eigen;
mod equilibria;
mod pace;

use std::io;
use std::ops::ControlFlow;

use blame::Blame;
use serde::Serialize;
use thiserror::Error;

use crate::analysis::{EigenError, EquilibriumError, SolveError, StepReport};
use crate::model::{Analysis, Assembly, Chosen, Model, ModelErrors};
use crate::record::Sink;
use crate::scales::Scales;
use crate::system::{EquationsOfMotion, State};

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
        /// Time that was to be reached; in statics, the load factor.
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
    /// Time reached; in statics, the load factor.
    pub time: f64,
    /// Steps done; in statics equilibria, modes or critical loads found.
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
    /// Joint equations that follow from others, in words.
    pub redundant: Vec<String>,
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
            redundant: assembly.redundant().iter().map(ToString::to_string).collect(),
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

/// Runs a model: check, scale, assemble, analyse, record.
///
/// Rows are states of motion or equilibrium with the columns of [`Rows`](crate::Rows), or modes and critical loads with those of
/// the table below. Motion ends with the duration, by a shorter step if that is no multiple of the step.
///
/// | modes, buckling | what |
/// |---|---|
/// | `mode` | number from 1 |
/// | `frequency`, `squared` | ω/2π, not a number where the state is unstable; ω² |
/// | `factor` | critical load factor |
/// | `p.x p.y p.z` | displacement of each probe in the shape x, xᵀ M x = 1 |
///
/// # Errors
/// If the model is not valid or a sink fails. What cannot be solved is an [`Outcome`], with all before it recorded.
pub fn simulate(model: &Model, sink: &mut dyn Sink) -> Result<Summary, Error> {
    model.check()?;
    let chosen = model.scales();
    let scaled = model.scaled(&chosen.scales);
    let moves = scaled.analysis.dynamics().is_some();
    let assembly = if moves { scaled.assemble()? } else { scaled.assemble_static()? };
    let mut run = Run { summary: Summary::new(&assembly, chosen), assembly: &assembly, sink };
    let ended = match &scaled.analysis {
        Analysis::Dynamics(settings) => run.dynamics(&scaled, settings),
        Analysis::Statics(settings) => run.statics(settings),
        Analysis::Path(settings) => run.path(settings),
        Analysis::Modes(settings) => run.modes(&scaled, settings),
        Analysis::Buckling(settings) => run.buckling(settings),
    };
    // What was recorded is completed even if recording broke off.
    let finished = run.sink.finish();
    let Run { mut summary, .. } = run;
    summary.outcome = outcome(ended?, &assembly, summary.scales);
    if moves {
        summary.time *= summary.scales.time;
    }
    finished?;
    Ok(summary)
}

/// An analysis under way.
struct Run<'a> {
    assembly: &'a Assembly,
    sink: &'a mut dyn Sink,
    summary: Summary,
}

/// How an analysis ended, in the units of the solver: finished or stopped by a sink, or why not.
type Ended = io::Result<Result<ControlFlow<()>, Reason>>;

/// Why an analysis could not go on.
enum Reason {
    Motion(SolveError, Option<Blame>),
    Equilibrium(EquilibriumError, Option<Blame>),
    Eigen(EigenError),
    /// Motions that nothing holds, in words.
    Mechanism(String),
}

impl From<SolveError> for Reason {
    fn from(error: SolveError) -> Self {
        Self::Motion(error, None)
    }
}

impl From<EquilibriumError> for Reason {
    fn from(error: EquilibriumError) -> Self {
        Self::Equilibrium(error, None)
    }
}

impl From<EigenError> for Reason {
    fn from(error: EigenError) -> Self {
        Self::Eigen(error)
    }
}

fn outcome(ended: Result<ControlFlow<()>, Reason>, assembly: &Assembly, scales: Scales) -> Outcome {
    let failed = |time, reason, at| Outcome::Failed { time, reason, at };
    match ended {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(Reason::Motion(error, blame)) => {
            let (reason, at) = blamed(error.to_string(), blame, assembly.name_of(error.worst));
            failed(error.t * scales.time, reason, at)
        }
        Err(Reason::Equilibrium(error, blame)) => {
            let (reason, at) = blamed(error.to_string(), blame, assembly.name_of(error.cause.worst));
            failed(error.load, reason, at)
        }
        Err(Reason::Eigen(error)) => failed(0.0, error.to_string(), "the whole system".into()),
        Err(Reason::Mechanism(motions)) => {
            let reason = "there is no equilibrium to find: a motion is held by nothing".to_owned();
            failed(0.0, reason, motions)
        }
    }
}

/// Reason and place of a failure, which joints may be to blame for.
fn blamed(reason: String, blame: Option<Blame>, at: String) -> (String, String) {
    match blame {
        Some(Blame { reason: why, at }) => (format!("{why}: {reason}"), at),
        None => (reason, at),
    }
}

/// The motions that nothing holds in a state, if there are any.
fn mechanism(assembly: &Assembly, s: &State, scales: Scales) -> Option<String> {
    let motions: Vec<String> =
        assembly.free_motions(s).into_iter().map(|motion| motion.scaled(scales.length).to_string()).collect();
    (!motions.is_empty()).then(|| motions.join("; "))
}
