//! Chores of the workspace: `cargo xtask test` is everything that can be tested.

mod debian;
mod environment;
mod fuzz;
mod package;
mod python;
mod speed;
mod supply;
mod tools;
mod viewer;

use std::env;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// What a chore returns: why it failed, in words.
type Done = Result<(), String>;

const HELP: &str = "\
cargo xtask test            everything that can be tested: format, lints, tests, documentation, counts of instructions,
                            dependencies, the viewer in a browser, Python
cargo xtask python          the Python package alone: installed, checked, tested, its site built
cargo xtask docs            the site, into target/site
cargo xtask schema          refresh docs/model.schema.json and the classes of Python after a change of the model types
cargo xtask viewer          the viewer of results, built into the crate that embeds it
cargo xtask deny            licences, sources, doubles and known weaknesses of dependencies, by deny.toml
cargo xtask fuzz [SECONDS]  bytes of any kind for the readers of models and formulas, 600 s each by default
cargo xtask bench           times per element beside their goals; --quick, --rows TEXT, --json FILE
cargo xtask instructions    counts of instructions of fixed work beside those on record; --update puts them on record
cargo xtask peers           EXUDYN beside ancf, into bench/peers/results; wants Python and the network
";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let (chore, options) =
        arguments.split_first().map_or(("", &[][..]), |(chore, rest)| (chore.as_str(), rest));
    let done = match chore {
        "test" => test(),
        "python" => package::test(),
        "docs" => package::docs(),
        "schema" => schema(),
        "deny" => supply::deny(),
        "fuzz" => fuzz::fuzz(options),
        "bench" => speed::bench(options),
        "instructions" => speed::instructions(options),
        "viewer" => viewer::build(),
        "peers" => speed::peers(),
        _ => Err(format!("what shall be done?\n\n{HELP}")),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            say(&why);
            ExitCode::FAILURE
        }
    }
}

/// Everything, the quick checks first; stops at the first that fails.
fn test() -> Done {
    component("fmt", "rustfmt")?;
    component("clippy", "clippy")?;
    supply::locked()?;
    cargo("format", &["fmt", "--all", "--check"], &[])?;
    cargo("lints", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])?;
    cargo("tests", &["test", "--workspace"], &[])?;
    let doc = ["doc", "--workspace", "--no-deps"];
    cargo("documentation", &doc, &[("RUSTDOCFLAGS", "-D warnings")])?;
    speed::instructions(&[])?;
    supply::deny()?;
    viewer::test()?;
    package::test()?;
    say("all tests passed");
    Ok(())
}

/// Installs a component of the toolchain if it is missing.
fn component(subcommand: &str, name: &str) -> Done {
    let there = Command::new(env!("CARGO")).args([subcommand, "--version"]).output();
    if there.is_ok_and(|output| output.status.success()) {
        return Ok(());
    }
    let install = Command::new("rustup").args(["component", "add", name]).status();
    match install {
        Ok(status) if status.success() => Ok(()),
        _ => Err(format!("`cargo {subcommand}` is missing; type: rustup component add {name}")),
    }
}

/// Runs cargo under a headline.
fn cargo(what: &str, arguments: &[&str], variables: &[(&str, &str)]) -> Done {
    say(&format!("\n== {what}: cargo {}", arguments.join(" ")));
    run(what, Command::new(env!("CARGO")).args(arguments).envs(variables.iter().copied()))
}

/// Runs a program and waits for its end.
fn run(what: &str, command: &mut Command) -> Done {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{what}: {status}")),
        Err(error) => Err(format!("{what}: cannot run {}: {error}", command.get_program().display())),
    }
}

/// The folder of the workspace.
fn root() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR"));
    own.parent().unwrap_or(own).to_owned()
}

/// Writes the JSON Schema of model files as the program prints it, and the classes of Python by it.
fn schema() -> Done {
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--package", "ancf-cli", "--", "schema"])
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let path = root().join("docs/model.schema.json");
    fs::write(&path, &output.stdout).map_err(|error| format!("{}: {error}", path.display()))?;
    python::write(&String::from_utf8_lossy(&output.stdout))
}

fn say(text: &str) {
    // Nothing is left to be done if standard error is closed.
    let _ = writeln!(io::stderr(), "{text}");
}
