//! What a study file states, and all that can be wrong with it.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use ancf::model::{join, nearest, parse_as};
use ancf::{Model, ModelError, ModelErrors, Simulation};
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::Deserialize;
use serde_json::Value as Json;
use toml::{Table, Value};

use super::distribution::Rule;
use super::objective::Objectives;
use super::places::Places;
use super::sample::Sampling;
use super::table;

/// A study as its file states it.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// The model file, relative to the file of the study.
    #[schemars(length(min = 1))]
    pub model: PathBuf,
    /// How many samples are drawn of all distributions together.
    #[serde(default)]
    #[schemars(range(min = 1, max = 10_000_000))]
    pub samples: Option<u32>,
    /// What decides the samples.
    #[serde(default)]
    pub seed: u32,
    /// How the samples fill the range of their distributions.
    #[serde(default)]
    pub sampling: Sampling,
    /// How lists and ranges are combined.
    #[serde(default)]
    pub combine: Combine,
    /// Values by the path of the key in the model.
    pub parameters: BTreeMap<String, Parameter>,
    /// Numbers that are kept of each case.
    #[serde(default)]
    pub objectives: Objectives,
}

/// How the values of lists and ranges are combined.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Combine {
    /// Every value with every value of the others.
    #[default]
    Grid,
    /// The first with the first of the others, the second with the second.
    Zip,
}

/// The values of a parameter.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Parameter {
    /// These values.
    List(#[schemars(with = "Vec<Json>", length(min = 1))] Vec<Value>),
    /// Values by a rule.
    Rule(Rule),
}

impl Parameter {
    /// The values of a list or a range; `None` of a distribution.
    pub fn values(&self) -> Option<Vec<Value>> {
        match self {
            Self::List(values) => Some(values.clone()),
            Self::Rule(rule) => rule.values(),
        }
    }

    /// How many values a list or a range has; `None` of a distribution.
    pub const fn count(&self) -> Option<usize> {
        match self {
            Self::List(values) => Some(values.len()),
            Self::Rule(rule) => rule.count(),
        }
    }

    /// The first value of a list or a range, the median of a distribution; `None` of an empty list.
    pub fn first(&self) -> Option<Value> {
        match self {
            Self::List(values) => values.first().cloned(),
            Self::Rule(rule) => Some(rule.first()),
        }
    }
}

/// The schema of study files.
static SCHEMA: LazyLock<Json> = LazyLock::new(|| {
    let mut settings = SchemaSettings::draft2020_12();
    settings.inline_subschemas = true;
    settings.into_generator().into_root_schema_for::<Study>().to_value()
});

/// The most cases of a study.
const MANY: usize = 10_000_000;

impl Study {
    /// Reads the text of a study whose model is relative to `folder`.
    ///
    /// # Errors
    /// All that is wrong, in the order of the text. What is wrong with the model itself is not looked for.
    pub fn parse(text: &str, folder: &Path) -> Result<Self, ModelErrors> {
        parse_as(text, &SCHEMA, |study: &Self| study.faults(folder))
    }

    /// How many samples every combination of lists and ranges is run with.
    pub fn samples(&self) -> u32 {
        let is_drawn = self.parameters.values().any(|parameter| parameter.count().is_none());
        if is_drawn { self.samples.unwrap_or(1) } else { 1 }
    }

    /// How many cases there are; `None` if there are more than can be counted.
    fn cases(&self) -> Option<usize> {
        let mut counts = self.parameters.values().filter_map(Parameter::count);
        let combinations = match self.combine {
            Combine::Grid => counts.try_fold(1, usize::checked_mul)?,
            Combine::Zip => counts.max().unwrap_or(1),
        };
        combinations.checked_mul(self.samples() as usize)
    }

