//! The architecture of the library, read from its sources: floors use only what `lib.rs` draws below them, and no file
//! is too long to read in one sitting.
#![cfg(test)]

use std::fs;
use std::path::{Path, PathBuf};

/// Each module of the crate and the modules that it may name.
const FLOORS: [(&str, &[&str]); 11] = [
    ("function", &[]),
    ("system", &[]),
    ("scales", &[]),
    ("record", &[]),
    ("mechanics", &["function", "system"]),
    ("analysis", &["system"]),
    ("model", &["analysis", "function", "mechanics", "system", "scales"]),
    ("rows", &["analysis", "mechanics", "model", "record", "scales", "system"]),
    ("fields", &["mechanics", "model", "scales", "system"]),
    ("simulate", &["analysis", "model", "record", "rows", "scales", "system"]),
    ("lib", &[]),
];

/// Lines that a source file may have.
const LINES: usize = 400;

fn sources(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> =
        entries.flat_map(|path| if path.is_dir() { sources(&path) } else { vec![path] }).collect();
    files.retain(|path| path.extension().is_some_and(|extension| extension == "rs"));
    files
}

fn library() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The modules that a text names after `crate::`, comments left out.
fn uses(text: &str) -> Vec<String> {
    let code: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
    let code = code.join("\n");
    let paths = code.split("crate::").skip(1);
    paths.flat_map(names).collect()
}

/// The first names of a path or of a group of paths.
fn names(path: &str) -> Vec<String> {
    let name = |path: &str| path.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    match path.strip_prefix('{') {
        None => vec![name(path)],
        Some(group) => {
            let mut depth = 1;
            let end = group.find(|c| {
                depth += i32::from(c == '{') - i32::from(c == '}');
                depth == 0
            });
            let mut outer = String::new();
            for c in group[..end.unwrap_or(group.len())].chars() {
                depth += i32::from(c == '{') - i32::from(c == '}');
                if depth == 0 || c == '{' {
                    outer.push(c);
                }
            }
            outer.split(',').map(name).collect()
        }
    }
}

/// The module of a file: its folder in `src`, or its own name.
fn module(file: &Path) -> String {
    let inside = file.strip_prefix(library()).unwrap();
    inside.components().next().unwrap().as_os_str().to_str().unwrap().trim_end_matches(".rs").to_owned()
}

#[test]
fn arrows_point_downwards() {
    let files = sources(&library());
    assert!(files.len() > 30, "{} files", files.len());
    for file in files {
        let own = module(&file);
        let (_, below) = FLOORS
            .iter()
            .find(|(floor, _)| *floor == own)
            .unwrap_or_else(|| panic!("{own} is on no floor: draw it in lib.rs and here"));
        for used in uses(&fs::read_to_string(&file).unwrap()) {
            let allowed = used == own || below.contains(&used.as_str());
            assert!(allowed, "{} uses crate::{used}, which is not below {own}", file.display());
        }
    }
}

/// The floors themselves have no cycle, and mechanics and analysis do not know each other.
#[test]
fn floors_are_in_order() {
    for (at, (floor, below)) in FLOORS.iter().enumerate() {
        for used in *below {
            let under = FLOORS.iter().position(|(name, _)| name == used).unwrap();
            assert!(under < at, "{floor} above {used}");
        }
    }
}

/// A module leaves its folder by `crate::` only, where the first test sees it.
#[test]
fn no_back_doors() {
    for file in sources(&library()) {
        let text = fs::read_to_string(&file).unwrap();
        assert!(!text.contains("super::super"), "{}", file.display());
    }
}

#[test]
fn files_fit_a_sitting() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for file in ["src", "tests"].iter().flat_map(|folder| sources(&root.join(folder))) {
        let lines = fs::read_to_string(&file).unwrap().lines().count();
        assert!(lines <= LINES, "{} has {lines} lines", file.display());
    }
}

#[test]
fn reads_uses() {
    let text =
        "use crate::system::{State, Term};\nuse crate::{a::{b, c}, d};\n// crate::x\nlet y = crate::e::f(1);";
    assert_eq!(uses(text), ["system", "a", "d", "e"]);
}
