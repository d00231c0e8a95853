//! Rules of `layers.toml`, applied to files and imports.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use super::cycles;
use super::workspace::config::{Config, FILE, Language, Limits};
use super::workspace::import::{FileId, Import};
use super::workspace::source::{self, SourceFile};
use super::workspace::violation::Violation;

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

/// Imported names of a pair of files, and the first line on which one is imported.
type Ties<'a> = BTreeMap<(FileId, FileId), (usize, BTreeSet<&'a str>)>;

/// Collects the imports between pairs of files.
fn ties<'a>(imports: impl Iterator<Item = &'a Import>) -> Ties<'a> {
    let mut ties = Ties::new();
    for import in imports {
        let (line, names) = ties.entry((import.from, import.to)).or_insert((import.line, BTreeSet::new()));
        *line = import.line.min(*line);
        names.insert(&import.name);
    }
    ties
}

/// Joins names for a message.
fn listed(names: &BTreeSet<&str>) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Finds imports from a layer above.
pub(super) fn upward_imports(config: &Config, files: &[SourceFile], imports: &[Import]) -> Vec<Violation> {
    let points_up = |import: &&Import| {
        let (from, to) = (&files[import.from], &files[import.to]);
        let layers = &config.trees[from.tree].layers;
        let level = |file: &SourceFile| layers.iter().position(|layer| *layer == file.folder);
        from.tree == to.tree && level(to).is_some_and(|to| level(from).is_some_and(|from| to < from))
    };
    let describe = |((from, to), (line, names)): ((FileId, FileId), (usize, BTreeSet<&str>))| {
        let (from, to) = (&files[from], &files[to]);
        let text = format!(
            "{}:{line}: imports {} of {}, upwards from layer \"{}\" to \"{}\"; move the names down or the \
             importing code up",
            from.path,
            listed(&names),
            to.inner,
            from.folder,
            to.folder
        );
        Violation::new(from.tree, text)
    };
    ties(imports.iter().filter(points_up)).into_iter().map(describe).collect()
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
    let is_inside = |file: FileId| component.binary_search(&file).is_ok();
    let inside = imports.iter().filter(|import| is_inside(import.from) && is_inside(import.to));
    let mut text = format!(
        "{}: cycle of {} files; move the names that connect them into a file of their own:",
        files[component[0]].path,
        component.len()
    );
    for ((from, to), (line, names)) in ties(inside) {
        text += &format!("\n    {}:{line} -> {}: {}", files[from].path, files[to].inner, listed(&names));
    }
    text
}
