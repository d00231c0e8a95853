//! Imports of a module, found in its syntax.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Attribute, Block, Expr, ExprMethodCall, ImplItem, ImplItemFn, Item, ItemFn, ItemImpl, ItemMacro, ItemMod,
    ItemUse, Macro, Path, Stmt, Token, TraitItemFn, Visibility,
};

use super::methods::{self, Methods, TypeId};
use super::modules::{ModuleId, Modules};
use super::resolve::{Resolver, Target};
use super::uses::{self, Use};
use super::{attributes, locals, tokens};
use crate::layers::workspace::import::{FileId, Import};

/// Crate-wide tables.
#[derive(Clone, Copy)]
pub(super) struct Tables<'a> {
    pub(super) modules: &'a Modules,
    pub(super) resolver: &'a Resolver<'a>,
    pub(super) methods: &'a Methods,
}

/// Collects the imports of a module.
pub(super) fn imports(tables: Tables, module: ModuleId) -> Vec<Import> {
    let mut visitor = Visitor {
        tables,
        module,
        scope: Vec::new(),
        locals: BTreeSet::new(),
        own_type: None,
        found: Vec::new(),
    };
    let is_facade = is_facade(tables.modules, module);
    for item in &tables.modules.all[module].syntax {
        match item {
            Item::Use(item) => {
                let uses = uses::flatten(item);
                uses.iter()
                    .filter(|import| !(import.is_public && is_facade))
                    .for_each(|import| visitor.import(import));
            }
            item => visitor.visit_item(item),
        }
    }
    visitor.found
}

/// True if the re-exports of a module are free: it or the module around it in the same file has modules in files.
fn is_facade(modules: &Modules, module: ModuleId) -> bool {
    let own = &modules.all[module];
    let around = own.parent.filter(|&parent| modules.all[parent].file == own.file);
    own.is_folder || around.is_some_and(|parent| is_facade(modules, parent))
}

struct Visitor<'a> {
    tables: Tables<'a>,
    module: ModuleId,
    /// `use` declarations of the blocks around, from outer to inner.
    scope: Vec<Use>,
    /// Variables of the function.
    locals: BTreeSet<String>,
    /// Type of the `impl` block.
    own_type: Option<TypeId>,
    found: Vec<Import>,
}

impl Visitor<'_> {
    fn add(&mut self, to: FileId, line: usize, name: String) {
        let from = self.tables.modules.all[self.module].file;
        if from != to {
            self.found.push(Import { from, to, name, line });
        }
    }

    /// Enters the import of a `use` declaration.
    fn import(&mut self, import: &Use) {
        let targets = self.tables.resolver.resolve(self.module, &self.scope, &import.path);
        self.enter(targets, &import.path, import.line);
    }

    /// Enters the import of a path.
    fn path(&mut self, path: &[String], line: usize) {
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

    fn enter(&mut self, targets: Vec<Target>, path: &[String], line: usize) {
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
    fn associated(&mut self, own: &TypeId, name: &str, line: usize) {
        let files: Vec<_> = self.tables.methods.of_type(own, name).collect();
        files.into_iter().for_each(|file| self.add(file, line, format!("{}::{name}", own.1)));
    }

    /// Enters the import of a method call whose receiver is unknown.
    fn call(&mut self, name: &str, arguments: Option<usize>, line: usize) {
        let of = self.tables.modules.all[self.module].of;
        if let Some(method) = self.tables.methods.of_call(of, name, arguments) {
            self.add(method.file, line, method.name.clone());
        }
    }

    /// Enters the imports of tokens that are not parsed.
    fn tokens(&mut self, tokens: &TokenStream) {
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

    /// Visits a function with its variables.
    fn function(&mut self, locals: BTreeSet<String>, visit: impl FnOnce(&mut Self)) {
        let mut inner = self.locals.clone();
        inner.extend(locals);
        let outer = std::mem::replace(&mut self.locals, inner);
        visit(self);
        self.locals = outer;
    }
}

impl<'ast> Visit<'ast> for Visitor<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes::is_test(attributes::of_item(item)) {
            visit::visit_item(self, item);
        }
    }

    fn visit_impl_item(&mut self, item: &'ast ImplItem) {
        if !attributes::is_test(attributes::of_impl_item(item)) {
            visit::visit_impl_item(self, item);
        }
    }

    /// Modules have their own entries.
    fn visit_item_mod(&mut self, _: &'ast ItemMod) {}

    /// Declarations are entered with the block or the module.
    fn visit_item_use(&mut self, _: &'ast ItemUse) {}

    /// `pub(in path)` imports nothing.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_attribute(&mut self, attribute: &'ast Attribute) {
        attributes::paths(attribute).iter().for_each(|path| self.visit_type(path));
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        self.function(locals::bound(&item.sig, &item.block), |visitor| visit::visit_item_fn(visitor, item));
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.function(locals::bound(&item.sig, &item.block), |visitor| {
            visit::visit_impl_item_fn(visitor, item);
        });
    }

    fn visit_trait_item_fn(&mut self, item: &'ast TraitItemFn) {
        let locals = item.default.as_ref().map(|body| locals::bound(&item.sig, body)).unwrap_or_default();
        self.function(locals, |visitor| visit::visit_trait_item_fn(visitor, item));
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        let own = methods::type_of(self.tables.resolver, self.module, &item.self_ty);
        let outer = std::mem::replace(&mut self.own_type, own);
        visit::visit_item_impl(self, item);
        self.own_type = outer;
    }

    fn visit_block(&mut self, block: &'ast Block) {
        let outer = self.scope.len();
        for statement in &block.stmts {
            if let Stmt::Item(Item::Use(item)) = statement {
                let uses = uses::flatten(item);
                uses.iter().for_each(|import| self.import(import));
                self.scope.extend(uses);
            }
        }
        visit::visit_block(self, block);
        self.scope.truncate(outer);
    }

    fn visit_path(&mut self, path: &'ast Path) {
        let mut segments: Vec<String> =
            path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if path.leading_colon.is_some() {
            segments.insert(0, String::new());
        }
        self.path(&segments, path.span().start().line);
        visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let (name, line) = (call.method.to_string(), call.method.span().start().line);
        let is_own = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        match self.own_type.clone() {
            Some(own) if is_own => self.associated(&own, &name, line),
            _ => self.call(&name, Some(call.args.len()), line),
        }
        visit::visit_expr_method_call(self, call);
    }

    fn visit_item_macro(&mut self, item: &'ast ItemMacro) {
        if item.ident.is_some() {
            self.tokens(&item.mac.tokens);
        } else {
            visit::visit_item_macro(self, item);
        }
    }

    fn visit_macro(&mut self, invoked: &'ast Macro) {
        let path: Vec<String> =
            invoked.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let line = invoked.path.span().start().line;
        let targets = self.tables.resolver.macro_definition(self.module, &self.scope, &path);
        self.enter(targets, &path, line);
        match invoked.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            Ok(expressions) => expressions.iter().for_each(|expression| self.visit_expr(expression)),
            Err(_) => self.tokens(&invoked.tokens),
        }
    }
}
