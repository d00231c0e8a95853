//! Checks of whole models, and assembly of models that pass them.

use serde::Deserialize;
use toml::Value;

use crate::assembly::{Assembly, contradictions};
use crate::checking::{broken_rules, with_memory};
use crate::errors::{Finding, ModelError, ModelErrors, quoted};
use crate::model::{Load, Model, TimeFunction, TimeMode, Varying, loads_of};
use crate::schema::{SCHEMA, SchemaCheck};

impl Model {
    /// Makes a model of data such as a table of another language, and checks it.
    ///
    /// # Errors
    /// All that is wrong, without positions.
    pub fn from_value(data: &Value) -> Result<Self, ModelErrors> {
        let (model, findings) = judge(data);
        model.filter(|_| findings.is_empty()).ok_or_else(|| ModelErrors(errors(findings)))
    }

    /// Checks a model that was built in Rust by the rules for model files, and functions that are supplied by those for functions
    /// of time.
    ///
    /// # Errors
    /// All that is wrong, without positions.
    pub fn check(&self) -> Result<(), ModelErrors> {
        let data = Value::try_from(self)
            .map_err(|error| ModelErrors(vec![ModelError::new("", error.to_string(), "a model")]))?;
        // The data have neither added parts nor supplied functions: the rules are checked on the model itself.
        let findings = if self.is_extended() {
            let (survey, _) = SchemaCheck::of(&SCHEMA, &data);
            if survey.findings.is_empty() { broken(self) } else { survey.findings }
        } else {
            Self::from_value(&data)?;
            if self.has_external_functions(true) { broken(self) } else { Vec::new() }
        };
        if findings.is_empty() { Ok(()) } else { Err(ModelErrors(errors(findings))) }
    }

    /// Checks that the program has supplied all functions that the model asks for.
    ///
    /// # Errors
    /// Each place that waits for one.
    pub fn check_supplies(&self) -> Result<(), ModelErrors> {
        let missing = |path: String, what: &str, name: &str| {
            let found = format!("the external {what} {}", quoted(name));
            ModelError::new(
                format!("{path}.name"),
                found,
                "a function that the program supplies under this name",
            )
        };
        let times = self.time_functions().into_iter().filter_map(|(path, time)| match time {
            TimeFunction::Varying(Varying::External { name, supplied: None, .. }) => {
                Some(missing(path, "function", name))
            }
            _ => None,
        });
        let forces = loads_of(self).filter_map(|(path, load)| match load {
            Load::External { name, supplied: None, .. } => Some(missing(path, "force", name)),
            _ => None,
        });
        let errors: Vec<ModelError> = times.chain(forces).collect();
        if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
    }

    /// Turns a valid model into equations of motion in the model's own numbers.
    ///
    /// # Errors
    /// If the model is not valid, or functions are not supplied.
    pub fn assemble(&self) -> Result<Assembly, ModelErrors> {
        self.valid_assembly(TimeMode::AsGiven)
    }

    /// The same for statics: functions of time are 1, so that loads and angles have their full values, times the load factor of
    /// a state.
    ///
    /// # Errors
    /// If the model is not valid, or functions are not supplied.
    pub fn assemble_static(&self) -> Result<Assembly, ModelErrors> {
        self.valid_assembly(TimeMode::One)
    }

    fn valid_assembly(&self, time_mode: TimeMode) -> Result<Assembly, ModelErrors> {
        self.check()?;
        self.check_supplies()?;
        self.assembled(time_mode)
    }
}

fn errors(findings: Vec<Finding>) -> Vec<ModelError> {
    findings.into_iter().map(|finding| finding.error).collect()
}

/// The rules that a model of the right form breaks; only if there is none, what its joints contradict.
fn broken(model: &Model) -> Vec<Finding> {
    let findings = broken_rules(model);
    if findings.is_empty() { contradictions(model) } else { findings }
}

/// All that is wrong with data by the schema, and by the rules as far as these rest on sound data.
pub(crate) fn judge(data: &Value) -> (Option<Model>, Vec<Finding>) {
    let (mut survey, mended) = SchemaCheck::of(&SCHEMA, data);
    let mut findings = std::mem::take(&mut survey.findings);
    let model = Model::deserialize(mended);
    let broken = model.as_ref().map(broken_rules).unwrap_or_default();
    findings = findings.into_iter().map(with_memory).collect();
    findings.extend(broken.into_iter().map(|finding| spelt(finding, &survey)).filter(|finding| {
        !survey.has_mended(&finding.error.path)
            && !finding.rests_on.iter().any(|path| survey.has_mended(path))
    }));
    match &model {
        Ok(model) if findings.is_empty() => findings.extend(contradictions(model)),
        Err(error) if findings.is_empty() => {
            findings.push(ModelError::new("", error.to_string(), "a model").into());
        }
        _ => {}
    }
    (model.ok(), findings)
}

/// The finding with its paths as the file spells them.
fn spelt(mut finding: Finding, survey: &SchemaCheck) -> Finding {
    finding.error.path = survey.spelt(&finding.error.path);
    finding.rests_on.iter_mut().for_each(|path| *path = survey.spelt(path));
    finding
}
