mod advice;
mod blame;
mod checkpoint;
mod columns;
mod dynamics;
mod eigen;
mod equilibria;
mod observer;
mod pace;
mod stability;
mod summary;
mod watch;

use std::io;
use std::ops::ControlFlow;

use blame::{Blame, Place};
pub use checkpoint::{Checkpoint, Mismatch};
pub use observer::Observer;
pub use summary::{Outcome, Summary};
use thiserror::Error;
use watch::Watch;

use crate::analysis::{EigenError, EquilibriumError, Failure, Interrupt, SolveError};
use crate::model::{Analysis, Assembly, Chosen, Model, ModelErrors};
use crate::record::Sink;
use crate::scales::Scales;
use crate::system::State;

/// Why a run could not be done or recorded. That the numerics gave up is not an error but an [`Outcome`].
#[derive(Debug, Error)]
pub enum Error {
    /// The model is not valid.
    #[error(transparent)]
    Model(#[from] ModelErrors),
    /// A checkpoint is not one of the simulation.
    #[error(transparent)]
    Checkpoint(#[from] Mismatch),
    /// A sink could not record.
    #[error("results could not be written")]
    Sink(#[from] io::Error),
}

/// Runs a model: check, scale, assemble, analyse, record; the rows are those of [`Simulation::run`].
///
/// # Errors
/// If the model is not valid or a sink fails. What cannot be solved is an [`Outcome`], with all before it recorded.
pub fn simulate(model: &Model, mut sink: &mut dyn Sink) -> Result<Summary, Error> {
    Ok(Simulation::new(model)?.run(&mut sink)?)
}

/// A model that is ready to run: checked, scaled, assembled.
#[derive(Debug)]
pub struct Simulation {
    scaled: Model,
    chosen: Chosen,
    assembly: Assembly,
    interrupt: Interrupt,
}

impl Simulation {
    /// Checks, scales and assembles a model.
    ///
    /// # Errors
    /// All that is wrong with the model.
    pub fn new(model: &Model) -> Result<Self, ModelErrors> {
        model.check()?;
        let chosen = model.scales();
        let scaled = model.scaled(&chosen.scales);
        let moves = scaled.analysis.dynamics().is_some();
        let assembly = if moves { scaled.assemble()? } else { scaled.assemble_static()? };
        Ok(Self { scaled, chosen, assembly, interrupt: Interrupt::default() })
    }

    /// The same, heeding what may end it; such a run has [stopped](Outcome::Stopped).
    #[must_use]
    pub fn heeding(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// The equations of motion, and what reads their states.
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    /// The units in which the equations are solved.
    pub fn scales(&self) -> Scales {
        self.chosen.scales
    }

    /// Carries the analysis out.
    ///
    /// Rows are states of motion or equilibrium with the columns of [`Rows`](crate::Rows), or modes and critical loads with
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
    /// If the observer fails. What cannot be solved is an [`Outcome`], with all before it recorded.
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
        run.summary.warnings.extend(run.seen());
        let Run { mut summary, .. } = run;
        summary.outcome = outcome(ended?, &self.scaled, &self.assembly, summary.scales);
        if self.scaled.analysis.dynamics().is_some() {
            summary.time *= summary.scales.time;
        }
        finished?;
        Ok(summary)
    }
}

/// An analysis under way.
struct Run<'a> {
    assembly: &'a Assembly,
    interrupt: &'a Interrupt,
    observer: &'a mut dyn Observer,
    summary: Summary,
    watch: Watch,
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

impl Reason {
    fn is_interruption(&self) -> bool {
        match self {
            Self::Motion(error, _) => error.failure == Failure::Interrupted,
            Self::Equilibrium(error, _) => error.cause.failure == Failure::Interrupted,
            Self::Eigen(error) => *error == EigenError::Interrupted,
            Self::Mechanism(_) => false,
        }
    }
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

fn outcome(
    ended: Result<ControlFlow<()>, Reason>,
    model: &Model,
    assembly: &Assembly,
    scales: Scales,
) -> Outcome {
    let failed = |time, reason, at, advice| Outcome::Failed { time, reason, at, advice };
    match ended {
        Ok(ControlFlow::Continue(())) => Outcome::Finished,
        Ok(ControlFlow::Break(())) => Outcome::Stopped,
        Err(reason) if reason.is_interruption() => Outcome::Stopped,
        Err(Reason::Motion(error, blame)) => {
            let told = format!("{error}{}", halved(model, &error));
            let Told { reason, at, advice } = Told::of(&error, told, blame, model, assembly, scales);
            failed(error.t * scales.time, reason, at, advice)
        }
        Err(Reason::Equilibrium(error, blame)) => {
            let Told { reason, at, advice } =
                Told::of(&error.cause, error.to_string(), blame, model, assembly, scales);
            failed(error.load, reason, at, advice)
        }
        Err(Reason::Eigen(error)) => {
            failed(0.0, error.to_string(), "the whole system".into(), advice::after_search(error).into())
        }
        Err(Reason::Mechanism(motions)) => {
            let reason = "there is no equilibrium to find: a motion is held by nothing".to_owned();
            failed(0.0, reason, motions, advice::OF_MECHANISMS.into())
        }
    }
}

/// A failed iteration in words.
struct Told {
    reason: String,
    at: String,
    advice: String,
}

impl Told {
    /// By what the iteration says and what else is to blame.
    fn of(
        error: &SolveError,
        said: String,
        blame: Option<Blame>,
        model: &Model,
        assembly: &Assembly,
        scales: Scales,
    ) -> Self {
        let Some(Blame { reason, at, advice }) = blame else {
            let at = assembly.place_of(error, scales.length);
            return Self { reason: said, at, advice: advice::after(error.failure, &model.analysis) };
        };
        let at = match at {
            Place::Words(words) => words,
            Place::Equation(equation) => assembly.name_in(equation, scales.length),
        };
        Self { reason: format!("{reason}: {said}"), at, advice: advice.into() }
    }
}

/// How far a step of fixed size was halved before it was given up.
fn halved(model: &Model, error: &SolveError) -> String {
    let Some(settings) = model.analysis.dynamics() else { return String::new() };
    let halves = settings.step.fixed().is_some() && error.iterations > 0 && settings.max_halvings > 0;
    if halves { format!(", with the step halved {} times", settings.max_halvings) } else { String::new() }
}

/// The motions that nothing holds in a state, if there are any.
fn mechanism(assembly: &Assembly, s: &State, scales: Scales) -> Option<String> {
    let motions: Vec<String> =
        assembly.free_motions(s).into_iter().map(|motion| motion.scaled(scales.length).to_string()).collect();
    (!motions.is_empty()).then(|| motions.join("; "))
}
