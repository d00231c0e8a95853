//! Bill of materials of the program in the form of CycloneDX.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use super::release::{Release, copy};
use crate::system::shell::{Done, run, say};
use crate::system::tools::Tool;

const CYCLONEDX: Tool = Tool { name: "cargo-cyclonedx", version: "0.5.9" };

/// Writes the bill of materials of the program: all crates with versions, licences and check sums.
pub(crate) fn write(release: &Release, source: &Path, target: &str) -> Done {
    let program = CYCLONEDX.program()?;
    let name = format!("{}-{target}.cdx", release.name());
    let mut command = Command::new(program);
    command.args(["cyclonedx", "--format", "json", "--target", target, "--override-filename", &name]);
    command.arg("--manifest-path").arg(source.join("crates/ancf-cli/Cargo.toml"));
    run("bill of materials", command.arg("--quiet"))?;
    let file = format!("{name}.json");
    copy(&source.join("crates/ancf-cli").join(&file), &release.packages.join(&file))?;
    check(release, &release.packages.join(file))
}

/// Checks that the bill names the crates that do the work.
fn check(release: &Release, file: &Path) -> Done {
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let bill: Value = serde_json::from_str(&text).map_err(|error| format!("{}: {error}", file.display()))?;
    let components = bill["components"].as_array().map(Vec::as_slice).unwrap_or_default();
    let has = |name: &str, version: Option<&str>| {
        components.iter().any(|component| {
            component["name"] == name && version.is_none_or(|version| component["version"] == version)
        })
    };
    for (name, version) in
        [("ancf", Some(&*release.version)), ("faer", None), ("parquet", None), ("hyper", None)]
    {
        if !has(name, version) {
            return Err(format!("{} does not list {name}", file.display()));
        }
    }
    let unlicensed = components.iter().filter(|component| component["licenses"].is_null());
    let unlicensed: Vec<_> = unlicensed.filter_map(|component| component["name"].as_str()).collect();
    if !unlicensed.is_empty() {
        return Err(format!("no licence is stated for {}", unlicensed.join(", ")));
    }
    say(&format!("{} components", components.len()));
    Ok(())
}
