//! The cases of a study: which values the parameters have in each.

use ancf::ModelError;
use ancf::model::substitute;
use siphasher::sip128::{Hasher128, SipHasher24};
use std::hash::Hasher;
use toml::Value;

use super::objective::Objectives;
use super::statement::{Combine, Parameter, Study};

/// The cases of a study.
///
/// Every combination of lists and ranges is run with every sample of the distributions. Cases count from 0; of combinations the
/// last parameter runs fastest, in alphabetical order, and samples run faster still.
#[derive(Debug)]
pub struct Design {
    axes: Vec<Axis>,
    cases: usize,
}

/// The values of a parameter.
#[derive(Debug)]
pub struct Axis {
    /// The path of the key.
    pub path: String,
    /// In case k the value is that at (k / stride) mod length.
    values: Vec<Value>,
    stride: usize,
}

impl Axis {
    /// All values.
    pub fn values(&self) -> &[Value] {
        &self.values
    }

    /// The value in a case.
    pub fn value(&self, case: usize) -> &Value {
        &self.values[case / self.stride % self.values.len()]
    }
}

impl Design {
    /// The cases that a study states; `None` if there are more than can be counted.
    pub fn of(study: &Study) -> Option<Self> {
        let samples = study.samples();
        let mut cases = samples as usize;
        let mut axes = Vec::new();
        for (path, parameter) in study.parameters.iter().rev() {
            let path = path.clone();
            match (parameter, parameter.values()) {
                (_, Some(values)) => {
                    let stride = if study.combine == Combine::Grid { cases } else { samples as usize };
                    cases = stride.checked_mul(values.len())?;
                    axes.push(Axis { path, values, stride });
                }
                (Parameter::Rule(rule), None) => {
                    let parts = study.sampling.parts(samples, study.seed, &path);
                    let values = parts.into_iter().map(|p| Value::Float(rule.quantile(p))).collect();
                    axes.push(Axis { path, values, stride: 1 });
                }
                (Parameter::List(_), None) => {}
            }
        }
        axes.reverse();
        Some(Self { axes, cases })
    }

    /// How many cases there are.
    pub const fn cases(&self) -> usize {
        self.cases
    }

    /// The parameters.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The data of the model in a case.
    ///
    /// # Errors
    /// If a path leads nowhere, as it may once another parameter has been set.
    pub fn data(&self, base: &Value, case: usize) -> Result<Value, ModelError> {
        let mut data = base.clone();
        for axis in &self.axes {
            substitute(&mut data, &axis.path, axis.value(case).clone())?;
        }
        Ok(data)
    }

    /// A hash of all that the study and the model say about a case. The program is not in it: another version may find other
    /// results, but whether it does is known to the user, who then takes another folder.
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
