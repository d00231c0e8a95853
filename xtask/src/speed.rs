//! What measures speed.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Done, cargo, say};

/// Builds what measures and runs it with one thread; by its path, since `cargo run` would build it alone.
fn measure(chore: &str, options: &[String]) -> Done {
    build()?;
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let program = target.join("release").join(format!("ancf-bench{}", env::consts::EXE_SUFFIX));
    let arguments: Vec<&OsStr> =
        [chore].into_iter().chain(options.iter().map(String::as_str)).map(OsStr::new).collect();
    run(&program, &arguments)
}

/// What measures and the program `ancf`, together: alone, either has other features of its dependencies, and builds them all anew.
fn build() -> Done {
    cargo("build", &["build", "--release", "--package", "ancf-cli", "--package", "ancf-bench"], &[])
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Times beside their goals.
pub(crate) fn bench(options: &[String]) -> Done {
    measure("table", options)
}

/// Counts of instructions; without valgrind they are left out, and that is said.
pub(crate) fn instructions(options: &[String]) -> Done {
    if !has("valgrind") {
        install_valgrind();
    }
    if has("valgrind") {
        return measure("instructions", options);
    }
    let why = "valgrind is missing and cannot be installed: instructions are NOT counted";
    if options.is_empty() {
        say(why);
        return Ok(());
    }
    Err(why.to_owned())
}

fn has(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// By the package manager of Debian and its kin, as root or without a password.
fn install_valgrind() {
    let run = |program: &str, arguments: &[&str]| {
        say(&format!("\n== valgrind: {program} {}", arguments.join(" ")));
        let command = Command::new(program).args(arguments).env("DEBIAN_FRONTEND", "noninteractive").status();
        command.is_ok_and(|status| status.success())
    };
    let install = ["apt-get", "install", "--yes", "valgrind"];
    let by_sudo = [&["-n"][..], &install].concat();
    // Whether it worked is seen by whether it is there.
    let _ = has("apt-get") && (run(install[0], &install[1..]) || has("sudo") && run("sudo", &by_sudo));
}

/// EXUDYN beside `ancf`, in an environment of its own.
pub(crate) fn peers() -> Done {
    let root = root();
    let (scripts, environment) = (root.join("bench/peers"), root.join("target/peers"));
    let python = environment.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    if !python.exists() {
        let system = env::var_os("PYTHON").map_or_else(|| PathBuf::from("python3"), PathBuf::from);
        run(&system, &["-m".as_ref(), "venv".as_ref(), environment.as_os_str()])?;
    }
    let requirements = scripts.join("requirements.txt");
    let install = ["-m", "pip", "install", "--quiet", "--requirement"].map(OsStr::new);
    run(&python, &[&install[..], &[requirements.as_os_str()]].concat())?;
    build()?;
    run(&python, &[scripts.join("peers.py").as_os_str()])
}

fn run(program: &Path, arguments: &[&OsStr]) -> Done {
    let status = Command::new(program).args(arguments).env("RAYON_NUM_THREADS", "1").status();
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{}: {status}", program.display())),
        Err(error) => Err(format!("cannot run {}: {error}", program.display())),
    }
}
