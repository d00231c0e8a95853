use serde_json::Value as Json;
use toml::Value;

use crate::errors::{ModelError, ModelErrors, listed, nearest, quoted};
use crate::schema::{SCHEMA, SchemaCheck, did_you_mean};

/// Checks a single part of a model against the schema: types, ranges, words and keys.
///
/// `definition` is the name of the part in the schema, such as `"Section"` or `"Joint"`, or `"Model"` for the whole model.
/// References to other parts, such as names, are checked with the whole model ([`Model::from_value`](crate::model::Model::from_value)).
///
/// # Errors
/// All errors of the part, with paths relative to the part.
///
/// ```
/// let circle = toml::toml! { kind = "circle" diameter = -1 };
/// let errors = ancf::reading::check_part("Section", &circle.into()).unwrap_err();
/// assert_eq!(errors.to_string(), "diameter: found -1, expected a number > 0");
/// ```
pub fn check_part(definition: &str, data: &Value) -> Result<(), ModelErrors> {
    let schema = schema_of(definition).ok_or_else(|| ModelErrors(vec![unknown_definition(definition)]))?;
    let (check, _) = SchemaCheck::of(schema, data.clone());
    let errors: Vec<_> = check.findings.into_iter().map(|finding| finding.error).collect();
    if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
}

/// Returns the whole schema or one of its definitions.
fn schema_of(definition: &str) -> Option<&'static Json> {
    if definition == "Model" { Some(&SCHEMA) } else { SCHEMA["$defs"].get(definition) }
}

fn unknown_definition(definition: &str) -> ModelError {
    let definitions = || SCHEMA["$defs"].as_object().into_iter().flatten().map(|(name, _)| &**name);
    let names = || ["Model"].into_iter().chain(definitions());
    let expected = format!("a definition of the schema: {}", listed(names().map(quoted), "or"));
    did_you_mean(ModelError::new("", quoted(definition), expected), nearest(definition, names()).map(quoted))
}
