//! Imports of a module, entered path by path.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;

use super::methods::{Methods, TypeId};
use super::modules::{ModuleId, Modules};
use super::resolve::{Resolver, Target};
use super::tokens;
use super::uses::Use;
use crate::layers::workspace::import::{FileId, Import};

/// Crate-wide tables.
#[derive(Clone, Copy)]
pub(super) struct Tables<'a> {
    pub(super) modules: &'a Modules,
    pub(super) resolver: &'a Resolver<'a>,
    pub(super) methods: &'a Methods,
}

/// Enters the imports of a module.
pub(super) struct Importer<'a> {
    pub(super) tables: Tables<'a>,
    pub(super) module: ModuleId,
    /// `use` declarations of the blocks around, from outer to inner.
    pub(super) scope: Vec<Use>,
    /// Variables of the function.
    pub(super) locals: BTreeSet<String>,
    /// Type of the `impl` block.
    pub(super) own_type: Option<TypeId>,
    pub(super) found: Vec<Import>,
}

impl<'a> Importer<'a> {
    pub(super) fn new(tables: Tables<'a>, module: ModuleId) -> Self {
        Self { tables, module, scope: Vec::new(), locals: BTreeSet::new(), own_type: None, found: Vec::new() }
    }

    fn add(&mut self, to: FileId, line: usize, name: String) {
        let from = self.tables.modules.all[self.module].file;
        if from != to {
            self.found.push(Import { from, to, name, line });
        }
    }

    /// Enters the import of a `use` declaration.
    pub(super) fn import(&mut self, import: &Use) {
        let targets = self.tables.resolver.resolve(self.module, &self.scope, &import.path);
        self.enter(targets, &import.path, import.line);
    }

    /// Enters the import of a path.
    pub(super) fn path(&mut self, path: &[String], line: usize) {
        if path[0] == "Self" {
            if let (Some(own), Some(name)) = (self.own_type.clone(), path.get(1)) {
                self.associated(&own, name, line);
            }
            return;
        }
        if path.len() == 1 && self.locals.contains(&path[0]) {
            return;
        }
        let targets = self.tables.resolver.resolve(self.module, &self.scope, path);
        self.enter(targets, path, line);
    }

    pub(super) fn enter(&mut self, targets: Vec<Target>, path: &[String], line: usize) {
        for target in targets {
            if let Target::Item(module, name, more) = target {
                self.add(self.tables.modules.all[module].file, line, name.clone());
                if more > 0 {
                    self.associated(&(module, name), &path[path.len() - more], line);
                }
            }
        }
    }

    /// Enters the import of an associated function or constant.
    pub(super) fn associated(&mut self, own: &TypeId, name: &str, line: usize) {
        let files: Vec<_> = self.tables.methods.of_type(own, name).collect();
        files.into_iter().for_each(|file| self.add(file, line, format!("{}::{name}", own.1)));
    }

    /// Enters the import of a method call whose receiver is unknown.
    pub(super) fn call(&mut self, name: &str, arguments: Option<usize>, line: usize) {
        let of = self.tables.modules.all[self.module].of;
        if let Some(method) = self.tables.methods.of_call(of, name, arguments) {
            self.add(method.file, line, method.name.clone());
        }
    }

    /// Enters the imports of tokens that are not parsed.
    pub(super) fn tokens(&mut self, tokens: &TokenStream) {
        for path in tokens::paths(tokens) {
            let first = &path.segments[0];
            if path.is_member {
                if path.is_call {
                    self.call(first, None, path.line);
                }
            } else if path.segments.len() > 1 || path.is_call || first.starts_with(char::is_uppercase) {
                self.path(&path.segments, path.line);
            }
        }
    }
}
