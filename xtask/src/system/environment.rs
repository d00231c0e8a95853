//! Virtual environments of Python.

use std::env;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::system::debian;
use crate::system::shell::{Done, run};

/// Virtual environment in a folder of its own.
#[derive(Debug)]
pub(crate) struct Environment {
    folder: PathBuf,
}

impl Environment {
    /// Opens the environment in a folder. If it does not exist, it is made by `python3` or by the interpreter in the
    /// variable `PYTHON`.
    pub(crate) fn at(folder: &Path) -> Result<Self, String> {
        let environment = Self { folder: folder.to_owned() };
        if !environment.program("python").exists() {
            let system = env::var_os("PYTHON").map_or_else(|| PathBuf::from("python3"), PathBuf::from);
            let make = || {
                let mut command = Command::new(&system);
                run("environment of Python", command.args(["-m", "venv"]).arg(folder))
            };
            // Debian packages the `venv` module separately.
            make().or_else(|why| debian::install("python3-venv").then(make).unwrap_or(Err(why)))?;
        }
        Ok(environment)
    }

    /// Returns the path of a program in the environment.
    pub(crate) fn program(&self, name: &str) -> PathBuf {
        let folder = self.folder.join(if cfg!(windows) { "Scripts" } else { "bin" });
        folder.join(format!("{name}{}", env::consts::EXE_SUFFIX))
    }

    /// Installs packages.
    pub(crate) fn install(&self, what: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Done {
        let mut command = Command::new(self.program("python"));
        command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]).args(what);
        run("packages of Python", command.env("PIP_NO_WARN_SCRIPT_LOCATION", "1"))
    }
}
