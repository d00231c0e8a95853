//! Rules of `layers.toml`, applied to files and imports.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::config::{Config, FILE, Language, Limits};
use super::cycles;
use super::import::{FileId, Import};
use super::source::{self, SourceFile};
use super::violation::Violation;

/// Applies the rules on folders: each is listed once, none is empty, none has too many files.
pub(super) fn folders(config: &Config, files: &[SourceFile]) -> Vec<Violation> {
    let limit = config.limits.files;
    let mut found = Vec::new();
    for (tree, rule) in config.trees.iter().enumerate() {
        let mut report = |text| found.push(Violation::new(tree, text));
        let mut present: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
        for file in files.iter().filter(|file| file.tree == tree) {
            let (all, counted) = present.entry(&file.folder).or_default();
            *all += 1;
            *counted += usize::from(!file.is_facade && !is_generated(&config.limits, &file.path));
        }
        for (folder, (_, counted)) in &present {
            let place = if *folder == "." { rule.path.clone() } else { format!("{}/{folder}", rule.path) };
            if !rule.layers.iter().any(|layer| layer == folder) {
                report(format!(
                    "{place}: folder is not in {FILE}; add \"{folder}\" to `layers` of this tree, above all \
                     folders that it imports from"
                ));
            }
            if *counted > limit {
                report(format!("{place}: {counted} files, at most {limit} are allowed; split the folder"));
            }
        }
        let mut seen = BTreeSet::new();
        for layer in &rule.layers {
            if !seen.insert(layer) {
                report(format!("{FILE}: layer \"{layer}\" of {} is listed twice; remove one", rule.path));
            } else if !present.contains_key(layer.as_str()) {
                report(format!("{FILE}: layer \"{layer}\" of {} has no files; remove it", rule.path));
            }
        }
    }
    found
}

/// Applies the limit on lines to the files of the trees and of the other folders in `limits.also`.
pub(super) fn lengths(root: &Path, config: &Config, files: &[SourceFile]) -> Result<Vec<Violation>, String> {
    let limit = config.limits.lines;
    let mut found = Vec::new();
    let mut measure = |tree: usize, path: &str, lines: usize| {
        if lines > limit && !is_generated(&config.limits, path) {
            let text = format!("{path}:{lines}: {lines} lines, at most {limit} are allowed; split the file");
            found.push(Violation::new(tree, text));
        }
    };
    for file in files {
        measure(file.tree, &file.path, file.lines());
    }
    for folder in &config.limits.also {
        let mut inner = Vec::new();
        source::collect(&root.join(folder), "", &mut |path| inner.push(path))?;
        inner.sort();
        for inner in inner.iter().filter(|inner| Language::of(Path::new(inner)).is_some()) {
            let path = format!("{folder}/{inner}");
            let text = fs::read_to_string(root.join(&path)).map_err(|error| format!("{path}: {error}"))?;
            measure(usize::MAX, &path, text.lines().count());
        }
    }
    Ok(found)
}

/// True for a file that `limits.generated` names, itself or by its folder.
fn is_generated(limits: &Limits, path: &str) -> bool {
    let covers = |generated: &String| {
        path.strip_prefix(generated.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    };
    limits.generated.iter().any(covers)
}

/// Finds imports from a layer above.
pub(super) fn upward_imports(config: &Config, files: &[SourceFile], imports: &[Import]) -> Vec<Violation> {
    let mut found = Vec::new();
    for import in imports {
        let (from, to) = (&files[import.from], &files[import.to]);
        if from.tree != to.tree {
            continue;
        }
        let rule = &config.trees[from.tree];
        let level = |file: &SourceFile| rule.layers.iter().position(|layer| *layer == file.folder);
        let (Some(above), Some(below)) = (level(to), level(from)) else { continue };
        if above < below {
            let text = format!(
                "{}:{}: imports `{}` of {}, upwards from layer \"{}\" to \"{}\"; move the name into \"{}\" or \
                 below, or move the importing code up",
                from.path, import.line, import.name, to.inner, from.folder, to.folder, from.folder
            );
            found.push(Violation::new(from.tree, text));
        }
    }
    found
}

/// Finds cycles of files.
pub(super) fn cycles(files: &[SourceFile], imports: &[Import]) -> Vec<Violation> {
    let mut successors = vec![Vec::new(); files.len()];
    for import in imports {
        successors[import.from].push(import.to);
    }
    cycles::components(&successors)
        .into_iter()
        .map(|component| Violation::new(files[component[0]].tree, cycle(files, imports, &component)))
        .collect()
}

/// Describes a cycle by its imports.
fn cycle(files: &[SourceFile], imports: &[Import], component: &[FileId]) -> String {
    let mut ties: BTreeMap<(FileId, FileId), (usize, BTreeSet<&str>)> = BTreeMap::new();
    for import in imports.iter().filter(|import| {
        component.binary_search(&import.from).is_ok() && component.binary_search(&import.to).is_ok()
    }) {
        let tie = ties.entry((import.from, import.to)).or_insert((import.line, BTreeSet::new()));
        tie.0 = tie.0.min(import.line);
        tie.1.insert(&import.name);
    }
    let mut text = format!(
        "{}: cycle of {} files; move the names that tie them into a file of their own:",
        files[component[0]].path,
        component.len()
    );
    for ((from, to), (line, names)) in ties {
        let names: Vec<_> = names.into_iter().collect();
        text += &format!("\n    {}:{line} -> {}: {}", files[from].path, files[to].inner, names.join(", "));
    }
    text
}
