//! Resolution of paths through re-exports to the modules that define the names.

use std::collections::BTreeMap;

use super::crates::Crate;
use super::modules::{ModuleId, Modules};
use super::uses::Use;

/// Meaning of a path.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Target {
    Module(ModuleId),
    /// An item by the module that defines it and its name, and the number of path segments after it.
    Item(ModuleId, String, usize),
}

/// Resolves paths in the modules of all crates.
pub(super) struct Resolver<'a> {
    crates: &'a [Crate],
    modules: &'a Modules,
    /// Root modules of libraries by crate name.
    libraries: BTreeMap<&'a str, ModuleId>,
}

/// A `use` declaration that is being followed: module and index. It is not followed again, which ends cyclic globs.
type Step = (ModuleId, usize);

impl<'a> Resolver<'a> {
    pub(super) fn new(crates: &'a [Crate], modules: &'a Modules) -> Self {
        let of = crates.iter().zip(&modules.roots).filter(|(own, _)| own.is_library);
        Self { crates, modules, libraries: of.map(|(own, root)| (own.name.as_str(), *root)).collect() }
    }

    /// Resolves a path in a module, within functions whose own `use` declarations are given from outer to inner.
    pub(super) fn resolve(&self, module: ModuleId, scope: &[Use], path: &[String]) -> Vec<Target> {
        let Some(first) = path.first() else { return Vec::new() };
        for (at, local) in scope.iter().enumerate().rev() {
            let outer = &scope[..at];
            let found = match &local.name {
                Some(name) if name == first => {
                    self.follow(self.resolve(module, outer, &local.path), &path[1..], &mut Vec::new())
                }
                Some(_) => continue,
                None => {
                    let globs = self.resolve(module, outer, &local.path);
                    let globs = globs.into_iter().filter(|target| matches!(target, Target::Module(_)));
                    self.follow(globs.collect(), path, &mut Vec::new())
                }
            };
            if !found.is_empty() {
                return found;
            }
        }
        self.path(module, path, &mut Vec::new())
    }

    /// Resolves a path by the names of a module.
    fn path(&self, module: ModuleId, path: &[String], steps: &mut Vec<Step>) -> Vec<Target> {
        let Some((first, rest)) = path.split_first() else { return Vec::new() };
        let all = &self.modules.all;
        let start = match first.as_str() {
            "" => {
                return rest
                    .split_first()
                    .map_or_else(Vec::new, |(name, rest)| self.external(module, name, rest));
            }
            "crate" | "$crate" => Some(self.modules.roots[all[module].of]),
            "self" => Some(module),
            "super" => all[module].parent,
            _ => {
                let found = self.name(module, first, steps);
                if found.is_empty() {
                    return self.external(module, first, rest);
                }
                return self.follow(found, rest, steps);
            }
        };
        start.map_or_else(Vec::new, |start| self.follow(vec![Target::Module(start)], rest, steps))
    }

    /// Resolves a path that begins with the name of another crate.
    fn external(&self, module: ModuleId, name: &str, rest: &[String]) -> Vec<Target> {
        let own = &self.crates[self.modules.all[module].of];
        match self.libraries.get(name) {
            Some(root) if own.dependencies.contains(name) => {
                self.follow(vec![Target::Module(*root)], rest, &mut Vec::new())
            }
            _ => Vec::new(),
        }
    }

    /// Follows the rest of a path. Modules come before items of the same name if segments remain.
    fn follow(&self, from: Vec<Target>, rest: &[String], steps: &mut Vec<Step>) -> Vec<Target> {
        let Some((name, after)) = rest.split_first() else { return from };
        let mut found = Vec::new();
        for target in &from {
            if let Target::Module(module) = target {
                let next = match name.as_str() {
                    "self" => vec![target.clone()],
                    "super" => self.modules.all[*module].parent.into_iter().map(Target::Module).collect(),
                    _ => self.name(*module, name, steps),
                };
                found.extend(self.follow(next, after, steps));
            }
        }
        if found.is_empty() {
            found = from
                .into_iter()
                .filter_map(|target| match target {
                    Target::Item(module, item, more) => Some(Target::Item(module, item, more + rest.len())),
                    Target::Module(_) => None,
                })
                .collect();
        }
        found
    }

    /// Resolves a name in a module: its own items and modules, its imports, then its globs.
    fn name(&self, module: ModuleId, name: &str, steps: &mut Vec<Step>) -> Vec<Target> {
        let own = &self.modules.all[module];
        let mut found: Vec<Target> =
            own.children.get(name).map(|&child| Target::Module(child)).into_iter().collect();
        if own.items.contains(name) {
            found.push(Target::Item(module, name.to_owned(), 0));
        }
        for (at, declared) in own.uses.iter().enumerate() {
            if declared.name.as_deref() == Some(name) && !steps.contains(&(module, at)) {
                steps.push((module, at));
                found.extend(self.path(module, &declared.path, steps));
                steps.pop();
            }
        }
        if found.is_empty() {
            for (at, declared) in own.uses.iter().enumerate() {
                if declared.name.is_none() && !steps.contains(&(module, at)) {
                    steps.push((module, at));
                    let globs = self.path(module, &declared.path, steps);
                    let globs =
                        globs.into_iter().filter(|target| matches!(target, Target::Module(_))).collect();
                    found.extend(self.follow(globs, &[name.to_owned()], steps));
                    steps.pop();
                }
            }
        }
        found.sort();
        found.dedup();
        found
    }

    /// Returns the definition of a macro in scope: by path, or by its text order in an enclosing module.
    pub(super) fn macro_definition(&self, module: ModuleId, scope: &[Use], path: &[String]) -> Vec<Target> {
        let found = self.resolve(module, scope, path);
        if !found.is_empty() || path.len() > 1 {
            return found;
        }
        let mut above = Some(module);
        while let Some(at) = above {
            if self.modules.all[at].items.contains(&path[0]) {
                return vec![Target::Item(at, path[0].clone(), 0)];
            }
            above = self.modules.all[at].parent;
        }
        Vec::new()
    }
}
