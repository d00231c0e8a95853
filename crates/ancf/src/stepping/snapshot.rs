use ancf_mechanics::functions::InputTransition;
use ancf_solver::dynamics::{AdaptiveCheckpoint, StepReport, StepperCheckpoint};
use serde::{Deserialize, Serialize};

use super::events::PassedEvents;
use super::step_error::StepError;
use super::stepper::{Setting, Stepper};
use crate::failure::{AlternationHistory, RotationHistory};
use crate::results::RowHistory;
use crate::simulate::{StepCounts, fingerprint, hash_of};

/// Everything on which later steps depend.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Snapshot {
    /// Hash of the model.
    model: u64,
    counts: StepCounts,
    report: StepReport,
    rows: RowHistory,
    rotations: RotationHistory,
    alternations: AlternationHistory,
    passed: PassedEvents,
    inputs: Vec<InputTransition>,
    pending: Vec<Option<Setting>>,
    dynamics: StepperCheckpoint,
    adaptive: Option<AdaptiveCheckpoint>,
}

/// First bytes of a snapshot. The last of them is the version of the format.
const HEAD: [u8; 8] = *b"ANCFSS\0\x04";
/// Length of the hash at the end.
const HASH: usize = 8;

const DAMAGED: &str = "the snapshot is damaged";

fn damaged() -> StepError {
    StepError::Snapshot(DAMAGED.into())
}

impl Stepper {
    /// Snapshot of everything on which later steps depend. Steps after [`restore`](Self::restore) are bit-identical, also in another
    /// process.
    ///
    /// For n coordinates and m multipliers it has about 8 (9n + 3m) bytes, and 40n more after a step that was shorter than the one
    /// before. External functions of the program are not contained.
    ///
    /// # Errors
    /// If the bytes do not fit into memory.
    pub fn save(&self) -> Result<Vec<u8>, StepError> {
        let simulation = &self.simulation;
        let snapshot = Snapshot {
            model: self.model_hash(),
            counts: StepCounts::of(&self.summary),
            report: self.report,
            rows: self.rows.history(),
            rotations: self.monitors.rotations.history().clone(),
            alternations: self.monitors.alternations.history().clone(),
            passed: self.events.passed(),
            inputs: simulation.inputs.iter().map(|input| input.transition()).collect(),
            pending: self.pending.clone(),
            dynamics: self.dynamics.checkpoint(),
            adaptive: self.adaptive.as_ref().map(|adaptive| adaptive.checkpoint()),
        };
        let bytes = postcard::to_extend(&snapshot, HEAD.to_vec());
        let mut bytes = bytes.map_err(|error| StepError::Snapshot(error.to_string()))?;
        let hash = hash_of(&bytes);
        bytes.extend_from_slice(&hash.to_le_bytes());
        Ok(bytes)
    }

    /// Continues from a snapshot of the same model and the same version.
    ///
    /// # Errors
    /// If the bytes are damaged or belong to another model. Nothing has changed then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), StepError> {
        let snapshot = read(bytes)?;
        if snapshot.model != self.model_hash() {
            let text = "the snapshot belongs to another model, or to this model before a change";
            return Err(StepError::Snapshot(text.into()));
        }
        if !self.accepts(&snapshot) {
            return Err(damaged());
        }
        let own = read(&self.save()?)?;
        let restored = self.continue_from(&snapshot);
        if restored.is_err() {
            // Cannot fail: it is the present state.
            self.continue_from(&own)?;
        }
        restored
    }

    fn model_hash(&self) -> u64 {
        *self.fingerprint.get_or_init(|| fingerprint(&self.simulation))
    }

    fn accepts(&self, snapshot: &Snapshot) -> bool {
        let count = self.simulation.inputs.len();
        let Snapshot { inputs, pending, adaptive, passed, .. } = snapshot;
        inputs.len() == count
            && pending.len() == count
            && inputs.iter().all(|one| one.is_valid())
            && pending.iter().flatten().all(|one| one.is_valid())
            && passed.is_valid()
            && adaptive.is_some() == self.adaptive.is_some()
    }

    fn continue_from(&mut self, snapshot: &Snapshot) -> Result<(), StepError> {
        let former: Vec<_> = self.simulation.inputs.iter().map(|input| input.transition()).collect();
        let set = |to: &[InputTransition]| {
            self.simulation.inputs.iter().zip(to).for_each(|(signal, one)| signal.set(*one));
        };
        // The tangents depend on the inputs.
        set(&snapshot.inputs);
        let Self { dynamics, adaptive, rows, monitors, .. } = self;
        let is_adaptive = match (adaptive, &snapshot.adaptive) {
            (Some(adaptive), Some(one)) => adaptive.restore(one).is_ok(),
            _ => true,
        };
        let is_restored = is_adaptive
            && dynamics.restore(&snapshot.dynamics).is_ok()
            && rows.restore(&snapshot.rows)
            && monitors.rotations.restore(&snapshot.rotations)
            && monitors.alternations.restore(&snapshot.alternations);
        if !is_restored {
            set(&former);
            return Err(damaged());
        }
        snapshot.counts.copy_to(&mut self.summary);
        self.report = snapshot.report;
        self.events.restore(snapshot.passed);
        self.pending.clone_from(&snapshot.pending);
        self.is_row_current = false;
        Ok(())
    }
}

/// Reads a snapshot and checks its hash.
fn read(bytes: &[u8]) -> Result<Snapshot, StepError> {
    if bytes.get(..HEAD.len() - 1) != Some(&HEAD[..HEAD.len() - 1]) {
        return Err(StepError::Snapshot("the bytes are not a snapshot of a simulation".into()));
    }
    if bytes.get(HEAD.len() - 1) != HEAD.last() {
        return Err(StepError::Snapshot("the snapshot was made by another version of ancf".into()));
    }
    let end = bytes.len().checked_sub(HASH).filter(|end| *end >= HEAD.len()).ok_or_else(damaged)?;
    let (contents, hash) = bytes.split_at(end);
    if hash_of(contents).to_le_bytes() != hash {
        return Err(damaged());
    }
    postcard::from_bytes(&contents[HEAD.len()..]).map_err(|_| damaged())
}
