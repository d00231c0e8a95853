//! Schema of model files for editors, with the keys of files with several analyses.

use serde_json::{Value as Json, json};

use super::generate::schema;

/// Parts that may exist in some analyses only.
const PARTS: [&str; 6] = ["Joint", "Coupling", "Load", "Input", "Contact", "Probe"];

/// Returns the text of `docs/model.schema.json`, for completion and checks in an editor.
///
/// It is [`schema`] with the keys of files with several analyses ([`AnalysisSequence`](crate::reading::AnalysisSequence)), which the
/// keyword `x-sequence` marks.
pub fn schema_text() -> String {
    let mut schema = schema().to_value();
    let names = |text: &str| json!({ "description": text, "type": "array", "items": { "type": "string" }, "x-sequence": true });
    let presence = [
        ("only_in", names("Names of the analyses of a list in which this part exists; all by default.")),
        (
            "not_in",
            names("Names of the analyses of a list in which this part does not exist; none by default."),
        ),
    ];
    for part in PARTS {
        add_keys(&mut schema["$defs"][part], &presence);
    }
    let name = "Name of the analysis, with letters, digits, `_` and `-`; its kind by default.";
    let set = "Values of other keys of the model in this analysis, by path, such as `\"loads[0].force\" = [0, 0, 1]`.";
    let own = [
        ("name", json!({ "description": name, "type": "string", "minLength": 1 })),
        ("set", json!({ "description": set, "type": "object" })),
    ];
    let mut item = schema["$defs"]["Analysis"].clone();
    add_keys(&mut item, &own);
    item["description"] = "Analysis of a list. It starts in the last state before it.".into();
    schema["$defs"]["SequenceAnalysis"] = item;
    schema["properties"]["analysis"] = json!({
        "description": "Analysis to run, or a list of analyses.",
        "anyOf": [
            { "$ref": "#/$defs/Analysis" },
            {
                "type": "array",
                "items": { "$ref": "#/$defs/SequenceAnalysis" },
                "minItems": 1,
                "x-sequence": true,
            },
        ],
    });
    let text = serde_json::to_string_pretty(&schema);
    text.expect("a schema has text keys and finite numbers only") + "\n"
}

/// Adds keys to all forms of a table.
fn add_keys(schema: &mut Json, keys: &[(&str, Json)]) {
    if let Some(properties) = schema.get_mut("properties").and_then(Json::as_object_mut) {
        properties.extend(keys.iter().map(|(key, schema)| ((*key).to_owned(), schema.clone())));
    }
    for forms in ["oneOf", "anyOf"] {
        let forms = schema.get_mut(forms).and_then(Json::as_array_mut).into_iter().flatten();
        forms.for_each(|form| add_keys(form, keys));
    }
}
