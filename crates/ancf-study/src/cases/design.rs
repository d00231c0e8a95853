//! Design of a study: values of the parameters in each case.

use std::collections::BTreeMap;
use std::hash::Hasher;

use ancf::ModelErrors;
use ancf::reading::{embed_mesh_files, substitute};
use siphasher::sip128::{Hasher128, SipHasher24};
use toml::Value;

use super::base_model::BaseModel;
use crate::statement::{Objectives, Parameter, Study, ValueRule};

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
        let layout = study.layout()?;
        let (paths, rules): (Vec<&str>, Vec<&ValueRule>) = study.distributions().unzip();
        let probabilities = study.sampling.probabilities(study.samples(), study.seed, &paths);
        let quantiles = |(rule, probabilities): (&ValueRule, Vec<f64>)| -> Vec<Value> {
            probabilities.into_iter().map(|p| Value::Float(rule.quantile(p))).collect()
        };
        let samples = rules.into_iter().zip(probabilities).map(quantiles);
        let mut samples: BTreeMap<&str, Vec<Value>> = paths.into_iter().zip(samples).collect();
        let axis = |((path, parameter), stride): ((&String, &Parameter), usize)| {
            let values = parameter.values().or_else(|| samples.remove(path.as_str())).unwrap_or_default();
            ParameterAxis { path: path.clone(), values, stride }
        };
        let axes = study.parameters.iter().zip(layout.strides).map(axis).collect();
        Some(Self { axes, cases: layout.cases })
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
    /// If a path has no target, which may happen after another parameter was set, or if a mesh file cannot be read.
    pub fn data(&self, base: &BaseModel, case: usize) -> Result<Value, ModelErrors> {
        let mut data = base.data.clone();
        for axis in &self.axes {
            substitute(&mut data, &axis.path, axis.value(case).clone())
                .map_err(|error| ModelErrors(vec![error]))?;
        }
        embed_mesh_files(&mut data, &base.folder)?;
        Ok(data)
    }

    /// Returns a hash of the model data of a case, with the contents of mesh files, and of the objectives.
    ///
    /// The version of the program is not included. If another version gives other results, the user chooses another folder.
    pub fn key(&self, base: &BaseModel, objectives: &Objectives, case: usize) -> String {
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
