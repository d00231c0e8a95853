//! FMUs in importers of others.

use std::env::consts::{DLL_PREFIX, DLL_SUFFIX, EXE_SUFFIX};
use std::process::Command;

use crate::system::debian;
use crate::system::environment::Environment;
use crate::system::shell::{Done, cargo, root, run, say};

/// Importers from PyPI.
const IMPORTERS: [&str; 3] = ["fmpy==0.3.32", "ecospy==0.7.2", "libcosimpy==0.0.6"];

/// Validates FMUs and compares runs in importers with those of the library.
pub(crate) fn test() -> Done {
    // Same packages as the other tests, so that nothing is compiled again.
    cargo("program and libraries", &["test", "--workspace", "--no-run", "--quiet"], &[])?;
    if cfg!(target_os = "linux") && !debian::has_library("libtbb.so.12") {
        // Library of Ecos. The tests fail if it cannot be installed.
        let _ = debian::install("libtbb12");
    }
    let environment = Environment::at(&root().join("target/python"))?;
    environment.install(IMPORTERS.into_iter().chain(["pytest>=8"]))?;
    let built = root().join("target/debug");
    let tests = root().join("crates/ancf-fmu/tests");
    say("\n== FMUs in importers: pytest crates/ancf-fmu/tests");
    let mut command = Command::new(environment.program("pytest"));
    command.arg("--quiet").arg("-c").arg(tests.join("pytest.ini")).arg(&tests).current_dir(root());
    command.env("ANCF", built.join(format!("ancf{EXE_SUFFIX}")));
    command.env("ANCF_C_LIBRARY", built.join("deps").join(format!("{DLL_PREFIX}ancf_c{DLL_SUFFIX}")));
    run("FMUs in importers", &mut command)
}
