//! Imports of all Rust trees.

use std::collections::BTreeMap;
use std::path::Path;

use syn::Item;

use super::importer::Tables;
use super::methods::Methods;
use super::modules::Modules;
use super::resolve::Resolver;
use super::{attributes, crates, visit};
use crate::layers::workspace::config::{Language, TreeConfig};
use crate::layers::workspace::import::{FileId, Import};
use crate::layers::workspace::source::SourceFile;
use crate::layers::workspace::violation::Violation;

/// Collects the imports of the Rust trees, marks files that only declare and re-export, and reports files outside
/// the modules of their crate.
pub(in crate::layers) fn imports(
    root: &Path,
    trees: &[TreeConfig],
    files: &mut [SourceFile],
) -> Result<(Vec<Import>, Vec<Violation>), String> {
    let mut all = Vec::new();
    for (tree, rule) in trees.iter().enumerate().filter(|(_, rule)| rule.language == Language::Rust) {
        all.extend(crates::of_tree(root, tree, &rule.path, files)?);
    }
    let modules = Modules::read(&all, files);
    let resolver = Resolver::new(&all, &modules);
    let methods = Methods::read(&all, &modules, &resolver);
    let tables = Tables { modules: &modules, resolver: &resolver, methods: &methods };
    let imports = (0..modules.all.len()).flat_map(|module| visit::imports(tables, module)).collect();
    for (file, is_facade) in facades(&modules) {
        files[file].is_facade = is_facade;
    }
    Ok((imports, broken(trees, &modules, files)))
}

/// Finds out for each file whether it only declares modules and re-exports names.
fn facades(modules: &Modules) -> BTreeMap<FileId, bool> {
    let mut found = BTreeMap::new();
    for module in &modules.all {
        let declares = |item: &Item| {
            matches!(item, Item::Mod(_) | Item::Use(_) | Item::ExternCrate(_))
                || attributes::is_test(attributes::of_item(item))
        };
        let own = module.syntax.iter().all(declares);
        let is_inline = found.contains_key(&module.file);
        *found.entry(module.file).or_insert(true) &= own && (module.is_folder || is_inline);
    }
    found
}

/// Reports files that cannot be read as modules of a crate.
fn broken(trees: &[TreeConfig], modules: &Modules, files: &[SourceFile]) -> Vec<Violation> {
    let is_lost = |(id, file): &(FileId, &SourceFile)| {
        trees[file.tree].language == Language::Rust && !modules.reached.contains(id)
    };
    let lost = files.iter().enumerate().filter(is_lost).map(|(_, file)| {
        let text =
            format!("{}: belongs to no module of its crate; declare it by `mod` or delete it", file.path);
        Violation::new(file.tree, text)
    });
    let broken = modules.broken.iter().map(|(file, why)| {
        let file = &files[*file];
        Violation::new(file.tree, format!("{}: {why}", file.path))
    });
    lost.chain(broken).collect()
}
