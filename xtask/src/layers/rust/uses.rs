//! `use` declarations, flattened.

use syn::{ItemUse, UseTree, Visibility};

/// One name or glob of a `use` declaration.
#[derive(Debug, Clone)]
pub(super) struct Use {
    /// Segments of the path. A leading `::` is an empty first segment.
    pub(super) path: Vec<String>,
    /// Name that it introduces. `None` for a glob.
    pub(super) name: Option<String>,
    /// Line, from 1.
    pub(super) line: usize,
    /// True if it has a visibility, hence re-exports the name.
    pub(super) is_public: bool,
}

/// Flattens the tree of a declaration.
pub(super) fn flatten(item: &ItemUse) -> Vec<Use> {
    let is_public = !matches!(item.vis, Visibility::Inherited);
    let start = if item.leading_colon.is_some() { vec![String::new()] } else { Vec::new() };
    let mut found = Vec::new();
    branch(&item.tree, &start, is_public, &mut found);
    found
}

fn branch(tree: &UseTree, start: &[String], is_public: bool, found: &mut Vec<Use>) {
    let extended = |name: String| [start, &[name]].concat();
    match tree {
        UseTree::Path(path) => branch(&path.tree, &extended(path.ident.to_string()), is_public, found),
        UseTree::Group(group) => group.items.iter().for_each(|tree| branch(tree, start, is_public, found)),
        UseTree::Glob(glob) => {
            let line = glob.star_token.spans[0].start().line;
            found.push(Use { path: start.to_vec(), name: None, line, is_public });
        }
        UseTree::Name(name) => {
            let line = name.ident.span().start().line;
            let name = name.ident.to_string();
            // `use a::b::{self}` introduces `b`.
            let (path, name) = match start.last() {
                Some(last) if name == "self" => (start.to_vec(), last.clone()),
                _ => (extended(name.clone()), name),
            };
            found.push(Use { path, name: Some(name), line, is_public });
        }
        UseTree::Rename(rename) => {
            let line = rename.ident.span().start().line;
            let name = rename.ident.to_string();
            let path = if name == "self" { start.to_vec() } else { extended(name) };
            found.push(Use { path, name: Some(rename.rename.to_string()), line, is_public });
        }
    }
}
