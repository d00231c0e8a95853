//! Temporary folder of a test, and the program in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// Temporary folder of a test.
pub struct TestFolder(TempDir);

/// Exit code and output of a command.
pub struct CommandOutput {
    /// Exit code.
    pub code: Option<i32>,
    /// Standard output.
    pub printed: String,
    /// Standard error.
    pub messages: String,
}

impl TestFolder {
    pub fn new() -> Self {
        Self(TempDir::new().unwrap())
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    /// Returns the program in this folder, without variables for colours and characters.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ancf"));
        command.args(arguments).current_dir(self.0.path());
        for name in ["NO_COLOR", "FORCE_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "LC_ALL", "LC_CTYPE", "LANG"] {
            command.env_remove(name);
        }
        command
    }

    pub fn ancf(&self, arguments: &[&str]) -> CommandOutput {
        CommandOutput::new(&self.command(arguments).output().unwrap())
    }

    /// Runs a command that must succeed, and returns its standard output.
    pub fn printed(&self, arguments: &[&str]) -> String {
        let output = self.ancf(arguments);
        assert_eq!(output.code, Some(0), "{arguments:?}: {}", output.messages);
        output.printed
    }

    /// Returns the names of all commands, from the help of the program.
    pub fn commands(&self) -> Vec<String> {
        let commands: Vec<String> = self
            .printed(&["--help"])
            .lines()
            .skip_while(|line| *line != "Commands:")
            .skip(1)
            .take_while(|line| !line.is_empty())
            .filter_map(|line| line.strip_prefix("  ").filter(|line| !line.starts_with(' ')))
            .filter_map(|line| line.split_whitespace().next())
            .filter(|command| *command != "help")
            .map(str::to_owned)
            .collect();
        assert!(commands.len() >= 12, "{commands:?}");
        commands
    }

    /// Creates a folder with a template model and its run in `out`.
    pub fn with_run(kind: &str) -> Self {
        let folder = Self::new();
        folder.printed(&["new", "model.toml", "--kind", kind]);
        folder.printed(&["run", "model.toml", "-o", "out"]);
        folder
    }
}

impl CommandOutput {
    pub fn new(output: &Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
        Self { code: output.status.code(), printed: text(&output.stdout), messages: text(&output.stderr) }
    }

    /// Returns standard output, which must be one JSON value.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.printed).unwrap_or_else(|error| panic!("{error}: {}", self.printed))
    }
}

/// Returns the root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}
