//! The command `cargo xtask layers`.

use std::path::{Path, PathBuf};

use super::workspace::config::{Config, Language};
use super::workspace::import::Import;
use super::workspace::source::{self, SourceFile};
use super::workspace::violation::Violation;
use super::{members, python, rules, rust, typescript};
use crate::system::shell::{Done, root, say};

/// Checks the module structure. Options: `--tree PATH` reports on one tree only, `--root DIR` checks another checkout.
pub(crate) fn check(options: &[String]) -> Done {
    let (mut root, mut only) = (root(), None);
    let mut options = options.iter();
    while let Some(option) = options.next() {
        let value = options.next().ok_or_else(|| format!("`{option}` needs a value"));
        match option.as_str() {
            "--root" => root = PathBuf::from(value?),
            "--tree" => only = Some(value?.trim_end_matches('/')),
            _ => return Err(format!("unknown option `{option}`, expected --root DIR or --tree PATH")),
        }
    }
    let config = Config::read(&root)?;
    let chosen =
        |tree: usize| only.is_none_or(|only| config.trees.get(tree).is_some_and(|tree| tree.path == only));
    if let Some(only) = only.filter(|_| !(0..config.trees.len()).any(chosen)) {
        return Err(format!("layers.toml has no tree `{only}`"));
    }
    let mut files = source::read(&root, &config.trees)?;
    let (imports, mut violations) = imports(&root, &config, &mut files)?;
    violations.extend(members::missing(&root, &config)?);
    violations.extend(rules::folders(&config, &files));
    violations.extend(rules::lengths(&root, &config, &files)?);
    violations.extend(rules::upward_imports(&config, &files, &imports));
    violations.extend(rules::cycles(&files, &imports));
    violations.retain(|violation| chosen(violation.tree));
    if violations.is_empty() {
        (0..config.trees.len())
            .filter(|&tree| chosen(tree))
            .for_each(|tree| summary(&config, tree, &files, &imports));
        return Ok(());
    }
    violations.iter().for_each(|violation| say(&violation.text));
    Err(format!("layers: {}", counted(violations.len(), "violation")))
}

/// Writes a number with its noun.
fn counted(number: usize, noun: &str) -> String {
    if number == 1 { format!("1 {noun}") } else { format!("{number} {noun}s") }
}

/// Collects the imports of all trees.
fn imports(
    root: &Path,
    config: &Config,
    files: &mut [SourceFile],
) -> Result<(Vec<Import>, Vec<Violation>), String> {
    let (mut imports, violations) = rust::imports(root, &config.trees, files)?;
    for (tree, rule) in config.trees.iter().enumerate() {
        match rule.language {
            Language::Rust => {}
            Language::Python => imports.extend(python::imports(tree, rule, files)),
            Language::Typescript => imports.extend(typescript::imports(tree, files)),
        }
    }
    imports.retain(|import| import.from != import.to);
    imports.sort();
    imports.dedup_by(|b, a| a.from == b.from && a.to == b.to && a.name == b.name);
    Ok((imports, violations))
}

/// Prints the numbers of a tree without violations.
fn summary(config: &Config, tree: usize, files: &[SourceFile], imports: &[Import]) {
    let rule = &config.trees[tree];
    let own = files.iter().filter(|file| file.tree == tree).count();
    let mut arrows: Vec<_> = imports
        .iter()
        .filter(|import| files[import.from].tree == tree && files[import.to].tree == tree)
        .map(|import| (import.from, import.to))
        .collect();
    arrows.dedup();
    say(&format!(
        "{}: {}, {}, {} between files",
        rule.path,
        counted(rule.layers.len(), "layer"),
        counted(own, "file"),
        counted(arrows.len(), "import")
    ));
}
