use super::fault::{Fault, Level};
use super::instance::{Instance, Phase};

/// Tolerance of times, relative to the step.
const TOLERANCE: f64 = 1e-6;

/// End of a step.
#[derive(Clone, Debug)]
pub(crate) struct StepEnd {
    /// Time of the state.
    pub(crate) time: f64,
    /// Cause if the step was not completed.
    pub(crate) failure: Option<Fault>,
}

impl Instance {
    /// Advances from the communication point t to t + h, in steps of the model.
    ///
    /// A failure of the computation is part of the result: the state is then that of the last accepted substep.
    pub(crate) fn do_step(&mut self, t: f64, h: f64) -> Result<StepEnd, Fault> {
        self.expect(&[Phase::Step])?;
        if !(h.is_finite() && h > 0.0) {
            return Err(Fault::error(format!("communication step: found {h}, expected a number above 0")));
        }
        let now = self.time();
        let gap = (t - now).abs();
        if gap.is_nan() || gap > TOLERANCE * h {
            return Err(Fault::error(format!("communication point: found {t}, expected {now}")));
        }
        if let Some(stop) = self.stop.filter(|stop| t + h > stop + TOLERANCE * h) {
            return Err(Fault::error(format!("end of the step: found {}, expected at most {stop}", t + h)));
        }
        for i in 0..self.targets.len() {
            if let Some(value) = self.targets[i] {
                let name = self.resources.interface.inputs[i].name.clone();
                self.running()?.stepper.set_within(&name, value, t + h - now)?;
                self.targets[i] = None;
            }
        }
        let stepper = &mut self.running()?.stepper;
        let failure = stepper.advance(t + h).err();
        let time = stepper.time();
        // A part of the step is valid.
        let level = if time > now { Level::Discard } else { Level::Error };
        let failure = failure.map(|error| Fault { level, message: error.to_string() });
        Ok(StepEnd { time, failure })
    }

    /// Time of the present state.
    pub(crate) fn time(&self) -> f64 {
        self.running.as_ref().map_or(0.0, |running| running.stepper.time())
    }
}
