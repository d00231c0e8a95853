//! Imports of a TypeScript tree.

use std::collections::BTreeMap;

use super::declarations::{self, Declaration};
use crate::layers::workspace::import::{FileId, Import};
use crate::layers::workspace::source::{self, SourceFile};

/// Declarations by file.
type Declarations = BTreeMap<FileId, Vec<Declaration>>;

/// Collects the imports of a tree and marks the files `index.ts` that only re-export.
pub(in crate::layers) fn imports(tree: usize, files: &mut [SourceFile]) -> Vec<Import> {
    let mut declared = Declarations::new();
    for (id, file) in files.iter_mut().enumerate().filter(|(_, file)| file.tree == tree) {
        let (declarations, is_facade) = declarations::parse(&file.text);
        file.is_facade = is_facade && is_index(file);
        declared.insert(id, declarations);
    }
    let mut found = Vec::new();
    for (&from, declarations) in &declared {
        for declaration in
            declarations.iter().filter(|declaration| !(declaration.is_export && is_index(&files[from])))
        {
            let Some(to) = file_of(files, from, &declaration.source) else { continue };
            let mut add = |to, name: &str| {
                found.push(Import { from, to, name: name.to_owned(), line: declaration.line });
            };
            if declaration.names.is_empty() {
                add(to, &declaration.source);
            }
            for (there, here) in &declaration.names {
                if there == "*" {
                    let used = members(&files[from].text, here);
                    if !files[to].is_facade || used.is_empty() {
                        add(to, &declaration.source);
                    }
                    for name in used {
                        add(definition(&declared, files, to, name, 0), name);
                    }
                } else {
                    add(definition(&declared, files, to, there, 0), there);
                }
            }
        }
    }
    found
}

fn is_index(file: &SourceFile) -> bool {
    file.inner == "index.ts" || file.inner.ends_with("/index.ts")
}

/// Finds the file that a relative source means.
fn file_of(files: &[SourceFile], from: FileId, source: &str) -> Option<FileId> {
    let mut parts: Vec<&str> = match source::parent(&files[from].inner) {
        "." => Vec::new(),
        folder => folder.split('/').collect(),
    };
    if !source.starts_with('.') {
        return None;
    }
    for part in source.split('/') {
        match part {
            "." | "" => {}
            ".." => {
                parts.pop()?;
            }
            part => parts.push(part),
        }
    }
    let path = parts.join("/");
    let stem = [".js", ".ts", ".tsx"].iter().find_map(|end| path.strip_suffix(end)).unwrap_or(&path);
    let index = format!("{stem}/index.ts");
    let candidates = [format!("{stem}.ts"), format!("{stem}.tsx"), index.trim_start_matches('/').to_owned()];
    let tree = files[from].tree;
    candidates.iter().find_map(|path| files.iter().position(|file| file.tree == tree && file.inner == *path))
}

/// Follows the re-exports of a file to the one that defines a name.
fn definition(
    declared: &Declarations,
    files: &[SourceFile],
    file: FileId,
    name: &str,
    depth: usize,
) -> FileId {
    let below = |source: &str, name: &str| {
        let to = file_of(files, file, source).filter(|_| depth < 20)?;
        Some(definition(declared, files, to, name, depth + 1))
    };
    let exports = || declared[&file].iter().filter(|declaration| declaration.is_export);
    for export in exports() {
        if let Some((there, _)) = export.names.iter().find(|(there, here)| here == name && there != "*") {
            return below(&export.source, there).unwrap_or(file);
        }
    }
    let all =
        exports().filter(|export| export.names.iter().any(|(there, here)| there == "*" && here.is_empty()));
    all.filter_map(|export| below(&export.source, name))
        .find(|&found| exports_itself(&files[found].text, name))
        .unwrap_or(file)
}

/// True if code exports a name that it defines.
fn exports_itself(code: &str, name: &str) -> bool {
    code.lines().filter_map(|line| line.trim_start().strip_prefix("export ")).any(|rest| {
        let is_separator = |sign: char| !sign.is_alphanumeric() && sign != '_' && sign != '$';
        rest.split(is_separator).any(|word| word == name)
    })
}

/// Returns the members of a namespace that code uses: `b` for each `a.b`.
fn members<'a>(code: &'a str, namespace: &str) -> Vec<&'a str> {
    if namespace.is_empty() {
        return Vec::new();
    }
    let is_word = |sign: char| sign.is_alphanumeric() || sign == '_' || sign == '$';
    code.match_indices(&format!("{namespace}."))
        .filter(|(at, _)| !code[..*at].ends_with(|before: char| is_word(before) || before == '.'))
        .map(|(at, _)| {
            let rest = &code[at + namespace.len() + 1..];
            &rest[..rest.find(|sign: char| !is_word(sign)).unwrap_or(rest.len())]
        })
        .filter(|name| !name.is_empty())
        .collect()
}
