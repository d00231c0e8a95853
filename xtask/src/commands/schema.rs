//! Files generated from the model types.

use std::fs;
use std::process::Command;

use crate::documents::key_tables;
use crate::python;
use crate::system::shell::{Done, root};

/// Writes the JSON Schema of model files as the program prints it, and the Python classes and key tables generated
/// from it.
pub(crate) fn refresh() -> Done {
    let output = Command::new(env!("CARGO"))
        .args(["run", "--quiet", "--package", "ancf-cli", "--", "schema"])
        .output()
        .map_err(|error| format!("cannot run cargo: {error}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let path = root().join("docs/model.schema.json");
    fs::write(&path, &output.stdout).map_err(|error| format!("{}: {error}", path.display()))?;
    let schema = String::from_utf8_lossy(&output.stdout);
    python::write(&schema)?;
    key_tables::write(&schema)
}
