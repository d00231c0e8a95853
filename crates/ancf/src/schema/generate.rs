//! JSON Schema of a model file, and its description in messages.

use std::sync::LazyLock;

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use serde_json::Value as Json;
use toml::Value;

use super::units::add_units;
use crate::errors::{listed, quoted};
use crate::model::Model;

/// Schema for reading models: that of [`schema`] without units, with links in descriptions. Each run generates it.
pub(crate) static SCHEMA: LazyLock<Json> = LazyLock::new(|| {
    SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<Model>().to_value()
});

/// Returns the JSON Schema (draft 2020-12) of a model file, generated from [`Model`].
///
/// The keyword `x-unit` states the unit of a key as a product of powers, such as `force/length^2`.
pub fn schema() -> Schema {
    let schema = SchemaSettings::draft2020_12()
        .with_transform(RecursiveTransform(remove_links))
        .into_generator()
        .into_root_schema_for::<Model>();
    let mut json = schema.to_value();
    add_units(&mut json, "", &Model::unit_tree());
    Schema::try_from(json).expect("an object is a schema")
}

/// Removes links between Rust items from the description of a schema.
fn remove_links(schema: &mut Schema) {
    if let Some(Json::String(text)) = schema.get_mut("description") {
        *text = without_links(text);
    }
}

/// Returns a description without links between Rust items.
pub(super) fn without_links(description: &str) -> String {
    description.replace("[`", "`").replace("`]", "`")
}

/// Alternative forms of a schema, with references resolved.
pub(crate) fn forms(schema: &'static Json) -> Vec<&'static Json> {
    let name = schema["$ref"].as_str().and_then(|name| name.strip_prefix("#/$defs/"));
    if let Some(name) = name {
        return forms(&SCHEMA["$defs"][name]);
    }
    match ["oneOf", "anyOf"].iter().find_map(|key| schema[*key].as_array()) {
        // `null` marks an optional key; it is not a form of the value.
        Some(forms_of) => forms_of.iter().flat_map(forms).filter(|form| form["type"] != "null").collect(),
        None => vec![schema],
    }
}

/// True if a form allows any value.
pub(crate) fn is_free(form: &Json) -> bool {
    form["type"].is_null() && form["const"].is_null()
}

/// Type of a form. `null` is ignored, since `required` states whether a key is optional.
pub(crate) fn kind(form: &Json) -> &str {
    let first = |types: &'_ Vec<Json>| types.iter().position(|kind| kind != "null");
    match &form["type"] {
        Json::Array(types) => first(types).and_then(|at| types[at].as_str()).unwrap_or_default(),
        kind => kind.as_str().unwrap_or_default(),
    }
}

/// Key that distinguishes the forms of a table, and its value in this form.
pub(crate) fn tag(form: &'static Json) -> Option<(&'static str, &'static str)> {
    let keys = form["properties"].as_object()?;
    keys.iter().find_map(|(key, schema)| Some((key.as_str(), schema["const"].as_str()?)))
}

/// Keys of a table, in alphabetical order.
pub(crate) fn keys(form: &'static Json) -> Vec<&'static str> {
    let mut keys: Vec<_> =
        form["properties"].as_object().into_iter().flatten().map(|(key, _)| &**key).collect();
    keys.sort_unstable();
    keys
}

/// Required keys of a table, in the order of the type.
pub(crate) fn required(form: &'static Json) -> impl Iterator<Item = &'static str> {
    form["required"].as_array().into_iter().flatten().filter_map(Json::as_str)
}

/// True if a number is within the limits of a form.
pub(crate) fn allows(form: &Json, x: f64) -> bool {
    let holds = |key: &str, test: fn(f64, f64) -> bool| form[key].as_f64().is_none_or(|limit| test(x, limit));
    x.is_finite()
        && holds("minimum", |x, limit| x >= limit)
        && holds("exclusiveMinimum", |x, limit| x > limit)
        && holds("maximum", |x, limit| x <= limit)
        && holds("exclusiveMaximum", |x, limit| x < limit)
        && (form["format"] != "uint32" || x <= f64::from(u32::MAX))
}

/// Description of the values that a form allows.
pub(crate) fn expected(form: &'static Json) -> String {
    match kind(form) {
        "number" => format!("a number{}", limits(form)),
        "integer" => format!("an integer{}", limits(form)),
        "boolean" => "true or false".into(),
        "array" => wanted_array(form),
        "object" => wanted_table(form),
        _ => match form["const"].as_str() {
            Some(word) => format!("{word:?}"),
            None if form["minLength"].as_u64() > Some(0) => "a text that is not empty".into(),
            None => "a text".into(),
        },
    }
}

fn limits(form: &Json) -> String {
    let signs = [("exclusiveMinimum", ">"), ("minimum", ">="), ("exclusiveMaximum", "<"), ("maximum", "<=")];
    let limits: Vec<_> = signs
        .iter()
        .filter(|(key, _)| !form[*key].is_null())
        .map(|(key, sign)| format!(" {sign} {}", form[*key]))
        .collect();
    limits.join(" and")
}

fn wanted_array(form: &'static Json) -> String {
    let items = match forms(&form["items"]).first().map(|item| kind(item)) {
        Some("number") => "number",
        Some("object") => "table",
        _ => "value",
    };
    match (form["minItems"].as_u64(), form["maxItems"].as_u64()) {
        (Some(min), Some(max)) if min == max => format!("an array of {min} {items}s"),
        (Some(1), None) => format!("an array of at least one {items}"),
        _ => format!("an array of {items}s"),
    }
}

fn wanted_table(form: &'static Json) -> String {
    match listed(required(form).map(|key| format!("`{key}`")), "and") {
        keys if keys.is_empty() => "a table".into(),
        keys => format!("a table with {keys}"),
    }
}

/// Description of the values that alternative forms allow.
pub(crate) fn wanted_of(forms: &[&'static Json]) -> String {
    let tags: Vec<_> = forms.iter().filter_map(|form| tag(form)).collect();
    match tags.first() {
        Some((key, _)) if tags.len() > 1 => {
            let tagged = listed(tags.iter().map(|(_, word)| quoted(word)), "or");
            let others = forms.iter().filter(|form| tag(form).is_none()).map(|form| expected(form));
            listed(others.chain([format!("a table with `{key}` = {tagged}")]), "or")
        }
        _ => listed(forms.iter().map(|form| expected(form)), "or"),
    }
}

/// Description of a value: short values as in a model file.
pub(crate) fn found(value: &Value) -> String {
    match value {
        Value::String(text) => quoted(text),
        Value::Integer(n) => n.to_string(),
        Value::Float(x) if x.is_nan() => "nan".into(),
        Value::Float(x) => format!("{x:?}"),
        Value::Boolean(yes) => yes.to_string(),
        Value::Datetime(date) => format!("the date {date}"),
        Value::Array(items) if items.is_empty() => "an empty array".into(),
        Value::Array(items) => format!("an array of {}", items.len()),
        Value::Table(_) => "a table".into(),
    }
}
