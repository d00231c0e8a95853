//! Python type hints of schemas.

use std::collections::BTreeSet;

use serde_json::Value as Json;

use super::form::{alternatives, referred};
use super::names;

/// Returns the type hint of a schema and adds the names in it to `uses`.
pub(super) fn hint(schema: &Json, of: &Json, uses: &mut BTreeSet<String>) -> String {
    arms(schema, of, uses).join(" | ")
}

/// Returns the types that a schema allows. Words form one `Literal`.
pub(super) fn arms(schema: &Json, of: &Json, uses: &mut BTreeSet<String>) -> Vec<String> {
    let alternatives = alternatives(of);
    let words: Vec<String> =
        alternatives.iter().filter_map(|form| Some(format!("{:?}", form["const"].as_str()?))).collect();
    let mut arms = Vec::new();
    if !words.is_empty() {
        uses.insert("Literal".into());
        arms.push(format!("Literal[{}]", words.join(", ")));
    }
    let others = alternatives.into_iter().filter(|form| form["const"].is_null());
    arms.extend(others.map(|form| one(schema, form, uses)));
    arms
}

fn one(schema: &Json, of: &Json, uses: &mut BTreeSet<String>) -> String {
    if let Some(name) = referred(of) {
        let name = names::alias(name).to_owned();
        uses.insert(name.clone());
        return name;
    }
    match kind(of) {
        "number" => "float".into(),
        "integer" => "int".into(),
        "boolean" => "bool".into(),
        "string" => "str".into(),
        "array" => array(schema, of, uses),
        _ => {
            uses.insert("Mapping".into());
            format!("Mapping[str, {}]", hint(schema, &of["additionalProperties"], uses))
        }
    }
}

fn array(schema: &Json, of: &Json, uses: &mut BTreeSet<String>) -> String {
    let items = &of["items"];
    let name = match (kind(items), of["minItems"].as_u64(), of["maxItems"].as_u64()) {
        ("number", Some(3), Some(3)) => "Vector",
        ("number", ..) => "Numbers",
        ("array", ..) if kind(&items["items"]) == "array" => "PointGrid",
        ("array", ..) => "Points",
        _ => {
            uses.insert("Sequence".into());
            return format!("Sequence[{}]", hint(schema, items, uses));
        }
    };
    uses.insert(name.into());
    name.into()
}

/// Returns the JSON type of a schema without reference and alternatives.
pub(crate) fn kind(of: &Json) -> &str {
    match &of["type"] {
        Json::Array(kinds) => {
            kinds.iter().filter_map(Json::as_str).find(|kind| *kind != "null").unwrap_or_default()
        }
        kind => kind.as_str().unwrap_or_default(),
    }
}
