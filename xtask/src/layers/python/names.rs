//! Resolution of Python names.

use std::collections::BTreeMap;

use super::module::Module;
use crate::layers::workspace::import::FileId;

/// Meaning of a name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Meaning {
    /// Defined in a file, or a module that is one.
    File(FileId),
    /// A package, by its name.
    Package(String),
}

/// Modules by absolute name.
pub(super) type Modules = BTreeMap<String, (FileId, Module)>;

/// Resolves a name of a module. Names that a package imports are followed to the module that defines them.
pub(super) fn resolve(modules: &Modules, module: &str, name: &str, depth: usize) -> Option<Meaning> {
    let (file, own) = modules.get(module)?;
    if !own.is_package {
        return Some(Meaning::File(*file));
    }
    // Packages that import from each other may form a ring.
    let below =
        |module: &str, name: &str| (depth < 20).then(|| resolve(modules, module, name, depth + 1)).flatten();
    let bound = own.bindings.iter().rev().find(|binding| binding.alias == name);
    if let Some(binding) = bound {
        return match &binding.name {
            Some(name) => below(&binding.module, name),
            None => self::module(modules, &binding.module),
        };
    }
    if let Some(found) = self::module(modules, &format!("{module}.{name}")) {
        return Some(found);
    }
    let mut stars = own.bindings.iter().filter(|binding| binding.alias.is_empty());
    let by_star = stars.find_map(|star| {
        let (_, from) = modules.get(&star.module)?;
        let has = from.bindings.iter().any(|binding| binding.alias == name) || defines(from, name);
        has.then(|| below(&star.module, name)).flatten()
    });
    Some(by_star.unwrap_or(Meaning::File(*file)))
}

/// Resolves the name of a module.
pub(super) fn module(modules: &Modules, name: &str) -> Option<Meaning> {
    let (file, own) = modules.get(name)?;
    Some(if own.is_package { Meaning::Package(name.to_owned()) } else { Meaning::File(*file) })
}

/// True if a module defines a name at its top level.
fn defines(module: &Module, name: &str) -> bool {
    module.others.iter().any(|statement| {
        let text = ["def ", "class ", "async def ", "type "]
            .iter()
            .find_map(|head| statement.text.strip_prefix(head))
            .unwrap_or(&statement.text);
        let rest = text.strip_prefix(name);
        rest.is_some_and(|rest| rest.starts_with([' ', '(', ':', '=', '[']))
    })
}

/// Returns the dotted names after a name in code: `b.c` for each `a.b.c` after `a`.
pub(super) fn attributes<'a>(code: &'a str, name: &'a str) -> impl Iterator<Item = &'a str> {
    let is_word = |sign: char| sign.is_alphanumeric() || sign == '_';
    code.match_indices(name).filter_map(move |(at, _)| {
        let is_whole = !code[..at].ends_with(|sign: char| is_word(sign) || sign == '.');
        let rest = code[at + name.len()..].strip_prefix('.').filter(|_| is_whole)?;
        let end = rest.find(|sign: char| !is_word(sign) && sign != '.').unwrap_or(rest.len());
        Some(rest[..end].trim_end_matches('.'))
    })
}

/// True if code contains a name as a word.
pub(super) fn uses(code: &str, name: &str) -> bool {
    let is_word = |sign: char| sign.is_alphanumeric() || sign == '_';
    code.match_indices(name)
        .any(|(at, _)| !code[..at].ends_with(is_word) && !code[at + name.len()..].starts_with(is_word))
}
