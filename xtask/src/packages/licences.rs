//! Licence texts of the crates in a program.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// Packages of the workspace that are distributed as binaries.
const PROGRAMS: [&str; 2] = ["ancf-cli", "ancf-fmu"];
/// First words of the names of licence files.
const NAMES: [&str; 6] = ["LICENSE", "LICENCE", "COPYING", "COPYRIGHT", "NOTICE", "UNLICENSE"];
/// Licences of parts that are not crates.
const OTHERS: [&str; 2] =
    ["crates/ancf-figure/assets/fonts/Arimo-OFL.txt", "crates/ancf-report/assets/licences.txt"];

/// Returns the licence texts of all crates of other authors in the program, each text once with the crates that state it.
///
/// Crates without a licence file are listed with their licence expression and authors.
pub(crate) fn third_party(source: &Path, target: &str) -> Result<String, String> {
    let metadata = metadata(source, target)?;
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut without = Vec::new();
    for package in linked(&metadata)? {
        let text = |key: &str| package[key].as_str().unwrap_or_default();
        let name = format!("{} {} ({})", text("name"), text("version"), text("license"));
        let folder = Path::new(text("manifest_path")).parent().map(PathBuf::from).unwrap_or_default();
        let files = licence_files(&folder);
        if files.is_empty() {
            let authors = package["authors"].as_array().map(Vec::as_slice).unwrap_or_default();
            let authors: Vec<_> = authors.iter().filter_map(Value::as_str).collect();
            without.push(format!("{name}: {} {}", authors.join(", "), text("repository")));
        }
        for file in files {
            let bytes = fs::read(&file).map_err(|error| format!("{}: {error}", file.display()))?;
            texts.entry(String::from_utf8_lossy(&bytes).trim().to_owned()).or_default().push(name.clone());
        }
    }
    let mut document = String::from("Licences of the software in ancf that other authors have written.\n");
    for (text, names) in &texts {
        // Writing to a string cannot fail.
        let _ = write!(document, "\n{}\n{}\n\n{text}\n", "=".repeat(100), names.join("\n"));
    }
    let _ =
        write!(document, "\n{}\nCrates without a licence file:\n\n{}\n", "=".repeat(100), without.join("\n"));
    for other in OTHERS {
        let text = fs::read_to_string(source.join(other)).map_err(|error| format!("{other}: {error}"))?;
        let _ = write!(document, "\n{}\n{}\n", "=".repeat(100), text.trim());
    }
    Ok(document)
}

fn metadata(source: &Path, target: &str) -> Result<Value, String> {
    let arguments = ["metadata", "--locked", "--format-version", "1", "--filter-platform", target];
    let output = Command::new(env!("CARGO")).args(arguments).current_dir(source).output();
    let output = output.map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

/// Packages of others that are linked into the programs.
fn linked(metadata: &Value) -> Result<Vec<&Value>, String> {
    let list = |value: &'static str| metadata[value].as_array().ok_or("cargo metadata: unknown form");
    let packages: BTreeMap<&str, &Value> =
        list("packages")?.iter().filter_map(|package| Some((package["id"].as_str()?, package))).collect();
    let nodes = metadata["resolve"]["nodes"].as_array().ok_or("cargo metadata: no dependencies")?;
    let nodes: BTreeMap<&str, &Value> =
        nodes.iter().filter_map(|node| Some((node["id"].as_str()?, node))).collect();
    let is_program = |id: &&str| packages[*id]["name"].as_str().is_some_and(|name| PROGRAMS.contains(&name));
    let mut pending: Vec<&str> = packages.keys().copied().filter(is_program).collect();
    let mut seen = BTreeSet::new();
    while let Some(id) = pending.pop() {
        if !seen.insert(id) {
            continue;
        }
        let dependencies = nodes.get(id).and_then(|node| node["deps"].as_array());
        for dependency in dependencies.into_iter().flatten() {
            let kinds = dependency["dep_kinds"].as_array();
            if kinds.is_none_or(|kinds| kinds.iter().any(|kind| kind["kind"].is_null())) {
                pending.extend(dependency["pkg"].as_str());
            }
        }
    }
    // Crates of the workspace have no source.
    Ok(seen.into_iter().map(|id| packages[id]).filter(|package| !package["source"].is_null()).collect())
}

fn licence_files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let is_licence = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_uppercase();
        path.is_file() && NAMES.iter().any(|start| name.starts_with(start))
    };
    let mut files: Vec<_> = entries.map(|entry| entry.path()).filter(is_licence).collect();
    files.sort();
    files
}
