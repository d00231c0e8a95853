//! Modules of the crates, with the names they define and import.

use std::collections::{BTreeMap, BTreeSet};

use syn::Item;

use super::attributes;
use super::crates::Crate;
use super::uses::{self, Use};
use crate::layers::workspace::import::FileId;
use crate::layers::workspace::source::SourceFile;

/// Index of a module.
pub(super) type ModuleId = usize;

/// A module, in a file of its own or inline.
pub(super) struct Module {
    /// Crate, by index.
    pub(super) of: usize,
    pub(super) file: FileId,
    pub(super) parent: Option<ModuleId>,
    /// Names of items defined here.
    pub(super) items: BTreeSet<String>,
    /// Child modules.
    pub(super) children: BTreeMap<String, ModuleId>,
    pub(super) uses: Vec<Use>,
    /// Syntax of the items. The content of child modules is in their own entries.
    pub(super) syntax: Vec<Item>,
    /// True for `lib.rs`, `main.rs`, `mod.rs` and files with modules in files of their own.
    pub(super) is_folder: bool,
}

/// All modules of all crates.
#[derive(Default)]
pub(super) struct Modules {
    pub(super) all: Vec<Module>,
    /// Root modules of the crates.
    pub(super) roots: Vec<ModuleId>,
    /// Files that belong to a module, tests included.
    pub(super) reached: BTreeSet<FileId>,
    /// Declarations without a file and files that cannot be parsed: file and reason.
    pub(super) broken: Vec<(FileId, String)>,
}

/// Position of a module that is being read.
struct Place {
    of: usize,
    file: FileId,
    parent: Option<ModuleId>,
    /// Folder of its child files, relative to the tree, with a `/` at its end if it is not empty.
    folder: String,
}

impl Modules {
    /// Reads the modules of all crates from their root files.
    pub(super) fn read(crates: &[Crate], files: &[SourceFile]) -> Self {
        let mut modules = Self::default();
        for (of, own) in crates.iter().enumerate() {
            let position = files.iter().position(|file| file.tree == own.tree && file.inner == own.root);
            let file = position.expect("crates are found by their root files");
            let folder =
                own.root.rsplit_once('/').map_or_else(String::new, |(folder, _)| format!("{folder}/"));
            let root = modules.read_file(files, Place { of, file, parent: None, folder }, false);
            let root = root.unwrap_or_else(|| modules.add(of, file, None, Vec::new()));
            modules.roots.push(root);
        }
        modules
    }

    fn add(&mut self, of: usize, file: FileId, parent: Option<ModuleId>, syntax: Vec<Item>) -> ModuleId {
        self.all.push(Module {
            of,
            file,
            parent,
            items: BTreeSet::new(),
            children: BTreeMap::new(),
            uses: Vec::new(),
            syntax,
            is_folder: parent.is_none(),
        });
        self.all.len() - 1
    }

    /// Reads the module of a file. Files of tests are marked as reached and left out.
    fn read_file(&mut self, files: &[SourceFile], place: Place, is_test: bool) -> Option<ModuleId> {
        self.reached.insert(place.file);
        let syntax = match syn::parse_file(&files[place.file].text) {
            Ok(syntax) => syntax,
            Err(error) => {
                let line = error.span().start().line;
                self.broken.push((place.file, format!("line {line}: {error}")));
                return None;
            }
        };
        let is_test = is_test || attributes::is_test(&syntax.attrs);
        let is_folder = place.parent.is_none() || files[place.file].inner.ends_with("mod.rs");
        let module = self.read_items(files, place, syntax.items, is_test)?;
        self.all[module].is_folder |= is_folder;
        Some(module)
    }

    /// Reads the items of a module and its child modules. Returns `None` for tests.
    fn read_items(
        &mut self,
        files: &[SourceFile],
        place: Place,
        mut items: Vec<Item>,
        is_test: bool,
    ) -> Option<ModuleId> {
        let (of, file) = (place.of, place.file);
        let own = (!is_test).then(|| self.add(of, file, place.parent, Vec::new()));
        for item in &mut items {
            let is_test = is_test || attributes::is_test(attributes::of_item(item));
            let Item::Mod(declared) = item else {
                if let Some(own) = own.filter(|_| !is_test) {
                    self.define(own, item);
                }
                continue;
            };
            let name = declared.ident.to_string();
            let folder = format!("{}{name}/", place.folder);
            let child = if let Some((_, content)) = declared.content.take() {
                self.read_items(files, Place { of, file, parent: own, folder }, content, is_test)
            } else {
                let given = attributes::path(&declared.attrs);
                if let Some(child) = child_file(files, file, &place.folder, &name, given) {
                    if let Some(own) = own {
                        self.all[own].is_folder = true;
                    }
                    self.read_file(files, Place { of, file: child, parent: own, folder }, is_test)
                } else {
                    self.broken.push((file, format!("`mod {name};` has no file")));
                    None
                }
            };
            if let (Some(own), Some(child)) = (own, child) {
                self.all[own].children.insert(name, child);
            }
        }
        self.all[own?].syntax = items;
        own
    }

    /// Enters the names that an item defines or imports.
    fn define(&mut self, module: ModuleId, item: &Item) {
        let ident = match item {
            Item::Use(item) => {
                self.all[module].uses.extend(uses::flatten(item));
                return;
            }
            Item::Const(item) => &item.ident,
            Item::Enum(item) => &item.ident,
            Item::Fn(item) => &item.sig.ident,
            Item::Static(item) => &item.ident,
            Item::Struct(item) => &item.ident,
            Item::Trait(item) => &item.ident,
            Item::TraitAlias(item) => &item.ident,
            Item::Type(item) => &item.ident,
            Item::Union(item) => &item.ident,
            Item::Macro(item) => match &item.ident {
                Some(ident) => ident,
                None => return,
            },
            _ => return,
        };
        self.all[module].items.insert(ident.to_string());
    }
}

/// Finds the file of a declared module.
fn child_file(
    files: &[SourceFile],
    of: FileId,
    folder: &str,
    name: &str,
    given: Option<String>,
) -> Option<FileId> {
    let candidates = match given {
        Some(path) => {
            let beside = files[of].inner.rsplit_once('/').map_or("", |(folder, _)| folder);
            vec![format!("{beside}/{path}").trim_start_matches('/').to_owned()]
        }
        None => vec![format!("{folder}{name}.rs"), format!("{folder}{name}/mod.rs")],
    };
    files.iter().position(|file| file.tree == files[of].tree && candidates.contains(&file.inner))
}
