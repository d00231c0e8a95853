//! Inherent methods and associated constants, by type and by name.

use std::collections::{BTreeMap, BTreeSet};

use syn::{FnArg, ImplItem, Item, TraitItem, Type};

use super::attributes;
use super::crates::{self, Crate};
use super::modules::{ModuleId, Modules};
use super::resolve::{Resolver, Target};
use crate::layers::workspace::import::FileId;

/// A type by the module that defines it and its name.
pub(super) type TypeId = (ModuleId, String);

/// Methods of the standard library's containers and strings. Their receivers are mostly values of other types.
const STANDARD: [&str; 20] = [
    "clear", "clone", "contains", "extend", "first", "get", "get_mut", "insert", "is_empty", "iter",
    "iter_mut", "last", "len", "map", "next", "pop", "push", "remove", "sum", "take",
];

/// A method of an inherent `impl` block.
#[derive(Debug)]
pub(super) struct Method {
    /// Crate, by index.
    of: usize,
    /// File of the `impl` block.
    pub(super) file: FileId,
    /// File of the type's definition.
    type_file: FileId,
    /// Type and method, for messages.
    pub(super) name: String,
    /// Number of arguments besides `self`.
    arguments: usize,
}

/// All inherent methods, and the names of trait methods.
#[derive(Debug)]
pub(super) struct Methods {
    /// Files that define an associated function or constant, by type and name.
    by_type: BTreeMap<TypeId, BTreeMap<String, BTreeSet<FileId>>>,
    by_name: BTreeMap<String, Vec<Method>>,
    /// Crates that define a trait method of a name.
    in_traits: BTreeMap<String, BTreeSet<usize>>,
    /// Crates whose methods a crate can call, by index.
    reach: Vec<BTreeSet<usize>>,
}

impl Methods {
    pub(super) fn read(crates: &[Crate], modules: &Modules, resolver: &Resolver) -> Self {
        let reach = crates::reach(crates);
        let mut methods =
            Self { by_type: BTreeMap::new(), by_name: BTreeMap::new(), in_traits: BTreeMap::new(), reach };
        for (id, module) in modules.all.iter().enumerate() {
            for item in &module.syntax {
                if attributes::is_test(attributes::of_item(item)) {
                    continue;
                }
                match item {
                    Item::Trait(item) => {
                        for item in &item.items {
                            if let TraitItem::Fn(function) = item {
                                let name = function.sig.ident.to_string();
                                methods.in_traits.entry(name).or_default().insert(module.of);
                            }
                        }
                    }
                    Item::Impl(item) if item.trait_.is_none() => {
                        if let Some(own) = type_of(resolver, id, &item.self_ty) {
                            methods.add(modules, id, &own, &item.items);
                        }
                    }
                    _ => {}
                }
            }
        }
        methods
    }

    /// Enters the items of an `impl` block.
    fn add(&mut self, modules: &Modules, module: ModuleId, own: &TypeId, items: &[ImplItem]) {
        let (of, file) = (modules.all[module].of, modules.all[module].file);
        let type_file = modules.all[own.0].file;
        for item in items.iter().filter(|item| !attributes::is_test(attributes::of_impl_item(item))) {
            let ident = match item {
                ImplItem::Const(item) => item.ident.to_string(),
                ImplItem::Fn(item) => item.sig.ident.to_string(),
                _ => continue,
            };
            let of_type = self.by_type.entry(own.clone()).or_default();
            of_type.entry(ident.clone()).or_default().insert(file);
            if let ImplItem::Fn(item) = item
                && matches!(item.sig.inputs.first(), Some(FnArg::Receiver(_)))
            {
                let name = format!("{}::{ident}", own.1);
                let arguments = item.sig.inputs.len() - 1;
                self.by_name.entry(ident).or_default().push(Method { of, file, type_file, name, arguments });
            }
        }
    }

    /// Returns the files that define an associated function or constant of a type.
    pub(super) fn of_type(&self, own: &TypeId, name: &str) -> impl Iterator<Item = FileId> {
        self.by_type.get(own).and_then(|of| of.get(name)).into_iter().flatten().copied()
    }

    /// Returns the method that a call means, if its name is unique among all methods that the crate can call and its
    /// `impl` block stands apart from the type.
    pub(super) fn of_call(&self, of: usize, name: &str, arguments: Option<usize>) -> Option<&Method> {
        let reach = &self.reach[of];
        if STANDARD.contains(&name) || self.in_traits.get(name).is_some_and(|of| !of.is_disjoint(reach)) {
            return None;
        }
        let mut reachable = self.by_name.get(name)?.iter().filter(|method| reach.contains(&method.of));
        let method = reachable.next()?;
        let is_unique = reachable.next().is_none();
        let fits = arguments.is_none_or(|arguments| arguments == method.arguments);
        (is_unique && fits && method.file != method.type_file).then_some(method)
    }
}

/// Resolves the type of an `impl` block.
pub(super) fn type_of(resolver: &Resolver, module: ModuleId, own: &Type) -> Option<TypeId> {
    let Type::Path(own) = own else { return None };
    let path: Vec<String> = own.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    resolver.resolve(module, &[], &path).into_iter().find_map(|target| match target {
        Target::Item(module, name, 0) => Some((module, name)),
        _ => None,
    })
}
