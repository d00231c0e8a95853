use std::io::{self, Write as _};

use ancf_solver::equations::EquationsOfMotion;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::error_estimate::{ErrorEstimate, ErrorEstimateCheckpoint};
use super::simulation::Simulation;
use super::step_control::{MAX_COUNT, StepControl, StepControlCheckpoint};
use super::summary::Summary;
use crate::failure::{
    AlternationHistory, AlternationMonitor, RotationHistory, RotationMonitor, StabilityMonitor,
};
use crate::initial::InitialState;
use crate::model::Model;
use crate::results::{RowHistory, Rows};

/// State of a dynamic analysis, from which [`Simulation::resume`] continues with bit-identical results.
///
/// A checkpoint requires a format that stores numbers exactly, such as a binary one. For n coordinates and m multipliers it has
/// about 8 (7n + 2m) bytes, with estimated errors five times as many, and those of models with shells also those of the finer
/// mesh. Reused tangents add 8 (3n + m), error control adds 8 (n + m), a start
/// in another state than the undeformed one 8 (3n + m), and each active contact pair a few.
///
/// A checkpoint is valid for the same model and the same version of this library. External functions must be the same and must
/// return the same values for the same arguments.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Checkpoint {
    version: u32,
    /// Hash of the model.
    model: u64,
    time: f64,
    counts: StepCounts,
    rows: RowHistory,
    /// State from which the motion started, unless it is the undeformed state. The initialisation is repeated with it.
    initial: Option<InitialState>,
    estimate: Option<ErrorEstimateCheckpoint>,
    monitor: StabilityMonitor,
    rotations: RotationHistory,
    alternations: AlternationHistory,
    control: StepControlCheckpoint,
}

/// Step and iteration counts of the [`Summary`].
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub(crate) struct StepCounts {
    steps: u64,
    divided_steps: u64,
    rejected_steps: u64,
    floor_steps: u64,
    iterations: u64,
    most_iterations: u32,
}

/// Error of [`Simulation::resume`]: the checkpoint does not belong to the simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum ResumeError {
    /// The analysis is not dynamic.
    #[error("only dynamic analyses continue from checkpoints: run this analysis again")]
    Analysis,
    /// The checkpoint has the format of another version.
    #[error(
        "the checkpoint has format {found} of another version of ancf, expected format {expected}: run the model again"
    )]
    Version {
        /// Format of the checkpoint.
        found: u32,
        /// Format of this version.
        expected: u32,
    },
    /// The checkpoint belongs to another model.
    #[error("the checkpoint belongs to another model, or to this model before a change: run the model again")]
    Model,
    /// The checkpoint has invalid contents.
    #[error("the checkpoint is damaged: use an earlier one, or run the model again")]
    Damaged,
}

/// Version of the format and of the algorithm.
const VERSION: u32 = 14;

impl Checkpoint {
    /// Number of rows recorded before the checkpoint. The next row has this number, counted from 0.
    pub fn rows(&self) -> u64 {
        self.control.rows()
    }

    /// Time, in the user's units.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// State from which the motion started.
    pub(crate) fn initial(&self, simulation: &Simulation) -> InitialState {
        let undeformed = || InitialState::undeformed(&simulation.scaled, &simulation.assembly);
        self.initial.clone().unwrap_or_else(undeformed)
    }

