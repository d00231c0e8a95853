//! Installation, checks and tests of the Python package.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::packages::build::Built;
use crate::packages::wheel;
use crate::system::debian;
use crate::system::environment::Environment;
use crate::system::shell::{Done, cargo, root, run, say, side_by_side};

/// Installs the wheel with the dependencies of its tests and documentation, runs both, and tries the wheel in an empty
/// environment.
pub(crate) fn test() -> Done {
    let environment = environment()?;
    let wheel = packed(&environment)?;
    // The version may be installed already, from another state of the sources.
    environment.install([Path::new("--force-reinstall"), Path::new("--no-deps"), &wheel])?;
    environment.install([format!("{}[test,docs]", wheel.display())])?;
    let quick: [(&str, &str, &[&str]); 4] = [
        ("format of Python", "ruff", &["format", "--check", "--quiet", "."]),
        ("lints of Python", "ruff", &["check", "--quiet", "."]),
        ("types", "mypy", &["crates/ancf-py/python/ancf", "crates/ancf-py/tests"]),
        ("stubs", "stubtest", &["ancf._ancf", "--mypy-config-file", "pyproject.toml"]),
    ];
    quick.iter().try_for_each(|(what, program, arguments)| step(&environment, what, program, arguments))?;
    // The site and the installation of the wheel use one core.
    let site = || {
        let arguments = ["-E", "-W", "--keep-going", "--quiet", "docs", "target/site"];
        step(&environment, "site", "sphinx-build", &arguments)?;
        wheel::test(&wheel, &environment, &folder())
    };
    let tests = ["--quiet", "--numprocesses", "auto", "--dist", "loadfile"];
    side_by_side(|| step(&environment, "tests of Python", "pytest", &tests), site)
}

/// Builds the wheel with an optimised extension and the program of the tests inside, and tries it in an empty environment.
pub(crate) fn wheel() -> Done {
    let environment = environment()?;
    let (built, _) = compiled()?;
    say("\n== wheel");
    let wheel = wheel::build(&environment, &root(), &built, &wheel::Options::default(), &folder())?;
    environment.install(["mypy>=1.11", "pyright[nodejs]>=1.1.390"])?;
    wheel::test(&wheel, &environment, &folder())
}

/// Folder of the wheel.
fn folder() -> PathBuf {
    root().join("target/wheel")
}

/// Builds the program of the tests, the library of FMUs and the extension.
fn compiled() -> Result<(Built, PathBuf), String> {
    // Same packages as the tests of the documentation: nothing is compiled twice.
    cargo("program", &["build", "--quiet", "--workspace", "--lib", "--bins", "--examples"], &[])?;
    let built = root().join("target/debug");
    let library = built.join("deps").join(format!("{DLL_PREFIX}ancf_fmu{DLL_SUFFIX}"));
    let extension = built.join(format!("{DLL_PREFIX}_ancf{DLL_SUFFIX}"));
    Ok((Built { program: built.join(format!("ancf{EXE_SUFFIX}")), library: Some(library) }, extension))
}

/// Builds the wheel of the tests, with the program and the extension of the development profile, and returns its path.
fn packed(environment: &Environment) -> Result<PathBuf, String> {
    let (built, extension) = compiled()?;
    say("\n== wheel");
    wheel::assemble(environment, &extension, &built, &folder())
}

/// Builds the documentation site into `target/site`.
pub(crate) fn docs() -> Done {
    let environment = environment()?;
    // Pages run the program and export FMUs.
    let wheel = packed(&environment)?;
    environment.install([Path::new("--force-reinstall"), Path::new("--no-deps"), &wheel])?;
    environment.install([format!("{}[test,docs]", wheel.display())])?;
    step(&environment, "site", "sphinx-build", &["-E", "-W", "--keep-going", "docs", "target/site"])?;
    say("the site is in target/site/index.html");
    Ok(())
}

/// Opens the environment of the tests.
fn environment() -> Result<Environment, String> {
    if cfg!(target_os = "linux") && !debian::has_library("libEGL.so.1") {
        // Libraries for drawing without a screen. The tests of scenes fail if they cannot be installed.
        let _ = ["libegl1", "libgl1-mesa-dri"].iter().all(|package| debian::install(package));
    }
    Environment::at(&root().join("target/python"))
}

fn step(environment: &Environment, what: &str, program: &str, arguments: &[&str]) -> Done {
    say(&format!("\n== {what}: {program} {}", arguments.join(" ")));
    let mut command = Command::new(environment.program(program));
    command.args(arguments).current_dir(root());
    // Plots are drawn without a screen.
    command.env("MPLBACKEND", "Agg").env("PYVISTA_OFF_SCREEN", "true");
    if cfg!(target_os = "linux") {
        command.env("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow");
    }
    run(what, &mut command)
}
