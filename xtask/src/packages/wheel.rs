//! Python wheel with the program inside.

use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::build::Built;
use super::release::{copy, create_empty};
use crate::system::environment::Environment;
use crate::system::shell::{Done, root, run, say};

/// Options of the build of the extension.
#[derive(Debug, Default)]
pub(crate) struct Options<'a> {
    /// Options of pip.
    pub(crate) settings: &'a [&'a str],
    /// Variables of cargo.
    pub(crate) variables: &'a [(&'static str, OsString)],
}

/// Builds the wheel of a folder of sources and adds the program. Returns its path.
///
/// Maturin builds the extension. Programs are data of a wheel: pip installs `scripts` beside Python, and `data` into the root of
/// the environment, where the program finds the library of FMUs in `lib`.
pub(crate) fn build(
    environment: &Environment,
    source: &Path,
    built: &Built,
    options: &Options<'_>,
    folder: &Path,
) -> Result<PathBuf, String> {
    let plain = folder.join("plain");
    create_empty(&plain)?;
    let mut command = Command::new(environment.program("python"));
    command.args([
        "-m",
        "pip",
        "wheel",
        "--quiet",
        "--disable-pip-version-check",
        "--no-deps",
        "--wheel-dir",
    ]);
    command.arg(&plain).args(options.settings).arg(source).envs(options.variables.iter().cloned());
    run("wheel", &mut command)?;
    let wheel = only_entry(&plain)?;
    environment.install(["wheel>=0.40"])?;
    let unpacked = folder.join("unpacked");
    create_empty(&unpacked)?;
    tool(environment, "unpack", &wheel, ["--dest".as_ref(), &unpacked])?;
    let content = only_entry(&unpacked)?;
    pack(environment, &content, built, folder)
}

/// Builds a wheel of the sources in the tree with an extension that is compiled already, and adds the program. Returns its path.
///
/// Maturin writes the metadata. The tests use it: the extension is the one of the other tests, without a further compilation.
pub(crate) fn assemble(
    environment: &Environment,
    extension: &Path,
    built: &Built,
    folder: &Path,
) -> Result<PathBuf, String> {
    environment.install(["maturin>=1.13,<2", "wheel>=0.40"])?;
    let metadata = folder.join("metadata");
    create_empty(&metadata)?;
    let mut command = Command::new(environment.program("maturin"));
    command.args(["pep517", "write-dist-info", "--metadata-directory"]).arg(&metadata).current_dir(root());
    command.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::null());
    run("metadata of the wheel", &mut command)?;
    let information = only_entry(&metadata)?;
    let name = information.file_stem().unwrap_or_default();
    let unpacked = folder.join("unpacked");
    create_empty(&unpacked)?;
    let content = unpacked.join(name);
    copy_folder(&information, &content.join(information.file_name().unwrap_or_default()))?;
    let package = content.join("ancf");
    copy_folder(&root().join("crates/ancf-py/python/ancf"), &package)?;
    let ending = if cfg!(windows) { "pyd" } else { "abi3.so" };
    let inside = package.join(format!("_ancf.{ending}"));
    copy(extension, &inside)?;
    strip(&inside);
    pack(environment, &content, built, folder)
}

/// Adds the program to an unpacked wheel and packs it. Returns its path.
fn pack(environment: &Environment, content: &Path, built: &Built, folder: &Path) -> Result<PathBuf, String> {
    add_program(content, built)?;
    let packed = folder.join("dist");
    create_empty(&packed)?;
    tool(environment, "pack", content, ["--dest-dir".as_ref(), &packed])?;
    only_entry(&packed)
}

/// Runs a command of the package `wheel`.
fn tool(environment: &Environment, command: &str, what: &Path, to: [&Path; 2]) -> Done {
    let mut process = Command::new(environment.program("python"));
    process.args(["-m", "wheel", command]).arg(what).args(to).stdout(std::process::Stdio::null());
    run("wheel", &mut process)
}

/// Copies a folder of sources without compiled files.
fn copy_folder(from: &Path, to: &Path) -> Done {
    let failed = |error: std::io::Error| format!("{}: {error}", from.display());
    for entry in fs::read_dir(from).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        let name = path.file_name().unwrap_or_default();
        if path.is_dir() && name != "__pycache__" {
            copy_folder(&path, &to.join(name))?;
        } else if path.is_file() && path.extension().is_none_or(|ending| ending != "so" && ending != "pyd") {
            copy(&path, &to.join(name))?;
        }
    }
    Ok(())
}

/// Removes the tables of symbols. Without `strip` the wheel is only larger.
fn strip(file: &Path) {
    let _ = Command::new("strip").arg("--strip-debug").arg(file).status();
}

/// Adds program and library to an unpacked wheel, without their symbols.
fn add_program(content: &Path, built: &Built) -> Done {
    let name = content.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let data = content.join(format!("{name}.data"));
    let is_windows = built.program.extension().is_some_and(|ending| ending == "exe");
    let libraries = data.join(if is_windows { "scripts" } else { "data/lib" });
    for (file, folder) in [(Some(&built.program), data.join("scripts")), (built.library.as_ref(), libraries)]
    {
        let Some(file) = file else { continue };
        let to = folder.join(file.file_name().unwrap_or_default());
        copy(file, &to)?;
        strip(&to);
    }
    Ok(())
}

/// Installs a wheel into an empty environment and uses it there: package, program, library of FMUs, types.
///
/// `checkers` is an environment with mypy and pyright.
pub(crate) fn test(wheel: &Path, checkers: &Environment, folder: &Path) -> Done {
    say(&format!("\n== empty environment: {}", wheel.display()));
    let empty = folder.join("empty");
    create_empty(&empty)?;
    let environment = Environment::at(&empty.join("environment"))?;
    environment.install([wheel])?;
    let tests = root().join("crates/ancf-py/tests/wheel");
    let python = environment.program("python");
    let mut command = Command::new(&python);
    command.args(["-I"]).arg(tests.join("installed.py")).current_dir(&empty);
    command.env("MPLBACKEND", "Agg").env_remove("PYTHONPATH").env_remove("VIRTUAL_ENV");
    run("installed wheel", &mut command)?;
    let typed = empty.join("typed.py");
    copy(&tests.join("typed.py"), &typed)?;
    let stubs = root().join("crates/ancf-py/python/ancf/_ancf.pyi");
    let python = python.display().to_string();
    let mypy = ["--strict", "--config-file=", "--python-executable", &python];
    let pyright = ["--pythonpath", &python, &stubs.display().to_string()];
    for (program, options) in [("mypy", &mypy[..]), ("pyright", &pyright[..])] {
        let mut command = Command::new(checkers.program(program));
        command.args(options).arg("typed.py").current_dir(&empty);
        run(&format!("types of the installed wheel: {program}"), &mut command)?;
    }
    Ok(())
}

/// Returns the only entry of a folder.
fn only_entry(folder: &Path) -> Result<PathBuf, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let entries: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    match &entries[..] {
        [entry] => Ok(entry.clone()),
        others => Err(format!("{} has {} entries, expected one", folder.display(), others.len())),
    }
}
