use serde::{Deserialize, Serialize};

/// Variables of an FMU. Their value references are consecutive: time, inputs, parameters, outputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interface {
    /// Token that the description and the importer state too.
    pub token: String,
    /// Inputs of the model.
    pub inputs: Vec<Input>,
    /// Keys of the model that can be set before the initialisation.
    pub parameters: Vec<Parameter>,
    /// Columns of the run.
    pub outputs: Vec<String>,
}

/// Input of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Input {
    /// Name.
    pub name: String,
    /// Value in the model.
    pub start: f64,
}

/// Key of the model that can be set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Parameter {
    /// Path of the key, such as `bodies.rod.material.young`.
    pub path: String,
    /// Value in the model.
    pub start: f64,
}

/// Variable of an FMU, with its number among those of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// Time.
    Time,
    /// Input.
    Input(usize),
    /// Parameter.
    Parameter(usize),
    /// Output.
    Output(usize),
}

impl Interface {
    /// Variable of a value reference.
    pub fn variable(&self, reference: u32) -> Option<Variable> {
        let Some(number) = (reference as usize).checked_sub(1) else { return Some(Variable::Time) };
        let Some(number) = number.checked_sub(self.inputs.len()) else {
            return Some(Variable::Input(number));
        };
        let Some(output) = number.checked_sub(self.parameters.len()) else {
            return Some(Variable::Parameter(number));
        };
        (output < self.outputs.len()).then_some(Variable::Output(output))
    }

    /// All variables in the order of their value references.
    pub fn variables(&self) -> impl Iterator<Item = Variable> + '_ {
        let count = 1 + self.inputs.len() + self.parameters.len() + self.outputs.len();
        (0..count as u32).filter_map(|reference| self.variable(reference))
    }

    /// Name of a variable.
    pub fn name(&self, variable: Variable) -> &str {
        match variable {
            Variable::Time => "time",
            Variable::Input(i) => &self.inputs[i].name,
            Variable::Parameter(i) => &self.parameters[i].path,
            Variable::Output(i) => &self.outputs[i],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_consecutive() {
        let input = |name: &str| Input { name: name.into(), start: 0.0 };
        let interface = Interface {
            token: String::new(),
            inputs: vec![input("a"), input("b")],
            parameters: vec![Parameter { path: "p".into(), start: 1.0 }],
            outputs: vec!["x".into(), "y".into()],
        };
        let names: Vec<_> = interface.variables().map(|variable| interface.name(variable)).collect();
        assert_eq!(names, ["time", "a", "b", "p", "x", "y"]);
        assert_eq!(interface.variable(6), None);
    }
}
