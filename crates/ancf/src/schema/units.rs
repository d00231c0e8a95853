//! Units of keys in the schema, stated by the model types.

use serde_json::{Value as Json, json};

use crate::units::UnitTree;

/// Writes units into the schema at a JSON pointer: `"x-unit": "force/length"`, or an array with a unit for each component.
pub(super) fn add_units(schema: &mut Json, at: &str, tree: &UnitTree) {
    match tree {
        UnitTree::None => {}
        UnitTree::Unit(unit) => set(schema, at, json!(unit)),
        UnitTree::Components(units) => set(schema, at, json!(units)),
        UnitTree::Keys(keys) => {
            let table = resolved(schema, at);
            for (key, tree) in keys.iter().filter(|(_, tree)| has_unit(tree)) {
                add_units(schema, &format!("{table}/properties/{key}"), tree);
            }
        }
        UnitTree::Forms(forms) => {
            let list = resolved(schema, at);
            let of = ["oneOf", "anyOf"]
                .into_iter()
                .find(|of| !schema.pointer(&list).is_none_or(|x| x[of].is_null()));
            for (i, (_, tree)) in forms.iter().enumerate().filter(|(_, (_, tree))| has_unit(tree)) {
                add_units(schema, &format!("{list}/{}/{i}", of.unwrap_or_default()), tree);
            }
        }
    }
}

fn set(schema: &mut Json, at: &str, unit: Json) {
    let key = schema.pointer_mut(at).expect("units and schema come from the same type");
    key["x-unit"] = unit;
}

/// Pointer to the schema of a value, with references, arrays, maps and absent values resolved.
fn resolved(schema: &Json, at: &str) -> String {
    let Some(here) = schema.pointer(at) else { return at.to_owned() };
    if let Some(reference) = here["$ref"].as_str() {
        return resolved(schema, reference.trim_start_matches('#'));
    }
    for inner in ["items", "additionalProperties"] {
        if here[inner].is_object() {
            return resolved(schema, &format!("{at}/{inner}"));
        }
    }
    match here["anyOf"].as_array().map(Vec::as_slice) {
        Some([_, null]) if null["type"] == "null" => resolved(schema, &format!("{at}/anyOf/0")),
        _ => at.to_owned(),
    }
}

fn has_unit(tree: &UnitTree) -> bool {
    match tree {
        UnitTree::None => false,
        UnitTree::Unit(_) | UnitTree::Components(_) => true,
        UnitTree::Keys(parts) | UnitTree::Forms(parts) => parts.iter().any(|(_, tree)| has_unit(tree)),
    }
}
