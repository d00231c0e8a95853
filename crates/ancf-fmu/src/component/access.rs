use ancf::InputUse;

use super::fault::Fault;
use super::instance::{Instance, Phase};
use crate::interface::Variable;

impl Instance {
    fn variable(&self, reference: u32) -> Result<Variable, Fault> {
        let unknown = || Fault::error(format!("no variable has the value reference {reference}"));
        self.resources.interface.variable(reference).ok_or_else(unknown)
    }

    /// Value of a variable. Outputs are those after new values of inputs.
    pub(crate) fn get(&mut self, reference: u32) -> Result<f64, Fault> {
        match self.variable(reference)? {
            Variable::Time => Ok(self.running.as_ref().map_or(0.0, |running| running.stepper.time())),
            Variable::Input(i) => Ok(self.inputs[i]),
            Variable::Parameter(i) => Ok(self.parameters[i]),
            Variable::Output(i) => {
                let running = self.running()?;
                running.stepper.apply_inputs()?;
                Ok(running.stepper.row()[running.columns[i]])
            }
        }
    }

    /// Sets an input, or until the end of the initialization a parameter.
    pub(crate) fn set(&mut self, reference: u32, value: f64) -> Result<(), Fault> {
        let variable = self.variable(reference)?;
        let name = || format!("{:?}", self.resources.interface.name(variable));
        if !value.is_finite() {
            return Err(Fault::error(format!("{}: found {value}, expected a finite number", name())));
        }
        match (variable, self.phase) {
            (Variable::Input(i), Phase::Instantiated | Phase::Initialization) => self.inputs[i] = value,
            (Variable::Input(i), Phase::Step) => self.set_input(i, value)?,
            (Variable::Parameter(i), Phase::Instantiated | Phase::Initialization) => {
                self.parameters[i] = value;
            }
            (Variable::Parameter(_), _) => {
                return Err(Fault::error(format!(
                    "the parameter {} is fixed after the initialization",
                    name()
                )));
            }
            (Variable::Input(_), Phase::Terminated) => {
                return Err(Fault::error(format!("the input {} cannot be set after the end", name())));
            }
            (Variable::Time | Variable::Output(_), _) => {
                return Err(Fault::error(format!("{} cannot be set", name())));
            }
        }
        Ok(())
    }

    /// Sets an input between steps. An input that prescribes a position moves during the next step.
    fn set_input(&mut self, i: usize, value: f64) -> Result<(), Fault> {
        let name = self.resources.interface.inputs[i].name.clone();
        let stepper = &mut self.running()?.stepper;
        if stepper.input_use(&name)? == InputUse::Position {
            self.targets[i] = Some(value);
        } else {
            stepper.set(&name, value)?;
        }
        self.inputs[i] = value;
        Ok(())
    }

    /// Product of the derivatives of outputs with respect to inputs, at the present state, with a direction of the inputs.
    pub(crate) fn directional_derivative(
        &mut self,
        unknowns: &[u32],
        knowns: &[u32],
        direction: &[f64],
    ) -> Result<Vec<f64>, Fault> {
        self.expect(&[Phase::Initialization, Phase::Step])?;
        let outputs = unknowns.iter().map(|reference| match self.variable(*reference)? {
            Variable::Output(i) => Ok(self.resources.interface.outputs[i].clone()),
            other => Err(self.no_derivative(other, "of outputs")),
        });
        let outputs = outputs.collect::<Result<Vec<_>, _>>()?;
        let inputs = knowns.iter().map(|reference| match self.variable(*reference)? {
            Variable::Input(i) => Ok(i),
            other => Err(self.no_derivative(other, "with respect to inputs")),
        });
        let inputs = inputs.collect::<Result<Vec<_>, _>>()?;
        if inputs.len() != direction.len() {
            let text = format!("direction: found {} numbers, expected {}", direction.len(), inputs.len());
            return Err(Fault::error(text));
        }
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        let d = self.running()?.stepper.linearise(&outputs)?.d;
        let entry =
            |row: usize| inputs.iter().zip(direction).map(|(&i, part)| d[(row, i)] * part).sum::<f64>();
        Ok((0..outputs.len()).map(entry).collect())
    }

    fn no_derivative(&self, variable: Variable, allowed: &str) -> Fault {
        let name = self.resources.interface.name(variable);
        Fault::error(format!("{name:?}: derivatives are {allowed} only"))
    }
}
