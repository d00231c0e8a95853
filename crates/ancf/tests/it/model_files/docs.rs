//! Links and names in the documentation.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All files with an extension below a folder.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() && !["target", "out", ".git", "node_modules"].iter().any(|skip| path.ends_with(skip))
        {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|end| end == extension) {
            found.push(path);
        }
    }
    found
}

/// Texts between two delimiters.
fn between<'a>(text: &'a str, open: &str, close: &str) -> Vec<&'a str> {
    text.split(open).skip(1).filter_map(|rest| rest.split(close).next()).collect()
}

#[test]
fn links_have_targets() {
    for page in files(&root(), "md") {
        let text = fs::read_to_string(&page).unwrap();
        for link in between(&text, "](", ")").into_iter().filter(|link| !link.contains("://")) {
            let target = page.parent().unwrap().join(link.split('#').next().unwrap());
            assert!(target.exists(), "{}: {link} does not exist", page.display());
        }
    }
}

/// `docs/paper.md` maps equations to files and tests.
#[test]
fn paper_map_names_existing_files_and_tests() {
    let sources: String = files(&root(), "rs").iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    let functions: BTreeSet<&str> = between(&sources, "fn ", "(").into_iter().collect();
    let text = fs::read_to_string(root().join("docs/paper.md")).unwrap();
    let rows = text.lines().filter(|line| line.starts_with('|'));
    let mut names = 0;
    for name in rows.flat_map(|row| row.split('`').skip(1).step_by(2)) {
        names += 1;
        let is_file = name.contains('/') && root().join(name).exists();
        assert!(is_file || functions.contains(name), "docs/paper.md: `{name}` does not exist");
    }
    assert!(names > 60, "the page has {names} names");
}
