//! Names bound by the patterns of a function.

use std::collections::BTreeSet;

use syn::visit::{self, Visit};
use syn::{Block, PatIdent, Signature};

/// Collects the variables of a function: parameters, `let`, `match` arms and closures.
pub(super) fn bound(signature: &Signature, body: &Block) -> BTreeSet<String> {
    let mut names = Names(BTreeSet::new());
    names.visit_signature(signature);
    names.visit_block(body);
    names.0
}

struct Names(BTreeSet<String>);

impl<'ast> Visit<'ast> for Names {
    fn visit_pat_ident(&mut self, pattern: &'ast PatIdent) {
        self.0.insert(pattern.ident.to_string());
        visit::visit_pat_ident(self, pattern);
    }
}
