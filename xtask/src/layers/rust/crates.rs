//! Crates of the Rust trees: names, root files, dependencies.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::layers::workspace::source::SourceFile;

/// A crate: a library or one binary. A package with both has two entries.
#[derive(Debug)]
pub(super) struct Crate {
    /// Name in paths.
    pub(super) name: String,
    pub(super) is_library: bool,
    /// Tree of its source files, by index.
    pub(super) tree: usize,
    /// Root file, relative to the tree.
    pub(super) root: String,
    /// Names of the packages it depends on, in the form used in paths.
    pub(super) dependencies: BTreeSet<String>,
}

/// Finds the crates of a tree by the manifest beside its folder; without a manifest, by the names of root files.
pub(super) fn of_tree(
    root: &Path,
    tree: usize,
    path: &str,
    files: &[SourceFile],
) -> Result<Vec<Crate>, String> {
    let (package, source) = path.rsplit_once('/').unwrap_or((".", path));
    let manifest = root.join(package).join("Cargo.toml");
    let manifest: toml::Table = if manifest.exists() {
        let wrong = |error: &dyn std::fmt::Display| format!("{}: {error}", manifest.display());
        let text = fs::read_to_string(&manifest).map_err(|error| wrong(&error))?;
        toml::from_str(&text).map_err(|error| wrong(&error))?
    } else {
        toml::Table::new()
    };
    let text = |keys: &[&str]| string(&manifest, keys);
    let package_name = text(&["package", "name"]).unwrap_or_else(|| last(package).to_owned());
    let dependencies = dependencies(&manifest);
    let inner = |path: String| path.strip_prefix(&format!("{source}/")).map(str::to_owned);
    let library_root = text(&["lib", "path"]).and_then(inner).unwrap_or_else(|| "lib.rs".into());
    let mut roots =
        vec![(text(&["lib", "name"]).unwrap_or_else(|| package_name.clone()), library_root, true)];
    roots.push((package_name.clone(), "main.rs".into(), false));
    let binaries = manifest.get("bin").and_then(toml::Value::as_array).into_iter().flatten();
    for binary in binaries.filter_map(toml::Value::as_table) {
        roots.extend(
            string(binary, &["path"]).and_then(inner).map(|root| (package_name.clone(), root, false)),
        );
    }
    for file in files.iter().filter(|file| file.tree == tree && file.folder == "bin") {
        roots.push((package_name.clone(), file.inner.clone(), false));
    }
    let mut seen = BTreeSet::new();
    roots.retain(|(_, root, _)| {
        files.iter().any(|file| file.tree == tree && file.inner == *root) && seen.insert(root.clone())
    });
    let library = roots.iter().find(|root| root.2).map(|root| in_path(&root.0));
    Ok(roots
        .into_iter()
        .map(|(name, root, is_library)| {
            let mut dependencies = dependencies.clone();
            dependencies.extend(library.clone().filter(|_| !is_library));
            Crate { name: in_path(&name), is_library, tree, root, dependencies }
        })
        .collect())
}

fn last(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

fn in_path(name: &str) -> String {
    name.replace('-', "_")
}

fn string(table: &toml::Table, keys: &[&str]) -> Option<String> {
    let (last, tables) = keys.split_last()?;
    let table = tables.iter().try_fold(table, |table, key| table.get(*key)?.as_table())?;
    table.get(*last)?.as_str().map(str::to_owned)
}

fn dependencies(manifest: &toml::Table) -> BTreeSet<String> {
    let table = manifest.get("dependencies").and_then(toml::Value::as_table);
    table.into_iter().flat_map(toml::Table::keys).map(|name| in_path(name)).collect()
}

/// Returns for each crate the crates whose items it can use: itself and its dependencies, by index.
pub(super) fn reach(crates: &[Crate]) -> Vec<BTreeSet<usize>> {
    let library = |name: &String| crates.iter().position(|own| own.is_library && own.name == *name);
    (0..crates.len())
        .map(|own| {
            let mut reached = BTreeSet::from([own]);
            let mut open = vec![own];
            while let Some(next) = open.pop() {
                let used = crates[next].dependencies.iter().filter_map(library);
                open.extend(used.filter(|used| reached.insert(*used)));
            }
            reached
        })
        .collect()
}
