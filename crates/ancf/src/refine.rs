//! Refinement of the mesh of a model to a requested error.

use std::io;
use std::ops::ControlFlow;

use crate::errors::percentage;
use crate::estimate::{MeshStep, Refinement, RefinementStep};
use crate::model::{Analysis, Model};
use crate::record::Sink;
use crate::solver::newton::Interrupt;
use crate::{Error, Outcome, Simulation, Summary};

/// Model on the last mesh of a refinement.
#[derive(Debug)]
pub struct RefinedModel {
    /// The model.
    pub model: Model,
    /// Its simulation.
    pub simulation: Simulation,
    /// Meshes and their errors.
    pub history: RefinementHistory,
}

/// Meshes of a refinement to a requested error.
#[derive(Clone, Debug)]
pub struct RefinementHistory {
    requested: f64,
    meshes: Vec<MeshStep>,
    /// Reason for which the error is larger than requested.
    reason: Option<String>,
}

impl RefinementHistory {
    /// Adds the meshes to the summary of a run, and a warning if the requested error is not reached.
    pub fn add_to(&self, summary: &mut Summary) {
        summary.meshes.clone_from(&self.meshes);
        let requested = percentage(self.requested);
        let warning = |reason| format!("the error of {requested} is not reached: {reason}");
        summary.warnings.extend(self.reason.as_ref().map(warning));
    }
}

/// True if meshes of an analysis can be refined by the estimated error: those of statics, modes and buckling.
pub const fn can_refine(analysis: &Analysis) -> bool {
    !matches!(analysis, Analysis::Dynamics(_) | Analysis::Path(_))
}

/// Runs a model on finer meshes until the estimated error is as small as requested, or cannot be reduced.
///
/// `on_mesh` receives the number of each mesh and its error. Models with shells get `output.errors = true`.
///
/// # Errors
/// If a model is not valid.
pub fn refine(
    model: &Model,
    requested: f64,
    interrupt: &Interrupt,
    mut on_mesh: impl FnMut(usize, &MeshStep),
) -> Result<RefinedModel, Error> {
    let (mut model, mut refinement) = (model.clone(), Refinement::new(requested));
    let is_damped = matches!(&model.analysis, Analysis::Modes(modes) if modes.damped);
    model.output.errors |= model.has_shells() && !is_damped;
    loop {
        let simulation = Simulation::new(&model)?.with_interrupt(interrupt.clone());
        let summary = simulation.run(&mut (&mut Discard as &mut dyn Sink))?;
        let step = if summary.outcome.is_finished() {
            refinement.advance(&model, summary.errors.as_ref())
        } else if summary.outcome == Outcome::Stopped {
            RefinementStep::Ended("the run was stopped".into())
        } else {
            refinement.advance_failed(&model)
        };
        if let Some(mesh) = refinement.meshes().last().filter(|_| summary.outcome != Outcome::Stopped) {
            on_mesh(refinement.meshes().len(), mesh);
        }
        let reason = match step {
            RefinementStep::Next(next) => {
                model = *next;
                continue;
            }
            RefinementStep::Reached => None,
            RefinementStep::Ended(reason) => Some(reason),
        };
        let history = RefinementHistory { requested, meshes: refinement.meshes().to_vec(), reason };
        return Ok(RefinedModel { model, simulation, history });
    }
}

/// Sink without a record.
struct Discard;

impl Sink for Discard {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64]) -> io::Result<ControlFlow<()>> {
        Ok(ControlFlow::Continue(()))
    }
}
