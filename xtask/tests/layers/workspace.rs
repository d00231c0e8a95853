//! Workspaces in temporary folders.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A workspace of one tree, `house/src` or `house`.
pub(crate) struct Workspace {
    root: PathBuf,
    config: String,
}

impl Workspace {
    /// Makes a workspace with a Rust crate `house`.
    pub(crate) fn rust(name: &str, layers: &[&str]) -> Self {
        Self::new(name).tree("house/src", "rust", layers)
    }

    /// Makes a workspace with a Python package `house`.
    pub(crate) fn python(name: &str, layers: &[&str]) -> Self {
        Self::new(name).tree("house", "python", layers)
    }

    /// Makes a workspace with a TypeScript folder `house`.
    pub(crate) fn typescript(name: &str, layers: &[&str]) -> Self {
        Self::new(name).tree("house", "typescript", layers)
    }

    fn new(name: &str) -> Self {
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join("layers").join(name);
        if root.exists() {
            fs::remove_dir_all(&root).unwrap();
        }
        fs::create_dir_all(&root).unwrap();
        Self { root, config: "[limits]\nfiles = 12\nlines = 400\n".to_owned() }
    }

    /// Adds a tree.
    pub(crate) fn tree(mut self, path: &str, language: &str, layers: &[&str]) -> Self {
        self.config +=
            &format!("[[tree]]\npath = \"{path}\"\nlanguage = \"{language}\"\nlayers = {layers:?}\n");
        self
    }

    /// Replaces a line of the configuration.
    pub(crate) fn configured(mut self, from: &str, to: &str) -> Self {
        assert!(self.config.contains(from), "{}", self.config);
        self.config = self.config.replace(from, to);
        self
    }

    /// Adds a file.
    pub(crate) fn file(self, path: &str, text: &str) -> Self {
        let path = self.root.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
        self
    }

    /// Runs the command. Returns its messages and whether it succeeded.
    pub(crate) fn run(&self, options: &[&str]) -> (bool, String) {
        fs::write(self.root.join("layers.toml"), &self.config).unwrap();
        let mut command = Command::new(env!("CARGO_BIN_EXE_xtask"));
        let output = command.arg("layers").arg("--root").arg(&self.root).args(options).output().unwrap();
        (output.status.success(), String::from_utf8(output.stderr).unwrap())
    }

    /// Asserts that the command succeeds.
    pub(crate) fn passes(&self) -> String {
        let (is_success, said) = self.run(&[]);
        assert!(is_success, "{said}");
        said
    }

    /// Asserts that the command fails with one violation that contains the given texts.
    pub(crate) fn fails(&self, texts: &[&str]) {
        let (is_success, said) = self.run(&[]);
        assert!(!is_success && said.contains("layers: 1 violation\n"), "{said}");
        texts.iter().for_each(|text| assert!(said.contains(text), "expected {text}\n{said}"));
    }
}
