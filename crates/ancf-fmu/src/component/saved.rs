use serde::{Deserialize, Serialize};

use super::fault::Fault;
use super::instance::{Instance, Phase};

/// Complete state of an instance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct SavedState {
    token: String,
    phase: Phase,
    parameters: Vec<f64>,
    inputs: Vec<f64>,
    targets: Vec<Option<f64>>,
    stop: Option<f64>,
    motion: Option<SavedMotion>,
}

/// Snapshot of a motion with the values with which it began.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct SavedMotion {
    parameters: Vec<f64>,
    inputs: Vec<f64>,
    snapshot: Vec<u8>,
}

impl SavedState {
    pub(crate) fn to_bytes(&self) -> Result<Vec<u8>, Fault> {
        postcard::to_stdvec(self).map_err(|error| Fault::error(error.to_string()))
    }

    pub(crate) fn from_bytes(bytes: &[u8]) -> Result<Self, Fault> {
        postcard::from_bytes(bytes).map_err(|_| Fault::error("the serialized state is damaged"))
    }
}

impl Instance {
    pub(crate) fn save(&self) -> Result<SavedState, Fault> {
        let motion = self.running.as_ref().map(|running| {
            let snapshot = running.stepper.save()?;
            let (parameters, inputs) = (running.parameters.clone(), running.inputs.clone());
            Ok::<_, Fault>(SavedMotion { parameters, inputs, snapshot })
        });
        Ok(SavedState {
            token: self.resources.interface.token.clone(),
            phase: self.phase,
            parameters: self.parameters.clone(),
            inputs: self.inputs.clone(),
            targets: self.targets.clone(),
            stop: self.stop,
            motion: motion.transpose()?,
        })
    }

    /// Continues from a state of an instance of the same FMU. After an error the instance is unchanged.
    pub(crate) fn restore(&mut self, state: &SavedState) -> Result<(), Fault> {
        let interface = &self.resources.interface;
        let counts = [interface.parameters.len(), interface.inputs.len(), interface.inputs.len()];
        if state.token != interface.token
            || [state.parameters.len(), state.inputs.len(), state.targets.len()] != counts
        {
            return Err(Fault::error("the state belongs to another FMU"));
        }
        let running = match &state.motion {
            None => None,
            Some(SavedMotion { parameters, inputs, snapshot }) => {
                let same =
                    |one: &super::instance::Running| one.parameters == *parameters && one.inputs == *inputs;
                let mut running = match self.running.take() {
                    Some(own) if same(&own) => own,
                    own => {
                        self.running = own;
                        self.started(parameters, inputs)?
                    }
                };
                let restored = running.stepper.restore(snapshot);
                if let Err(error) = restored {
                    self.running = self.running.take().or(Some(running));
                    return Err(error.into());
                }
                Some(running)
            }
        };
        self.running = running;
        self.phase = state.phase;
        self.parameters.clone_from(&state.parameters);
        self.inputs.clone_from(&state.inputs);
        self.targets.clone_from(&state.targets);
        self.stop = state.stop;
        Ok(())
    }
}
