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
            for (i, (word, tree)) in forms.iter().enumerate().filter(|(_, (_, tree))| has_unit(tree)) {
                add_units(schema, &form(schema, &list, i, word), tree);
            }
        }
    }
}

/// Pointer to a form of a value: the form with this tag, else the form with this index in the type.
fn form(schema: &Json, list: &str, index: usize, word: &str) -> String {
    for key in ["oneOf", "anyOf"] {
        let Some(forms) = schema.pointer(list).and_then(|list| list[key].as_array()) else { continue };
        let is_tagged = |form: &Json| {
            let keys = form["properties"].as_object();
            keys.is_some_and(|keys| keys.values().any(|value| value["const"] == word))
        };
        let index = forms.iter().position(is_tagged).unwrap_or(index);
        return format!("{list}/{key}/{index}");
    }
    list.to_owned()
}

fn set(schema: &mut Json, at: &str, unit: Json) {
    let key = schema.pointer_mut(at).expect("units and schema come from the same type");
    key["x-unit"] = unit;
}

/// Pointer to the schema of a value, with references, arrays, maps and optional values resolved.
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use crate::schema::schema;

    use super::*;

    /// Exponents of length, time and force of a unit, such as `force length/time²` or `force*length/time^2`.
    fn dimension(text: &str) -> Option<[i32; 3]> {
        let mut exponents = [0; 3];
        let mut rest = text.trim().strip_prefix("in ").unwrap_or(text.trim());
        let mut sign = 1;
        loop {
            let end = rest.find([' ', '*', '/']).unwrap_or(rest.len());
            let (word, power) = match rest[..end].strip_suffix(['²', '³', '⁴']) {
                Some(word) => (word, "²³⁴".chars().position(|power| rest[..end].ends_with(power))? + 2),
                None => match rest[..end].split_once('^') {
                    Some((word, power)) => (word, power.parse().ok()?),
                    None => (&rest[..end], 1),
                },
            };
            let of = match word {
                "length" => [1, 0, 0],
                "time" => [0, 1, 0],
                "force" => [0, 0, 1],
                "mass" => [-1, 2, 1],
                "area" => [2, 0, 0],
                "volume" => [3, 0, 0],
                "1" | "radian" | "radians" | "cycle" | "cycles" => [0; 3],
                _ => return None,
            };
            (0..3).for_each(|k| exponents[k] += sign * i32::try_from(power).unwrap_or(0) * of[k]);
            if end == rest.len() {
                return Some(exponents);
            }
            sign = if rest.as_bytes()[end] == b'/' { -1 } else { 1 };
            rest = &rest[end + 1..];
        }
    }

    /// Units in a description: those parts between commas, semicolons and full stops that are units.
    fn described(text: &str) -> BTreeSet<[i32; 3]> {
        let text = text.replace('\n', " ");
        let parts = text.split(". ").flat_map(|sentence| sentence.trim_end_matches('.').split([',', ';']));
        parts.filter_map(dimension).collect()
    }

    fn stated(unit: &Json) -> BTreeSet<[i32; 3]> {
        let texts = unit.as_array().map_or_else(|| vec![unit], |units| units.iter().collect());
        texts.iter().map(|text| dimension(text.as_str().unwrap()).unwrap()).collect()
    }

    /// Collects paths and schemas of all parts with a unit.
    fn quantities<'a>(part: &'a Json, path: &str, found: &mut Vec<(String, &'a Json)>) {
        if !part["x-unit"].is_null() {
            found.push((path.to_owned(), part));
        }
        match part {
            Json::Object(table) => {
                table.iter().for_each(|(key, part)| quantities(part, &format!("{path}/{key}"), found));
            }
            Json::Array(items) => {
                items
                    .iter()
                    .enumerate()
                    .for_each(|(i, part)| quantities(part, &format!("{path}/{i}"), found));
            }
            _ => {}
        }
    }

    #[test]
    fn descriptions_agree_with_units() {
        let mut found = Vec::new();
        let schema = schema().to_value();
        quantities(&schema, "", &mut found);
        assert!(found.len() > 80, "{} units", found.len());
        let mut silent = Vec::new();
        for (path, part) in found {
            let description = part["description"].as_str().unwrap_or_default();
            match described(description) {
                units if units.is_empty() => silent.push(path),
                units => assert_eq!(units, stated(&part["x-unit"]), "{path}: {description}"),
            }
        }
        assert_eq!(silent, Vec::<String>::new());
    }

    #[test]
    fn numbers_without_unit_are_known() {
        let schema = schema().to_value();
        let unit = |pointer: &str| schema.pointer(pointer).unwrap()["x-unit"].clone();
        assert_eq!(unit("/properties/gravity"), "length/time^2");
        assert_eq!(unit("/$defs/Material/properties/density"), "mass/length^3");
        assert_eq!(unit("/$defs/Material/properties/poisson"), Json::Null);
        assert_eq!(unit("/$defs/Step/anyOf/0"), "time");
        assert_eq!(unit("/$defs/At/anyOf/2"), "length");
        let axis = ["force/length"; 3].into_iter().chain(["force*length/radian"; 3]).collect::<Vec<_>>();
        let joints = schema["$defs"]["Joint"]["oneOf"].as_array().unwrap();
        let bushing = joints.iter().find(|joint| joint["properties"]["kind"]["const"] == "bushing").unwrap();
        assert_eq!(bushing["properties"]["stiffness"]["x-unit"], json!(axis));
    }

    #[test]
    fn reads_units() {
        assert_eq!(dimension("force length/time²"), Some([1, -2, 1]));
        assert_eq!(dimension("mass*length^2"), Some([1, 2, 1]));
        assert_eq!(dimension("in radians"), Some([0; 3]));
        assert_eq!(dimension("the length"), None);
    }
}
