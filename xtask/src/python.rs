//! The classes of the Python package, written from the schema of models.

mod class;
mod form;
mod hint;
mod names;
mod text;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use crate::system::shell::Done;
use class::Code;
use form::{definition, referred};

/// Where the classes are.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates/ancf-py/python/ancf/model")
}

/// Writes the classes anew.
pub(crate) fn write(schema: &str) -> Done {
    let files = files(schema)?;
    let folder = folder();
    let wrong = |error| format!("{}: {error}", folder.display());
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(wrong)?;
    }
    fs::create_dir_all(&folder).map_err(wrong)?;
    files.iter().try_for_each(|(name, text)| fs::write(folder.join(name), text)).map_err(wrong)
}

/// The files of the classes and their texts.
fn files(schema: &str) -> Result<BTreeMap<String, String>, String> {
    let schema: Json = serde_json::from_str(schema).map_err(|error| format!("the schema: {error}"))?;
    let mut homes = BTreeMap::new();
    let mut modules = Vec::new();
    let mut taken = BTreeSet::new();
    for (module, what, roots) in names::MODULES {
        let mut definitions = Vec::new();
        roots.iter().for_each(|root| reach(&schema, root, &mut taken, &mut definitions));
        let codes: Vec<Code> = definitions.iter().map(|name| Code::of(&schema, name)).collect();
        for name in codes.iter().flat_map(|code| &code.defines) {
            if let Some(other) = homes.insert(name.clone(), module) {
                let table = "xtask/src/python/names.rs";
                return Err(format!(
                    "two classes are called `{name}`, in {other}.py and {module}.py: name them in {table}"
                ));
            }
        }
        modules.push((module, what, codes));
    }
    let text = |(module, what, codes): &(&str, &str, Vec<Code>)| {
        (format!("{module}.py"), module_text(module, what, codes, &homes))
    };
    let mut files: BTreeMap<_, _> = modules.iter().map(text).collect();
    files.insert("__init__.py".into(), package_text(&homes));
    Ok(files)
}

/// The definitions that are needed for one and not yet in a module, each after those that it needs.
fn reach(schema: &Json, name: &str, taken: &mut BTreeSet<String>, found: &mut Vec<String>) {
    if !taken.insert(name.to_owned()) {
        return;
    }
    let of = definition(schema, name);
    let mut needs = Vec::new();
    // The whole is the schema without its definitions.
    of.as_object()
        .into_iter()
        .flatten()
        .filter(|(key, _)| *key != "$defs")
        .for_each(|(_, part)| needed(part, &mut needs));
    needs.iter().for_each(|name| reach(schema, name, taken, found));
    found.push(name.to_owned());
}

fn needed(part: &Json, needs: &mut Vec<String>) {
    needs.extend(referred(part).map(str::to_owned));
    match part {
        Json::Object(table) => table.values().for_each(|part| needed(part, needs)),
        Json::Array(items) => items.iter().for_each(|part| needed(part, needs)),
        _ => {}
    }
}

const ORIGIN: &str = "# Written by `cargo xtask schema` from the types of the program: change those.\n";

fn module_text(module: &str, what: &str, codes: &[Code], homes: &BTreeMap<String, &str>) -> String {
    let uses: BTreeSet<&str> = codes.iter().flat_map(|code| &code.uses).map(String::as_str).collect();
    let own: Vec<&str> = codes.iter().flat_map(|code| &code.defines).map(String::as_str).collect();
    let mut imports: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for name in uses {
        let home = match homes.get(name) {
            Some(home) if *home == module => continue,
            Some(home) => format!("ancf.model.{home}"),
            None => foreign(name).into(),
        };
        imports.entry(home).or_default().push(name);
    }
    let (inner, outer): (Vec<_>, Vec<_>) = imports.iter().partition(|(home, _)| home.starts_with("ancf"));
    let lines = |imports: Vec<(&String, &Vec<&str>)>| {
        imports.into_iter().map(|(home, names)| import(home, names)).collect::<String>()
    };
    let outer = lines(outer);
    let inner = lines(inner);
    let gap = if outer.is_empty() || inner.is_empty() { "" } else { "\n" };
    let blocks: Vec<String> = codes.iter().flat_map(|code| code.blocks.clone()).collect();
    let (all, text) = (all(&own), spaced(&blocks));
    format!("\"\"\"{what}\"\"\"\n\n{ORIGIN}\n{outer}{gap}{inner}\n{all}{text}")
}

/// The module of a name that is in none of those written here.
fn foreign(name: &str) -> &'static str {
    match name {
        "Callable" | "Mapping" | "Sequence" => "collections.abc",
        "dataclass" | "field" => "dataclasses",
        "ClassVar" | "Literal" | "TypeAlias" => "typing",
        "Axis" | "Frame" | "Point" => "ancf.axis",
        "Document" => "ancf.document",
        _ => "ancf.part",
    }
}

fn import(home: &str, names: &[&str]) -> String {
    let line = format!("from {home} import {}\n", names.join(", "));
    if line.chars().count() <= text::WIDTH + 1 {
        line
    } else {
        format!("from {home} import (\n    {},\n)\n", names.join(",\n    "))
    }
}

/// `__all__`, in the order of ruff: words in capitals first.
fn all(names: &[&str]) -> String {
    let mut names = names.to_vec();
    names.sort_by_key(|name| (name.chars().any(char::is_lowercase), name.to_owned()));
    let quoted: Vec<_> = names.iter().map(|name| format!("{name:?}")).collect();
    let line = format!("__all__ = [{}]\n", quoted.join(", "));
    if line.chars().count() <= text::WIDTH + 1 {
        line
    } else {
        format!("__all__ = [\n    {},\n]\n", quoted.join(",\n    "))
    }
}

/// Blocks with two empty lines about classes and one between others.
fn spaced(blocks: &[String]) -> String {
    let is_class = |block: &String| block.starts_with('@');
    let mut text = String::new();
    for (i, block) in blocks.iter().enumerate() {
        let is_far = is_class(block) || i > 0 && is_class(&blocks[i - 1]);
        text += if is_far { "\n\n" } else { "\n" };
        text += block;
    }
    text
}

fn package_text(homes: &BTreeMap<String, &str>) -> String {
    let mut modules: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    homes.iter().for_each(|(name, home)| modules.entry(*home).or_default().push(name));
    let imports: String = modules
        .iter_mut()
        .map(|(home, names)| {
            names.sort_by_key(|name| (name.chars().any(char::is_lowercase), name.to_owned()));
            import(&format!("ancf.model.{home}"), names)
        })
        .collect();
    let names: Vec<&str> = homes.keys().map(String::as_str).collect();
    format!(
        "\"\"\"The parts of a model: a class for every form of the schema.\"\"\"\n\n{ORIGIN}\n{imports}\n{}",
        all(&names)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_classes_of_python_are_up_to_date() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/model.schema.json");
        let wanted = files(&fs::read_to_string(path).expect("the schema")).expect("classes");
        let entries =
            fs::read_dir(folder()).expect("the folder").map(|entry| entry.expect("an entry").path());
        let found: BTreeMap<_, _> = entries
            .filter(|path| path.extension().is_some_and(|extension| extension == "py"))
            .map(|path| {
                let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                (name, fs::read_to_string(&path).unwrap_or_default())
            })
            .collect();
        assert!(
            found == wanted,
            "crates/ancf-py/python/ancf/model is stale: refresh it by `cargo xtask schema`"
        );
    }
}
