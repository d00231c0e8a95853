//! Imports of a Python package.

use super::module::{Binding, Module};
use super::names::{self, Meaning, Modules};
use crate::layers::workspace::config::TreeConfig;
use crate::layers::workspace::import::{FileId, Import};
use crate::layers::workspace::source::SourceFile;

/// Collects the imports of a package and marks the `__init__.py` that only re-export. Imports inside functions and
/// under `TYPE_CHECKING` count like others.
pub(in crate::layers) fn imports(tree: usize, rule: &TreeConfig, files: &mut [SourceFile]) -> Vec<Import> {
    let package = rule.path.rsplit('/').next().unwrap_or(&rule.path);
    let mut modules = Modules::new();
    for (id, file) in files.iter_mut().enumerate().filter(|(_, file)| file.tree == tree) {
        let inner = file.inner.trim_end_matches(".py");
        let is_package = inner == "__init__" || inner.ends_with("/__init__");
        let inner = inner.strip_suffix("__init__").unwrap_or(inner).trim_end_matches('/');
        let name = if inner.is_empty() {
            package.to_owned()
        } else {
            format!("{package}.{}", inner.replace('/', "."))
        };
        let module = Module::parse(name.clone(), is_package, &file.text);
        file.is_facade = module.is_facade();
        modules.insert(name, (id, module));
    }
    let mut found = Vec::new();
    for (file, module) in modules.values() {
        let code: Vec<&str> = module.others.iter().map(|statement| statement.text.as_str()).collect();
        let code = code.join("\n");
        for binding in &module.bindings {
            // A package re-exports what it imports; only its own use of a name is an import.
            if !module.is_package || names::uses(&code, &binding.alias) && !binding.alias.is_empty() {
                follow(&modules, *file, binding, &code, &mut found);
            }
        }
    }
    found
}

/// Enters the imports of a binding: the file of the name, or the files of the attributes used of a package.
fn follow(modules: &Modules, from: FileId, binding: &Binding, code: &str, found: &mut Vec<Import>) {
    let mut add = |to: FileId, name: &str| {
        found.push(Import { from, to, name: name.to_owned(), line: binding.line });
    };
    let meaning = match &binding.name {
        Some(name) if name == "*" => names::module(modules, &binding.module),
        Some(name) => names::resolve(modules, &binding.module, name, 0),
        None => names::module(modules, &binding.module),
    };
    let name = binding.name.as_deref().unwrap_or(&binding.module);
    match meaning {
        Some(Meaning::File(to)) => add(to, name),
        Some(Meaning::Package(_)) | None => {}
    }
    // `import a.b` binds `a`.
    let base = match &meaning {
        Some(Meaning::Package(package)) if binding.name.is_some() || *package == binding.alias => {
            package.clone()
        }
        _ if binding.name.is_none() => binding.alias.clone(),
        _ => return,
    };
    let is_alias = binding.name.is_none() && !binding.module.starts_with(&binding.alias);
    let base = if is_alias { binding.module.clone() } else { base };
    for path in names::attributes(code, &binding.alias) {
        if let Some((to, name)) = attribute(modules, &base, path) {
            add(to, name);
        }
    }
}

/// Resolves a dotted path in a package.
fn attribute<'a>(modules: &Modules, package: &str, path: &'a str) -> Option<(FileId, &'a str)> {
    let mut package = package.to_owned();
    for name in path.split('.') {
        match names::resolve(modules, &package, name, 0)? {
            Meaning::File(file) => return Some((file, name)),
            Meaning::Package(next) => package = next,
        }
    }
    None
}
