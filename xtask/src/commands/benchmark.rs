//! Benchmarks: times, instruction counts, comparison with EXUDYN and MuJoCo.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::system::debian;
use crate::system::debian::has;
use crate::system::environment::Environment;
use crate::system::shell::{Done, cargo, root, run, say};

/// Runs the benchmark program with one thread. It is run by its path: `cargo run` would build it with other features.
fn measure(command: &str, options: &[String]) -> Done {
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let program = target.join("release").join(format!("ancf-bench{}", env::consts::EXE_SUFFIX));
    let arguments: Vec<&OsStr> =
        [command].into_iter().chain(options.iter().map(String::as_str)).map(OsStr::new).collect();
    alone(&program, &arguments)
}

/// Builds the benchmark program and `ancf` together. Separately, each has other features of its dependencies and
/// rebuilds all of them.
fn build() -> Done {
    cargo("build", &["build", "--release", "--package", "ancf-cli", "--package", "ancf-bench"], &[])
}

/// Prints times beside their targets.
pub(crate) fn bench(options: &[String]) -> Done {
    build()?;
    measure("table", options)
}

/// Compares instruction counts with the recorded ones. Without valgrind they are skipped with a message.
pub(crate) fn instructions(options: &[String]) -> Done {
    if has("valgrind") || debian::install("valgrind") && has("valgrind") {
        // The work is that of the library, without the many crates of the program.
        cargo("build", &["build", "--release", "--package", "ancf-bench"], &[])?;
        return measure("instructions", options);
    }
    let why = "valgrind is missing and cannot be installed: instruction counts were NOT checked";
    if options.is_empty() {
        say(why);
        return Ok(());
    }
    Err(why.to_owned())
}

/// Runs EXUDYN and MuJoCo beside `ancf`, in a Python environment of their own.
pub(crate) fn peers(options: &[String]) -> Done {
    let scripts = root().join("bench/peers");
    let environment = Environment::at(&root().join("target/peers"))?;
    environment.install([Path::new("--requirement"), &scripts.join("requirements.txt")])?;
    build()?;
    let script = scripts.join("peers.py");
    let arguments: Vec<&OsStr> =
        [script.as_os_str()].into_iter().chain(options.iter().map(OsStr::new)).collect();
    alone(&environment.program("python"), &arguments)
}

/// Runs a program with one thread.
fn alone(program: &Path, arguments: &[&OsStr]) -> Done {
    let what = program.display().to_string();
    run(&what, Command::new(program).args(arguments).env("RAYON_NUM_THREADS", "1"))
}
