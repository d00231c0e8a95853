use serde_json::Value as Json;
use toml::Value;

use crate::errors::{ModelError, ModelErrors, listed, nearest, quoted};
use crate::schema::{SCHEMA, SchemaCheck, did_you_mean};

/// Checks a part of a model by itself: types, ranges, words and keys, as the schema has them.
///
/// The definition is that of the part in the schema, such as `"Section"` or `"Joint"`; `"Model"` is the whole. What
/// rests on other parts, such as names, is checked with the whole model ([`Model::from_value`](crate::model::Model::from_value)).
///
/// # Errors
/// All that is wrong, with paths from the part on.
///
/// ```
/// let circle = toml::toml! { kind = "circle" diameter = -1 };
/// let errors = ancf::reading::check_part("Section", &circle.into()).unwrap_err();
/// assert_eq!(errors.to_string(), "diameter: found -1, wanted a number > 0");
/// ```
pub fn check_part(definition: &str, data: &Value) -> Result<(), ModelErrors> {
    let schema = named(definition).ok_or_else(|| ModelErrors(vec![unknown(definition)]))?;
    let (survey, _) = SchemaCheck::of(schema, data);
    let errors: Vec<_> = survey.findings.into_iter().map(|finding| finding.error).collect();
    if errors.is_empty() { Ok(()) } else { Err(ModelErrors(errors)) }
}

/// The whole schema or one of its definitions.
fn named(definition: &str) -> Option<&'static Json> {
    if definition == "Model" { Some(&SCHEMA) } else { SCHEMA["$defs"].get(definition) }
}

fn unknown(definition: &str) -> ModelError {
    let definitions = || SCHEMA["$defs"].as_object().into_iter().flatten().map(|(name, _)| &**name);
    let names = || ["Model"].into_iter().chain(definitions());
    let wanted = format!("a definition of the schema: {}", listed(names().map(quoted), "or"));
    did_you_mean(ModelError::new("", quoted(definition), wanted), nearest(definition, names()).map(quoted))
}
