use std::fmt;

use ancf::Stepper;

use super::fault::{Fault, Level};
use super::resources::Resources;
use crate::interface::model_with;

/// Callback for messages.
type Log = Box<dyn Fn(Level, &str)>;

/// Phase of an instance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(crate) enum Phase {
    /// Parameters and start values of inputs are set.
    Instantiated,
    /// Inputs are set, and outputs of the initial state are read.
    Initialization,
    /// Steps are taken.
    Step,
    /// Values of the last state are read.
    Terminated,
}

/// Instance of an FMU.
pub(crate) struct Instance {
    pub(super) resources: Resources,
    log: Log,
    pub(super) phase: Phase,
    pub(super) parameters: Vec<f64>,
    /// Values of the inputs that were set last.
    pub(super) inputs: Vec<f64>,
    /// Values of inputs that prescribe positions, to which the next step moves.
    pub(super) targets: Vec<Option<f64>>,
    pub(super) running: Option<Running>,
    /// End of the experiment.
    pub(super) stop: Option<f64>,
    /// True if the importer allows steps that end early.
    pub(crate) may_return_early: bool,
}

/// Motion with the values of parameters and inputs with which it began.
#[derive(Debug)]
pub(super) struct Running {
    pub(super) stepper: Stepper,
    /// Numbers of the outputs in the rows.
    pub(super) columns: Vec<usize>,
    pub(super) parameters: Vec<f64>,
    pub(super) inputs: Vec<f64>,
    /// Number of warnings that were reported.
    warnings: usize,
}

impl fmt::Debug for Instance {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Instance").field("phase", &self.phase).finish_non_exhaustive()
    }
}

impl Instance {
    pub(crate) fn new(resources: Resources, log: Log) -> Self {
        let interface = &resources.interface;
        Self {
            parameters: interface.parameters.iter().map(|one| one.start).collect(),
            inputs: interface.inputs.iter().map(|one| one.start).collect(),
            targets: vec![None; interface.inputs.len()],
            phase: Phase::Instantiated,
            running: None,
            stop: None,
            may_return_early: false,
            resources,
            log,
        }
    }

    pub(crate) fn log(&self, level: Level, message: &str) {
        (self.log)(level, message);
    }

    /// Checks the phase.
    pub(crate) fn expect(&self, allowed: &[Phase]) -> Result<(), Fault> {
        match allowed.contains(&self.phase) {
            true => Ok(()),
            false => Err(Fault::error(format!("the call is not allowed in the phase {:?}", self.phase))),
        }
    }

    /// Sets the times of the experiment.
    pub(crate) fn set_up(&mut self, start: f64, stop: Option<f64>) -> Result<(), Fault> {
        self.expect(&[Phase::Instantiated])?;
        if start != 0.0 {
            return Err(Fault::error(format!("start time: found {start}, expected 0, as in the model")));
        }
        self.stop = stop;
        Ok(())
    }

    pub(crate) fn enter_initialization(&mut self) -> Result<(), Fault> {
        self.expect(&[Phase::Instantiated])?;
        self.running()?;
        self.phase = Phase::Initialization;
        Ok(())
    }

    pub(crate) fn exit_initialization(&mut self) -> Result<(), Fault> {
        self.expect(&[Phase::Initialization])?;
        self.running()?;
        self.phase = Phase::Step;
        self.log_warnings();
        Ok(())
    }

    pub(crate) fn terminate(&mut self) -> Result<(), Fault> {
        self.expect(&[Phase::Step])?;
        self.phase = Phase::Terminated;
        self.log_warnings();
        Ok(())
    }

    /// Returns to the state after the instantiation.
    pub(crate) fn reset(&mut self) {
        let interface = &self.resources.interface;
        self.parameters = interface.parameters.iter().map(|one| one.start).collect();
        self.inputs = interface.inputs.iter().map(|one| one.start).collect();
        self.targets.fill(None);
        (self.running, self.stop, self.phase) = (None, None, Phase::Instantiated);
    }

    /// Motion with the present values of the parameters, and before the first step with those of the inputs.
    pub(super) fn running(&mut self) -> Result<&mut Running, Fault> {
        let is_fixed = matches!(self.phase, Phase::Step | Phase::Terminated);
        let usable =
            |one: &Running| is_fixed || (one.parameters == self.parameters && one.inputs == self.inputs);
        if !self.running.as_ref().is_some_and(usable) {
            self.running = None;
            self.running = Some(self.started(&self.parameters, &self.inputs)?);
        }
        self.running.as_mut().ok_or_else(|| Fault::error("the motion has not begun"))
    }

    /// Starts a motion.
    pub(super) fn started(&self, parameters: &[f64], inputs: &[f64]) -> Result<Running, Fault> {
        let Resources { interface, data } = &self.resources;
        let stepper = Stepper::new(&model_with(data, interface, parameters, inputs)?)?;
        let number = |name: &String| {
            let missing = || Fault::error(format!("the model has no column {name:?} with these parameters"));
            stepper.column(name).ok_or_else(missing)
        };
        let columns = interface.outputs.iter().map(number).collect::<Result<_, _>>()?;
        let (parameters, inputs) = (parameters.to_vec(), inputs.to_vec());
        Ok(Running { stepper, columns, parameters, inputs, warnings: 0 })
    }

    /// Reports new warnings.
    fn log_warnings(&mut self) {
        let Some(running) = &mut self.running else { return };
        let warnings = running.stepper.summary().warnings;
        let new = warnings.get(running.warnings..).unwrap_or_default();
        running.warnings = warnings.len();
        new.iter().for_each(|warning| (self.log)(Level::Warning, warning));
    }
}
