//! Members of the cargo workspace.

use std::fs;
use std::path::Path;

use super::workspace::config::{Config, FILE};
use super::workspace::violation::Violation;

/// Finds members of the workspace whose sources are no tree.
pub(super) fn missing(root: &Path, config: &Config) -> Result<Vec<Violation>, String> {
    let path = root.join("Cargo.toml");
    if !path.exists() {
        return Ok(Vec::new());
    }
    let text = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let manifest: toml::Table =
        toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    let members =
        manifest.get("workspace").and_then(|table| table.get("members")).and_then(toml::Value::as_array);
    let mut found = Vec::new();
    for member in members.into_iter().flatten().filter_map(toml::Value::as_str) {
        for package in packages(root, member) {
            let source = format!("{package}/src");
            if root.join(&source).is_dir() && !config.trees.iter().any(|tree| tree.path == source) {
                let text = format!("{source}: no tree in {FILE}; add a [[tree]] with its layers");
                found.push(Violation::new(usize::MAX, text));
            }
        }
    }
    Ok(found)
}

/// Expands a member that ends with `/*`.
fn packages(root: &Path, member: &str) -> Vec<String> {
    let Some(folder) = member.strip_suffix("/*") else { return vec![member.to_owned()] };
    let entries = fs::read_dir(root.join(folder)).into_iter().flatten().flatten();
    let mut found: Vec<_> =
        entries.map(|entry| format!("{folder}/{}", entry.file_name().to_string_lossy())).collect();
    found.sort();
    found
}
