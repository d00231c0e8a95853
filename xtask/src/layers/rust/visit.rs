//! Imports of a module, found in its syntax.

use std::collections::BTreeSet;

use syn::punctuated::Punctuated;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{
    Attribute, Block, Expr, ExprMethodCall, ImplItem, ImplItemFn, Item, ItemFn, ItemImpl, ItemMacro, ItemMod,
    ItemUse, Macro, Path, Stmt, Token, TraitItemFn, Visibility,
};

use super::importer::{Importer, Tables};
use super::methods;
use super::modules::{ModuleId, Modules};
use super::{attributes, locals, uses};
use crate::layers::workspace::import::Import;

/// Collects the imports of a module.
pub(super) fn imports(tables: Tables, module: ModuleId) -> Vec<Import> {
    let mut visitor = Visitor(Importer::new(tables, module));
    let is_facade = is_facade(tables.modules, module);
    for item in &tables.modules.all[module].syntax {
        match item {
            Item::Use(item) => {
                let uses = uses::flatten(item);
                uses.iter()
                    .filter(|import| !(import.is_public && is_facade))
                    .for_each(|import| visitor.0.import(import));
            }
            item => visitor.visit_item(item),
        }
    }
    visitor.0.found
}

/// True if the re-exports of a module are free: it or the module around it in the same file has modules in files.
fn is_facade(modules: &Modules, module: ModuleId) -> bool {
    let own = &modules.all[module];
    let around = own.parent.filter(|&parent| modules.all[parent].file == own.file);
    own.is_folder || around.is_some_and(|parent| is_facade(modules, parent))
}

/// Walks through the syntax of a module.
struct Visitor<'a>(Importer<'a>);

impl Visitor<'_> {
    /// Visits a function with its variables.
    fn function(&mut self, locals: BTreeSet<String>, visit: impl FnOnce(&mut Self)) {
        let mut inner = self.0.locals.clone();
        inner.extend(locals);
        let outer = std::mem::replace(&mut self.0.locals, inner);
        visit(self);
        self.0.locals = outer;
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
        let own = methods::type_of(self.0.tables.resolver, self.0.module, &item.self_ty);
        let outer = std::mem::replace(&mut self.0.own_type, own);
        visit::visit_item_impl(self, item);
        self.0.own_type = outer;
    }

    fn visit_block(&mut self, block: &'ast Block) {
        let outer = self.0.scope.len();
        for statement in &block.stmts {
            if let Stmt::Item(Item::Use(item)) = statement {
                let uses = uses::flatten(item);
                uses.iter().for_each(|import| self.0.import(import));
                self.0.scope.extend(uses);
            }
        }
        visit::visit_block(self, block);
        self.0.scope.truncate(outer);
    }

    fn visit_path(&mut self, path: &'ast Path) {
        let mut segments: Vec<String> =
            path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        if path.leading_colon.is_some() {
            segments.insert(0, String::new());
        }
        self.0.path(&segments, path.span().start().line);
        visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let (name, line) = (call.method.to_string(), call.method.span().start().line);
        let is_own = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        match self.0.own_type.clone() {
            Some(own) if is_own => self.0.associated(&own, &name, line),
            _ => self.0.call(&name, Some(call.args.len()), line),
        }
        visit::visit_expr_method_call(self, call);
    }

    fn visit_item_macro(&mut self, item: &'ast ItemMacro) {
        if item.ident.is_some() {
            self.0.tokens(&item.mac.tokens);
        } else {
            visit::visit_item_macro(self, item);
        }
    }

    fn visit_macro(&mut self, invoked: &'ast Macro) {
        let path: Vec<String> =
            invoked.path.segments.iter().map(|segment| segment.ident.to_string()).collect();
        let line = invoked.path.span().start().line;
        let targets = self.0.tables.resolver.macro_definition(self.0.module, &self.0.scope, &path);
        self.0.enter(targets, &path, line);
        match invoked.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated) {
            Ok(expressions) => expressions.iter().for_each(|expression| self.visit_expr(expression)),
            Err(_) => self.0.tokens(&invoked.tokens),
        }
    }
}
