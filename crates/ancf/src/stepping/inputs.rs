use super::step_error::{StepError, argument};
use super::stepper::{Setting, Stepper};
use crate::errors::{listed, nearest, quoted};
use crate::model::{Model, joints_of};

/// Use of an input in a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputUse {
    /// Loads: the value may jump.
    Load,
    /// Rates of drives, also with loads: a jump is a velocity jump.
    Rate,
    /// Positions or angles of drives, also with others: the value is continuous, and its rate may jump.
    Position,
}

impl InputUse {
    /// Use of the input of a name: the one with the strongest demand.
    pub(super) fn of(model: &Model, name: &str) -> Self {
        let mut found = Self::Load;
        for (_, joint) in joints_of(model) {
            let [angle, displacement] = joint.kind().actions();
            let rates: Vec<&str> = [angle, displacement]
                .into_iter()
                .filter(|actions| actions.drive.is_some_and(|drive| drive.amounts[0].is_none()))
                .map(|actions| actions.table)
                .collect();
            for (table, _) in joint.times().iter().filter(|(_, time)| time.input_name() == Some(name)) {
                if !rates.iter().any(|rate| table.trim_start_matches('.') == *rate) {
                    return Self::Position;
                }
                found = Self::Rate;
            }
        }
        found
    }
}

impl Stepper {
    /// Sets an input from the present time on, at once. The next step starts with it; until then, values that are read are those
    /// before the jump.
    ///
    /// # Errors
    /// If there is no such input, the value is not finite, or it would jump although it prescribes a position.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), StepError> {
        self.set_within(name, value, 0.0)
    }

    /// Sets an input from the present time on, with a linear transition from its present value over a duration.
    ///
    /// # Errors
    /// As [`set`](Self::set), or if the duration is negative or not finite.
    pub fn set_within(&mut self, name: &str, value: f64, duration: f64) -> Result<(), StepError> {
        let number = self.input_number(name)?;
        let what = format!("input {}", quoted(name));
        if !value.is_finite() {
            return Err(argument(&what, value, "a finite number"));
        }
        if !(duration.is_finite() && duration >= 0.0) {
            return Err(argument("ramp", duration, "a duration of at least 0"));
        }
        let now = self.dynamics.state().t;
        let signal = &self.simulation.inputs[number];
        if signal.at(now).value == value && signal.transition().values[1] == value {
            self.pending[number] = None;
            return Ok(());
        }
        let own = duration / self.simulation.scales().time;
        let is_jump = now + own <= now + self.events.tolerance();
        if is_jump && InputUse::of(&self.simulation.scaled, name) == InputUse::Position {
            let expected = "a transition, `ramp` > 0: the input prescribes a position, which must not jump";
            return Err(argument(&what, format!("a jump to {value}"), expected));
        }
        self.pending[number] = Some(Setting { value, duration: if is_jump { 0.0 } else { own } });
        Ok(())
    }

    /// Value of an input: the one last set, or during a transition the present value.
    ///
    /// # Errors
    /// If there is no such input.
    pub fn input(&self, name: &str) -> Result<f64, StepError> {
        let number = self.input_number(name)?;
        let at_once = self.pending[number].filter(|setting| setting.duration == 0.0);
        let now = || self.simulation.inputs[number].at(self.dynamics.state().t).value;
        Ok(at_once.map_or_else(now, |setting| setting.value))
    }

    /// Use of an input in the model.
    ///
    /// # Errors
    /// If there is no such input.
    pub fn input_use(&self, name: &str) -> Result<InputUse, StepError> {
        self.input_number(name)?;
        Ok(InputUse::of(&self.simulation.scaled, name))
    }

    /// Names of the inputs.
    pub fn inputs(&self) -> impl Iterator<Item = &str> {
        self.simulation.scaled.inputs.iter().map(|input| input.name.as_str())
    }

    pub(super) fn input_number(&self, name: &str) -> Result<usize, StepError> {
        let unknown = || {
            let names: Vec<&str> = self.inputs().collect();
            let expected = match (names.is_empty(), nearest(name, names.iter().copied())) {
                (true, _) => "the name of an input, but the model has none".to_owned(),
                (_, Some(meant)) => format!("the name of an input, perhaps {}", quoted(meant)),
                _ => format!("one of {}", listed(names.iter().map(|name| quoted(name)), "or")),
            };
            argument("input", quoted(name), &expected)
        };
        self.inputs().position(|own| own == name).ok_or_else(unknown)
    }

    /// Applies the new settings of the inputs at the present time, as the next step would do: accelerations, multipliers and velocity
    /// jumps follow from them. Values that are read afterwards are those after the jump.
    ///
    /// # Errors
    /// If there are no accelerations or velocities for the values. The former ones apply then.
    pub fn apply_inputs(&mut self) -> Result<(), StepError> {
        if self.pending.iter().all(Option::is_none) {
            return Ok(());
        }
        let (now, signals) = (self.dynamics.state().t, &self.simulation.inputs);
        let former: Vec<_> = signals.iter().map(|signal| signal.transition()).collect();
        for (signal, setting) in signals.iter().zip(&self.pending) {
            if let Some(Setting { value, duration }) = *setting {
                signal.set(signal.transition().towards(value, now, duration));
            }
        }
        let done = self.restart(now);
        match done {
            Ok(()) => self.pending.fill(None),
            Err(_) => self.simulation.inputs.iter().zip(former).for_each(|(signal, one)| signal.set(one)),
        }
        done
    }
}