    fn faults(&self, folder: &Path) -> Vec<ModelError> {
        let mut faults = self.faults_of_parameters();
        match fs::read_to_string(folder.join(&self.model)) {
            Ok(text) => {
                let data = text.parse::<Table>().map(Value::Table);
                faults.extend(data.map(|data| self.faults_with(&data)).unwrap_or_default());
            }
            Err(error) => {
                let found = format!("{:?}: {}", self.model.display().to_string(), why(&error));
                faults.push(ModelError::new(
                    "model",
                    found,
                    "a model file, relative to the file of the study",
                ));
            }
        }
        faults
    }

    /// What is wrong without regard to the model.
    fn faults_of_parameters(&self) -> Vec<ModelError> {
        let mut faults = Vec::new();
        for (path, parameter) in &self.parameters {
            if let Parameter::Rule(rule) = parameter {
                faults.extend(rule.errors(&at(path)));
            }
        }
        let mut drawn = self.parameters.iter().filter(|(_, parameter)| parameter.count().is_none());
        if let Some((path, _)) = drawn.next().filter(|_| self.samples.is_none()) {
            let wanted = "the number of samples at the top of the file, such as `samples = 100`";
            faults.push(ModelError::new(at(path), "a distribution without `samples`", wanted));
        }
        faults.extend(self.faults_of_zip());
        faults.extend(self.faults_of_names());
        if self.cases().is_none_or(|cases| cases > MANY) {
            faults.push(ModelError::new("parameters", "too many combinations", "at most 10 000 000 cases"));
        }
        faults
    }

    fn faults_of_zip(&self) -> Vec<ModelError> {
        let lists = self.parameters.iter().filter_map(|(path, parameter)| Some((path, parameter.count()?)));
        let mut lists = lists.filter(|_| self.combine == Combine::Zip);
        let Some((first, count)) = lists.next() else { return Vec::new() };
        let differs = lists.filter(|(_, other)| *other != count);
        let fault = |(path, other): (&String, usize)| {
            let wanted = format!("{count}, as many as `{first}` has, since `combine` is \"zip\"");
            ModelError::new(at(path), format!("{other} values"), wanted)
        };
        differs.map(fault).collect()
    }

    /// Columns of the results that would have the same name.
    fn faults_of_names(&self) -> Vec<ModelError> {
        let mut faults = Vec::new();
        for name in self.objectives.keys() {
            let path = join("objectives", name);
            if table::COLUMNS.contains(&name.as_str()) || self.parameters.contains_key(name) {
                let found = format!("`{name}`, which is another column of the results");
                faults.push(ModelError::new(path, found, "another name"));
            }
        }
        for (name, objective) in &self.objectives {
            if objective.row.is_some() && objective.take.is_some() {
                let path = join("objectives", name);
                faults.push(ModelError::new(format!("{path}.row"), "both `take` and `row`", "one of them"));
            }
        }
        faults
    }

    /// Paths and columns that the model has not, with the first value of every parameter.
    fn faults_with(&self, data: &Value) -> Vec<ModelError> {
        let (places, mut faults) = Places::of(&self.parameters, data);
        faults.extend(places.faults());
        if let Ok(model) = Model::from_value(&places.data) {
            let columns = Simulation::new(&model).map(|simulation| simulation.columns()).unwrap_or_default();
            let columns: Vec<String> = columns.into_iter().map(|column| column.name).collect();
            for (name, objective) in &self.objectives {
                if !columns.is_empty() && !columns.contains(&objective.column) {
                    faults.push(no_column(&join("objectives", name), &objective.column, &columns));
                }
            }
        }
        faults
    }
}

/// The path of a parameter in the file.
pub fn at(path: &str) -> String {
    join("parameters", path)
}

/// Why a file cannot be read.
pub fn why(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file".into(),
        io::ErrorKind::IsADirectory => "a directory".into(),
        _ => error.to_string(),
    }
}

fn no_column(path: &str, column: &str, columns: &[String]) -> ModelError {
    let error = ModelError::new(
        format!("{path}.column"),
        format!("{column:?}, which is no column of the results"),
        "a column that `ancf run` writes for the model",
    );
    match nearest(column, columns.iter().map(String::as_str)) {
        Some(near) => error.hint(format!("did you mean {near:?}?")),
        None => error,
    }
}
