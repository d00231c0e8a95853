//! Definitions of the schema and their forms.

use serde_json::Value as Json;

use super::names;

/// An object schema, which becomes a Python class.
pub(super) struct Form<'a> {
    pub(super) definition: &'a str,
    pub(super) class: String,
    pub(super) description: &'a str,
    /// Key and word that distinguish the form from the others of its definition.
    pub(super) tag: Option<(&'a str, &'a str)>,
    /// Module of the class, if it is not the module of the definition.
    pub(super) module: Option<&'static str>,
    pub(super) keys: Vec<Key<'a>>,
}

/// A key of a form.
pub(super) struct Key<'a> {
    pub(super) name: &'a str,
    pub(super) schema: &'a Json,
    pub(super) is_required: bool,
}

/// Returns a definition by name. `Model` is the schema itself.
pub(crate) fn definition<'a>(schema: &'a Json, name: &str) -> &'a Json {
    if name == "Model" { schema } else { &schema["$defs"][name] }
}

/// Returns the name of the definition to which a schema refers.
pub(crate) fn referred(schema: &Json) -> Option<&str> {
    schema["$ref"].as_str()?.strip_prefix("#/$defs/")
}

/// Returns the alternatives of a schema without `null`, or the schema itself if it has none.
pub(crate) fn alternatives(schema: &Json) -> Vec<&Json> {
    let list = ["oneOf", "anyOf"].iter().find_map(|key| schema[*key].as_array());
    let all = list.map_or_else(|| vec![schema], |list| list.iter().collect());
    all.into_iter().filter(|form| form["type"] != "null").collect()
}

/// Returns the description of a schema.
pub(crate) fn description(schema: &Json) -> &str {
    schema["description"].as_str().unwrap_or_default()
}

/// Returns the object schemas among the forms of a definition.
pub(super) fn forms<'a>(name: &'a str, schema: &'a Json) -> Vec<Form<'a>> {
    let alternatives = alternatives(schema);
    let is_alone = alternatives.len() == 1 && schema["oneOf"].is_null() && schema["anyOf"].is_null();
    let tables = alternatives.into_iter().filter(|form| form["properties"].is_object());
    tables.map(|table| form(name, table, is_alone)).collect()
}

fn form<'a>(definition: &'a str, table: &'a Json, is_alone: bool) -> Form<'a> {
    let properties = || table["properties"].as_object().into_iter().flatten();
    let tag = properties().find_map(|(key, schema)| Some((key.as_str(), schema["const"].as_str()?)));
    let required: Vec<&str> =
        table["required"].as_array().into_iter().flatten().filter_map(Json::as_str).collect();
    let word = tag.map(|(_, word)| word).or(required.first().copied()).unwrap_or_default();
    let class = if is_alone { names::alias(definition).to_owned() } else { names::class(definition, word) };
    let mut keys: Vec<Key<'a>> = properties()
        .filter(|(name, _)| tag.is_none_or(|(tag, _)| tag != *name))
        .map(|(name, schema)| Key { name, schema, is_required: required.contains(&name.as_str()) })
        .collect();
    let first = names::positional(&class);
    let place = |key: &Key| {
        let positional = first.iter().position(|name| *name == key.name).unwrap_or(first.len());
        let stated = required.iter().position(|name| *name == key.name).unwrap_or(required.len());
        (positional, stated, key.name.to_owned())
    };
    keys.sort_by_key(place);
    let module = names::form_module(definition, word);
    Form { definition, class, description: description(table), tag, module, keys }
}
