//! Folder of one run of the program.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

pub fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
    command.args(arguments).current_dir(root());
    command
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Folder with the model and the results of one test.
pub struct RunFolder(pub TempDir);

impl RunFolder {
    pub fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub fn out(&self) -> PathBuf {
        self.0.path().join("out")
    }

    /// `ancf run FILE -o OUT`.
    pub fn run(&self, file: &str) -> Command {
        command(&["run", file, "-o", self.out().to_str().unwrap()])
    }

    /// Writes the cantilever with a line replaced, and returns its path.
    pub fn cantilever(&self, line: &str, by: &str) -> String {
        let text = fs::read_to_string(root().join("models/cantilever.toml")).unwrap();
        assert!(text.contains(line), "the cantilever has `{line}`");
        let path = self.0.path().join("model.toml");
        fs::write(&path, text.replacen(line, by, 1)).unwrap();
        path.to_str().unwrap().to_owned()
    }

    pub fn summary(&self) -> Value {
        serde_json::from_slice(&fs::read(self.out().join("summary.json")).unwrap()).unwrap()
    }

    pub fn column(&self, name: &str) -> Vec<f64> {
        let text = fs::read_to_string(self.out().join("probes.csv")).unwrap();
        let at = text.lines().next().unwrap().split(',').position(|column| column == name).unwrap();
        text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    }
}

pub fn assert_near(ours: &[f64], expected: &[f64], tolerance: f64) {
    let off = ours.iter().zip(expected).any(|(x, y)| (x - y).abs() > tolerance);
    assert!(!off && ours.len() == expected.len(), "{ours:?} instead of {expected:?}");
}
