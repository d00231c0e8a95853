//! Design of a study: values of the parameters in each case.

use std::hash::Hasher;

use ancf::ModelError;
use ancf::reading::substitute;
use siphasher::sip128::{Hasher128, SipHasher24};
use toml::Value;

use crate::statement::{Combine, Objectives, Parameter, Study};

/// Cases of a study.
///
/// Every combination of lists and ranges is run with every sample of the distributions. Cases are numbered from 0. Samples vary
/// fastest, then the last parameter in alphabetical order.
#[derive(Clone, Debug)]
pub struct CaseDesign {
    axes: Vec<ParameterAxis>,
    cases: usize,
}

/// Values of a parameter.
#[derive(Clone, Debug)]
pub struct ParameterAxis {
    /// Path of the key.
    pub path: String,
    /// Values. Case k has the value at (k / stride) mod length.
    values: Vec<Value>,
    stride: usize,
}

impl ParameterAxis {
    /// Returns all values.
    pub fn values(&self) -> &[Value] {
        &self.values
    }

    /// Returns the value in a case.
    pub fn value(&self, case: usize) -> &Value {
        &self.values[case / self.stride % self.values.len()]
    }
}

impl CaseDesign {
    /// Creates the design of a study. `None` if the number of cases cannot be represented.
    pub fn new(study: &Study) -> Option<Self> {
        let samples = study.samples();
        let mut cases = samples as usize;
        let mut axes = Vec::new();
        for (path, parameter) in study.parameters.iter().rev() {
            let path = path.clone();
            match (parameter, parameter.values()) {
                (_, Some(values)) => {
                    let stride = if study.combine == Combine::Grid { cases } else { samples as usize };
                    cases = stride.checked_mul(values.len())?;
                    axes.push(ParameterAxis { path, values, stride });
                }
                (Parameter::Rule(rule), None) => {
                    let probabilities = study.sampling.probabilities(samples, study.seed, &path);
                    let values = probabilities.into_iter().map(|p| Value::Float(rule.quantile(p))).collect();
                    axes.push(ParameterAxis { path, values, stride: 1 });
                }
                (Parameter::List(_), None) => {}
            }
        }
        axes.reverse();
        Some(Self { axes, cases })
    }

    /// Returns the number of cases.
    pub const fn cases(&self) -> usize {
        self.cases
    }

    /// Returns the parameters.
    pub fn axes(&self) -> &[ParameterAxis] {
        &self.axes
    }

    /// Returns the data of the model in a case.
    ///
    /// # Errors
    /// If a path has no target, which may happen after another parameter was set.
    pub fn data(&self, base: &Value, case: usize) -> Result<Value, ModelError> {
        let mut data = base.clone();
        for axis in &self.axes {
            substitute(&mut data, &axis.path, axis.value(case).clone())?;
        }
        Ok(data)
    }

    /// Returns a hash of the model data of a case and of the objectives.
    ///
    /// The version of the program is not included. If another version gives other results, the user chooses another folder.
    pub fn key(&self, base: &Value, objectives: &Objectives, case: usize) -> String {
        let mut data = self.data(base, case).unwrap_or_else(|error| Value::String(error.to_string()));
        if let Value::Table(table) = &mut data {
            table.remove("title");
        }
        let mut hasher = SipHasher24::new();
        hasher.write(Value::to_string(&data).as_bytes());
        hasher.write(&[0xFF]);
        hasher.write(serde_json::to_string(objectives).unwrap_or_default().as_bytes());
        format!("{:032x}", hasher.finish128().as_u128())
    }
}
