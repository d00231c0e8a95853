//! Standard output that cannot be written: a full disk is an error, a closed pipe is not.

use std::fs::File;
use std::io;
use std::process::Stdio;

use crate::folder::{CommandOutput, TestFolder};

/// Arguments of commands that print on standard output, in the folder of [`folder`].
const PRINTING: [&[&str]; 24] = [
    &["new", "-"],
    &["check", "model.toml"],
    &["check", "model.toml", "--json"],
    &["check", "nowhere.toml", "--json"],
    &["run", "model.toml", "-o", "again"],
    &["run", "model.toml", "-o", "again", "--json"],
    &["resume", "out", "--json"],
    &["report", "out"],
    &["view", "out"],
    &["plot", "out"],
    &["plot", "out", "frequency"],
    &["plot", "out", "--json"],
    &["plot", "out", "--json", "--nonsense"],
    &["paraview", "out"],
    &["study", "study.toml", "-o", "cases"],
    &["study", "study.toml", "-o", "cases", "--json"],
    &["gradients", "model.toml", "-p", "materials.steel.young"],
    &["gradients", "model.toml", "-p", "materials.steel.young", "--json"],
    &["scaled", "model.toml"],
    &["schema"],
    &["verify", "elastica", "-o", "verify", "--json"],
    &["completions", "bash"],
    &["man"],
    &["--version"],
];

/// Commands that print nothing on standard output except their help.
const SILENT: [&str; 2] = ["fmu", "paper"];

const STUDY: &str = r#"
model = "model.toml"
parameters = { "bodies.blade.elements" = [4, 5] }
objectives = { first = { column = "frequency", take = "min" } }
"#;

/// Model, its run and its study.
fn folder() -> TestFolder {
    let folder = TestFolder::with_run("modes");
    folder.write("study.toml", STUDY);
    folder
}

fn run(folder: &TestFolder, arguments: &[&str], output: impl Into<Stdio>) -> CommandOutput {
    let arguments = [&["--quiet"], arguments].concat();
    CommandOutput::new(&folder.command(&arguments).stdout(output).output().unwrap())
}

#[cfg(target_os = "linux")]
fn assert_full_disk_is_reported(folder: &TestFolder, arguments: &[&str]) {
    let full = File::options().write(true).open("/dev/full").unwrap();
    let output = run(folder, arguments, full);
    let expected = "error: cannot write to standard output: No space left on device (os error 28)";
    let messages = &output.messages;
    assert_eq!(output.code, Some(1), "{arguments:?}: {messages}");
    assert_eq!(messages.lines().filter(|line| *line == expected).count(), 1, "{arguments:?}: {messages}");
    // Invalid input has its own message.
    let is_valid = !arguments.contains(&"nowhere.toml") && !arguments.contains(&"--nonsense");
    assert!(!is_valid || messages.lines().count() == 1, "{arguments:?}: {messages}");
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_is_reported_by_every_command() {
    let folder = folder();
    for arguments in PRINTING {
        assert_full_disk_is_reported(&folder, arguments);
    }
    let commands = folder.commands();
    for name in &commands {
        assert_full_disk_is_reported(&folder, &[name, "--help"]);
        assert_full_disk_is_reported(&folder, &["help", name]);
    }
    assert_full_disk_is_reported(&folder, &["--help"]);
}

/// New commands and new options `--json` need a case.
#[test]
fn every_command_has_a_case() {
    let folder = TestFolder::new();
    for name in folder.commands() {
        let own: Vec<_> = PRINTING.iter().filter(|arguments| arguments[0] == name).collect();
        assert!(!own.is_empty() || SILENT.contains(&name.as_str()), "`ancf {name}` has no case");
        let help = folder.printed(&[&name, "--help"]);
        let is_json = own.iter().any(|arguments| arguments.contains(&"--json"));
        assert!(!help.contains("--json") || is_json, "`ancf {name} --json` has no case");
    }
}

/// `ancf COMMAND | head -1` ends without a message and with the exit code of the command.
#[test]
fn a_closed_pipe_is_not_an_error() {
    let folder = folder();
    // A server runs until it is stopped.
    for arguments in PRINTING.into_iter().filter(|arguments| arguments[0] != "view") {
        let undisturbed = run(&folder, arguments, Stdio::piped());
        assert!(!undisturbed.printed.is_empty(), "{arguments:?}");
        let (reader, writer) = io::pipe().unwrap();
        drop(reader);
        let closed = run(&folder, arguments, writer);
        assert_eq!((closed.code, closed.messages), (undisturbed.code, undisturbed.messages), "{arguments:?}");
    }
}
