//! Schema of model files with a single analysis, from which classes and tables of keys are generated.

use serde_json::Value as Json;

/// Reads the schema of model files without the keys and definitions of files with several analyses.
///
/// # Errors
/// If the text is not JSON.
pub(crate) fn single_analysis(schema: &str) -> Result<Json, String> {
    let mut schema: Json = serde_json::from_str(schema).map_err(|error| format!("the schema: {error}"))?;
    if let Some(definitions) = schema["$defs"].as_object_mut() {
        definitions.remove("SequenceAnalysis");
    }
    remove_marked(&mut schema);
    let analysis = &mut schema["properties"]["analysis"];
    *analysis = serde_json::json!({ "description": "Analysis to run.", "$ref": "#/$defs/Analysis" });
    Ok(schema)
}

fn remove_marked(json: &mut Json) {
    let is_marked = |json: &Json| json.get("x-sequence").is_some();
    match json {
        Json::Object(members) => {
            members.retain(|_, member| !is_marked(member));
            members.values_mut().for_each(remove_marked);
        }
        Json::Array(items) => {
            items.retain(|item| !is_marked(item));
            items.iter_mut().for_each(remove_marked);
        }
        _ => {}
    }
}
