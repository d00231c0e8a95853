//! Checks of whole models, and assembly of valid models.

use serde::Deserialize;
use toml::Value;

use super::meshes::read_meshes;
use crate::assembly::{Assembly, contradictions, enclosures};
use crate::checking::{available, broken_rules, memory_of_equations, with_memory};
use crate::errors::{Finding, ModelError, ModelErrors, finding, quoted};
use crate::model::{
    ExternalLoad, IndexedModel, JointLaw, Load, Model, TimeFunction, TimeMode, Varying, loads_of,
};
use crate::schema::{SCHEMA, SchemaCheck};

impl Model {
    /// Creates a model from data, such as a table of another language, and checks it.
    ///
    /// # Errors
    /// All errors of the model, without positions.
    pub fn from_value(data: &Value) -> Result<Self, ModelErrors> {
        let (model, findings) = check_data(data.clone());
        model.filter(|_| findings.is_empty()).ok_or_else(|| ModelErrors(errors(findings)))
    }

    /// Checks a model that was built in Rust by the rules for model files.
    ///
    /// Supplied functions are checked by the rules for functions of time.
    ///
    /// # Errors
    /// All errors of the model, without positions.
    pub fn check(&self) -> Result<(), ModelErrors> {
        self.check_by(rules_and_contradictions)
    }

    /// Checks the model by the schema and by rules for models that satisfy it.
    fn check_by(&self, rules: Rules) -> Result<(), ModelErrors> {
        let data = || {
            Value::try_from(self)
                .map_err(|error| ModelErrors(vec![ModelError::new("", error.to_string(), "a model")]))
        };
        let (check, _) = SchemaCheck::of(&SCHEMA, data()?);
        let findings = if check.findings.is_empty() {
            // The data lack added joints and loads and supplied functions, so the rules are checked on the model itself.
            rules(&self.with_signals())
        } else if self.is_extended() {
            check.findings
        } else {
            check_data_by(data()?, rules).1
        };
        if findings.is_empty() { Ok(()) } else { Err(ModelErrors(errors(findings))) }
    }

    /// Checks that the program has supplied all external functions of the model.
    ///
    /// # Errors
    /// One error for each function that is not supplied.
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
            Load::External(ExternalLoad { name, supplied: None, .. }) => Some(missing(path, "force", name)),
            _ => None,
        });
        let laws = self.laws().filter_map(|(path, one)| match one.law {
            JointLaw::External { name, supplied: None, .. } => Some(missing(path, "force law", name)),
            _ => None,
        });
        let errors: Vec<ModelError> = times.chain(forces).chain(laws).collect();
        if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
    }

    /// Assembles the equations of motion of a valid model, in the units of the model.
    ///
    /// # Errors
    /// If the model is not valid, or external functions are not supplied.
    pub fn assemble(&self) -> Result<Assembly, ModelErrors> {
        self.valid_assembly(TimeMode::AsGiven)
    }

    /// Assembles the equations of statics.
    ///
    /// Functions of time are 1: loads and prescribed motions have their full values, times the load factor of a state.
    ///
    /// # Errors
    /// If the model is not valid, or external functions are not supplied.
    pub fn assemble_static(&self) -> Result<Assembly, ModelErrors> {
        self.valid_assembly(TimeMode::One)
    }

    fn valid_assembly(&self, time_mode: TimeMode) -> Result<Assembly, ModelErrors> {
        self.check()?;
        self.check_supplies()?;
        assembled(&IndexedModel::new(&self.with_signals()), time_mode)
    }

    /// Assembles the equations of the analysis. The model is a valid model in other units.
    ///
    /// Its inputs are connected with signals. Values are checked again, because they may overflow. Contradictions of joints do not depend on units.
    pub(crate) fn assemble_scaled(&self) -> Result<Assembly, ModelErrors> {
        self.check_by(broken_rules)?;
        self.check_supplies()?;
        let is_dynamic = self.analysis.dynamics().is_some();
        assembled(&IndexedModel::new(self), if is_dynamic { TimeMode::AsGiven } else { TimeMode::One })
    }
}

/// Assembles a model and checks that its matrices fit into the available memory.
fn assembled(model: &IndexedModel<'_>, time_mode: TimeMode) -> Result<Assembly, ModelErrors> {
    let assembly = model.assembled(time_mode)?;
    memory_of_equations(model, assembly.system.pattern(), available)?;
    Ok(assembly)
}

/// Rules for models that satisfy the schema.
type Rules = fn(&Model) -> Vec<Finding>;

fn errors(findings: Vec<Finding>) -> Vec<ModelError> {
    findings.into_iter().map(|finding| finding.error).collect()
}

/// Violated rules of a model that satisfies the schema; without any, contradictions of its joints and openings around gases.
fn rules_and_contradictions(model: &Model) -> Vec<Finding> {
    let findings = broken_rules(model);
    if findings.is_empty() {
        contradictions(model).into_iter().chain(enclosures(model)).collect()
    } else {
        findings
    }
}

/// Checks data against the schema, and against those rules that depend on valid data only.
pub(super) fn check_data(data: Value) -> (Option<Model>, Vec<Finding>) {
    check_data_by(data, rules_and_contradictions)
}

fn check_data_by(mut data: Value, rules: Rules) -> (Option<Model>, Vec<Finding>) {
    if let Some(Value::Array(analyses)) = data.get("analysis") {
        let found = format!("a list of {} analyses", analyses.len());
        let error = finding("analysis".into(), found, "a single analysis, as a table");
        return (
            None,
            vec![error.hint("`ancf run` and `ancf check` accept a list, `ancf.run_sequence` in Python, `AnalysisSequence` in Rust")],
        );
    }
    let unread = read_meshes(&mut data);
    if !unread.is_empty() {
        return (None, unread);
    }
    let (mut check, corrected) = SchemaCheck::of(&SCHEMA, data);
    let mut findings = std::mem::take(&mut check.findings);
    let mut model = Model::deserialize(corrected);
    if let Ok(model) = &mut model {
        model.connect_inputs();
    }
    let is_valid = findings.is_empty();
    // Contradictions of joints depend on a valid model.
    let violations = model.as_ref().map(if is_valid { rules } else { broken_rules }).unwrap_or_default();
    findings = findings.into_iter().map(with_memory).collect();
    findings.extend(violations.into_iter().map(|finding| in_file(finding, &check)).filter(|finding| {
        let paths = finding.rests_on.iter().chain([&finding.error.path]);
        !paths.into_iter().any(|path| check.has_replaced(path) || is_in_unknown_form(path, &check))
    }));
    if let (Err(error), true) = (&model, findings.is_empty()) {
        findings.push(ModelError::new("", error.to_string(), "a model").into());
    }
    (model.ok(), findings)
}

/// True for a key of a table with an unknown `kind`, in place of which another form was read.
fn is_in_unknown_form(path: &str, check: &SchemaCheck) -> bool {
    path.rsplit_once('.').is_some_and(|(table, _)| check.has_replaced(&format!("{table}.kind")))
}

/// Finding with its paths as in the file.
fn in_file(mut finding: Finding, check: &SchemaCheck) -> Finding {
    finding.error.path = check.path_in_file(&finding.error.path);
    finding.rests_on.iter_mut().for_each(|path| *path = check.path_in_file(path));
    finding
}
