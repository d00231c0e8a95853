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
    let tool = |arguments: &[&str], what: &Path, to: &str, folder: &Path| {
        let mut command = Command::new(environment.program("python"));
        command.args(["-m", "wheel"]).args(arguments).arg(what).arg(to).arg(folder);
        command.stdout(std::process::Stdio::null());
        run("wheel", &mut command)
    };
    tool(&["unpack"], &wheel, "--dest", &unpacked)?;
    let content = only_entry(&unpacked)?;
    add_program(&content, built)?;
    let packed = folder.join("dist");
    create_empty(&packed)?;
    tool(&["pack"], &content, "--dest-dir", &packed)?;
    only_entry(&packed)
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
        // Programs of the tests have large tables of symbols. Without `strip` the wheel is only larger.
        let _ = Command::new("strip").arg("--strip-debug").arg(&to).status();
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
