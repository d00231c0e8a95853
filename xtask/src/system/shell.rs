//! Running programs and printing messages.

use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

/// Result of a command: the error is the reason, in words.
pub(crate) type Done = Result<(), String>;

/// Runs cargo under a headline.
pub(crate) fn cargo(what: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Done {
    say(&format!("\n== {what}: cargo {}", arguments.join(" ")));
    run(what, Command::new(env!("CARGO")).args(arguments).envs(variables.iter().copied()))
}

/// Runs a program and waits for its end.
pub(crate) fn run(what: &str, command: &mut Command) -> Done {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{what}: {status}")),
        Err(error) => Err(format!("{what}: cannot run {}: {error}", command.get_program().display())),
    }
}

/// Runs two parts at the same time, each to its end or its first failure. Returns the first failure.
pub(crate) fn side_by_side(first: impl FnOnce() -> Done, second: impl FnOnce() -> Done + Send) -> Done {
    thread::scope(|scope| {
        let second = scope.spawn(second);
        let first = first();
        let second = second.join().unwrap_or_else(|_| Err("a part panicked".to_owned()));
        first.and(second)
    })
}

/// Returns the root folder of the workspace.
pub(crate) fn root() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.parent().unwrap_or(own).to_owned()
}

/// Prints a line on standard error.
pub(crate) fn say(text: &str) {
    // A closed standard error cannot be reported anywhere.
    let _ = writeln!(io::stderr(), "{text}");
}