    pub(crate) fn new(
        model: u64,
        summary: &Summary,
        (monitor, rotations, alternations): (&StabilityMonitor, &RotationMonitor, &AlternationMonitor),
        (rows, estimate): (&Rows, Option<&ErrorEstimate<'_>>),
        initial: &InitialState,
        control: &StepControl<'_>,
    ) -> Self {
        let control = control.checkpoint();
        let time = control.time() * summary.scales.time;
        let (rows, monitor, rotations) = (rows.history(), monitor.clone(), rotations.history().clone());
        let alternations = alternations.history().clone();
        let estimate = estimate.map(ErrorEstimate::checkpoint);
        Self {
            version: VERSION,
            model,
            time,
            counts: StepCounts::of(summary),
            rows,
            initial: initial.report.is_some().then(|| initial.clone()),
            estimate,
            monitor,
            rotations,
            alternations,
            control,
        }
    }

    /// Checks version, model and ranges. The state itself is checked by [`restore`](Self::restore).
    pub(crate) fn check(&self, simulation: &Simulation) -> Result<(), ResumeError> {
        if self.version != VERSION {
            return Err(ResumeError::Version { found: self.version, expected: VERSION });
        }
        if self.model != fingerprint(simulation) {
            return Err(ResumeError::Model);
        }
        let StepCounts { steps, divided_steps, rejected_steps, floor_steps, iterations, .. } = self.counts;
        let counts = [steps, divided_steps, rejected_steps, floor_steps, iterations];
        let coordinates = simulation.assembly.system.coordinates();
        let is_undeformed = simulation.scaled.starts_undeformed();
        let is_initial =
            self.initial.as_ref().map_or(is_undeformed, |initial| initial.is_valid(&simulation.assembly));
        let is_time = self.time == self.control.time() * simulation.scales().time;
        if is_initial
            && is_time
            && self.monitor.is_valid_for(coordinates)
            && counts.iter().all(|count| *count <= MAX_COUNT)
        {
            Ok(())
        } else {
            Err(ResumeError::Damaged)
        }
    }

    /// Restores the state of a run.
    pub(crate) fn restore(
        &self,
        summary: &mut Summary,
        (monitor, rotations, alternations): (
            &mut StabilityMonitor,
            &mut RotationMonitor,
            &mut AlternationMonitor,
        ),
        (rows, estimate): (&mut Rows, Option<&mut ErrorEstimate<'_>>),
        control: &mut StepControl<'_>,
    ) -> Result<(), ResumeError> {
        let is_estimate_restored = match (estimate, &self.estimate) {
            (Some(estimate), Some(checkpoint)) => estimate.restore(checkpoint),
            (None, None) => true,
            _ => false,
        };
        if !is_estimate_restored
            || !rows.restore(&self.rows)
            || !rotations.restore(&self.rotations)
            || !alternations.restore(&self.alternations)
            || control.restore(&self.control).is_err()
        {
            return Err(ResumeError::Damaged);
        }
        self.counts.copy_to(summary);
        monitor.clone_from(&self.monitor);
        summary.time = self.control.time();
        Ok(())
    }
}

impl StepCounts {
    pub(crate) fn of(summary: &Summary) -> Self {
        Self {
            steps: summary.steps,
            divided_steps: summary.divided_steps,
            rejected_steps: summary.rejected_steps,
            floor_steps: summary.floor_steps,
            iterations: summary.iterations,
            most_iterations: summary.most_iterations,
        }
    }

    pub(crate) fn copy_to(self, summary: &mut Summary) {
        summary.steps = self.steps;
        summary.divided_steps = self.divided_steps;
        summary.rejected_steps = self.rejected_steps;
        summary.floor_steps = self.floor_steps;
        summary.iterations = self.iterations;
        summary.most_iterations = self.most_iterations;
    }
}

/// Hash of the model in solver units, and of these units. It is not cryptographic.
///
/// Source: Fowler, Noll & Vo, FNV-1a of 64 bits.
pub(crate) fn fingerprint(simulation: &Simulation) -> u64 {
    let mut hash = Fnv1a(FNV_START);
    // Cannot fail: the model is plain data, and writing to the hash has no errors.
    let _ = serde_json::to_writer(&mut hash, &(&simulation.scaled, &simulation.scales()));
    if simulation.scaled.is_extended() {
        // Parts of a program's own kinds are not data of the model.
        let Model { joints, loads, sections, .. } = &simulation.scaled;
        let _ = write!(hash, "{joints:?} {loads:?} {sections:?}");
    }
    hash.0
}

/// Hash of bytes, to detect damage.
pub(crate) fn hash_of(bytes: &[u8]) -> u64 {
    let mut hash = Fnv1a(FNV_START);
    let _ = hash.write_all(bytes);
    hash.0
}

const FNV_START: u64 = 0xcbf2_9ce4_8422_2325;

struct Fnv1a(u64);

impl io::Write for Fnv1a {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
