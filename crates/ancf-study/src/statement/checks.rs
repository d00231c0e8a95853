//! Parsing and checks of a study file.

use std::fs;
use std::path::Path;
use std::sync::LazyLock;

use ancf::errors::nearest;
use ancf::reading::parse_as;
use ancf::schema::join;
use ancf::{Model, ModelError, ModelErrors, Simulation};
use schemars::generate::SchemaSettings;
use serde_json::Value as Json;
use toml::{Table, Value};

use super::columns::TABLE_COLUMNS;
use super::layout::Combine;
use super::parameter::{Parameter, parameter_path};
use super::places::check_places;
use super::read_failure::read_failure;
use super::sampling::Sampling;
use super::sobol::MAX_SOBOL_DIMENSION;
use super::study::Study;

/// JSON Schema of study files.
static SCHEMA: LazyLock<Json> = LazyLock::new(|| {
    let mut settings = SchemaSettings::draft2020_12();
    settings.inline_subschemas = true;
    settings.into_generator().into_root_schema_for::<Study>().to_value()
});

/// Maximum number of cases of a study.
pub const MAX_CASES: usize = 10_000_000;

impl Study {
    /// Parses the text of a study. The path of the model is relative to `folder`.
    ///
    /// # Errors
    /// All errors of the study, in the order of the text. The model itself is not checked.
    pub fn parse(text: &str, folder: &Path) -> Result<Self, ModelErrors> {
        parse_as(text, &SCHEMA, |study: &Self| errors(study, folder))
    }
}

/// Returns all errors of a study.
fn errors(study: &Study, folder: &Path) -> Vec<ModelError> {
    let mut errors = parameter_errors(study);
    match fs::read_to_string(folder.join(&study.model)) {
        Ok(text) => {
            let data = text.parse::<Table>().map(Value::Table);
            errors.extend(data.map(|data| errors_with_model(study, &data)).unwrap_or_default());
        }
        Err(error) => {
            let found = format!("{:?}: {}", study.model.display().to_string(), read_failure(&error));
            errors.push(ModelError::new("model", found, "a model file, relative to the file of the study"));
        }
    }
    errors
}

/// Returns the errors that do not depend on the model.
fn parameter_errors(study: &Study) -> Vec<ModelError> {
    let mut errors = Vec::new();
    for (path, parameter) in &study.parameters {
        if let Parameter::Rule(rule) = parameter {
            errors.extend(rule.errors(&parameter_path(path)));
        }
    }
    if let Some((path, _)) = study.distributions().next().filter(|_| study.samples.is_none()) {
        let expected = "the number of samples at the top of the file, such as `samples = 100`";
        errors.push(ModelError::new(parameter_path(path), "a distribution without `samples`", expected));
    }
    errors.extend(dimension_error(study));
    if study.combine == Combine::Zip {
        let count = |(path, parameter): (&String, &Parameter)| Some((path.clone(), parameter.count()?));
        errors.extend(zip_errors(&study.parameters.iter().filter_map(count).collect::<Vec<_>>()));
    }
    errors.extend(name_errors(study));
    if study.layout().is_none_or(|layout| layout.cases > MAX_CASES) {
        errors.push(ModelError::new("parameters", "too many combinations", "at most 10 000 000 cases"));
    }
    errors
}

/// Returns an error for more distributions than a Sobol sequence has dimensions.
fn dimension_error(study: &Study) -> Option<ModelError> {
    let count = study.distributions().count();
    let is_excessive = study.sampling == Sampling::Sobol && count > MAX_SOBOL_DIMENSION;
    let expected = format!("at most {MAX_SOBOL_DIMENSION} in a Sobol sequence");
    is_excessive.then(|| ModelError::new("parameters", format!("{count} distributions"), expected))
}

/// Returns an error for each zipped list whose length differs from the length of the first.
///
/// `lists` has the path and the length of each list.
pub fn zip_errors(lists: &[(String, usize)]) -> Vec<ModelError> {
    let Some(((first, count), others)) = lists.split_first() else { return Vec::new() };
    let differs = others.iter().filter(|(_, other)| other != count);
    let error = |(path, other): &(String, usize)| {
        let expected = format!("{count}, as many as `{first}` has, since `combine` is \"zip\"");
        ModelError::new(parameter_path(path), format!("{other} values"), expected)
    };
    differs.map(error).collect()
}

/// Returns the errors of objectives: names of other columns, `take` together with `row`.
fn name_errors(study: &Study) -> Vec<ModelError> {
    let mut errors = Vec::new();
    for name in study.objectives.keys() {
        let path = join("objectives", name);
        if TABLE_COLUMNS.contains(&name.as_str()) || study.parameters.contains_key(name) {
            let found = format!("`{name}`, which is another column of the results");
            errors.push(ModelError::new(path, found, "another name"));
        }
    }
    for (name, objective) in &study.objectives {
        if objective.row.is_some() && objective.take.is_some() {
            let path = join("objectives", name);
            errors.push(ModelError::new(format!("{path}.row"), "both `take` and `row`", "one of them"));
        }
    }
    errors
}

/// Returns the errors of paths and columns that the model with the first value of every parameter does not have.
fn errors_with_model(study: &Study, data: &Value) -> Vec<ModelError> {
    let first = |(path, parameter): (&String, &Parameter)| Some((path.clone(), parameter.first()?));
    let first: Vec<_> = study.parameters.iter().filter_map(first).collect();
    let (data, mut errors) = check_places(&first, data);
    if let Ok(model) = Model::from_value(&data) {
        let columns = Simulation::new(&model).map(|simulation| simulation.columns()).unwrap_or_default();
        let columns: Vec<String> = columns.into_iter().map(|column| column.name).collect();
        for (name, objective) in &study.objectives {
            if !columns.is_empty() && !columns.contains(&objective.column) {
                errors.push(unknown_column(&join("objectives", name), &objective.column, &columns));
            }
        }
    }
    errors
}

/// Returns the error of an objective whose column does not exist.
fn unknown_column(path: &str, column: &str, columns: &[String]) -> ModelError {
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
