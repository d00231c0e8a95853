//! Files generated from the model types.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

use crate::documents::key_tables;
use crate::python;
use crate::system::shell::{Done, cargo, root};

/// Writes the JSON Schema of model files as the program prints it, and the Python classes and key tables generated
/// from it.
pub(crate) fn refresh() -> Done {
    // Same packages as the tests: `cargo run` would compile the library with other features of its dependencies.
    cargo("program", &["test", "--workspace", "--no-run", "--quiet"], &[])?;
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let program = target.join("debug").join(format!("ancf{}", env::consts::EXE_SUFFIX));
    let output = Command::new(&program)
        .arg("schema")
        .output()
        .map_err(|error| format!("cannot run {}: {error}", program.display()))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let path = root().join("docs/model.schema.json");
    fs::write(&path, &output.stdout).map_err(|error| format!("{}: {error}", path.display()))?;
    let schema = String::from_utf8_lossy(&output.stdout);
    python::write(&schema)?;
    key_tables::write(&schema)
}
