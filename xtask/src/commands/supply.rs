//! What the workspace takes in from others: licences, sources, known weaknesses, the lock file.

use std::process::Command;

use crate::system::shell::{Done, root, run, say};
use crate::system::tools::Tool;

const DENY: Tool = Tool { name: "cargo-deny", version: "0.20.2" };

/// What cargo-deny says where it cannot get at the database of weaknesses.
const UNREACHABLE: &str = "failed to fetch advisory database";

/// The lock file is that of the manifests: all that follows builds what it says.
pub(crate) fn locked() -> Done {
    for manifest in ["Cargo.toml", "fuzz/Cargo.toml"] {
        let mut command = Command::new(env!("CARGO"));
        command
            .args(["metadata", "--locked", "--format-version", "1", "--manifest-path"])
            .arg(root().join(manifest));
        let output = command.output().map_err(|error| format!("cannot run cargo: {error}"))?;
        if !output.status.success() {
            let why = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(format!("the lock file of {manifest} is stale, or its crates cannot be had:\n{why}"));
        }
    }
    Ok(())
}

/// Checks licences, bans and sources by `deny.toml`, and known weaknesses if their database can be reached.
pub(crate) fn deny() -> Done {
    let program = DENY.program()?;
    let check = |what: &[&str]| {
        let mut command = Command::new(&program);
        command.current_dir(root()).args(["--locked", "check", "--hide-inclusion-graph"]).args(what);
        command
    };
    say("\n== dependencies: cargo deny check licenses bans sources");
    run("dependencies", &mut check(&["licenses", "bans", "sources"]))?;
    let advisories =
        check(&["advisories"]).output().map_err(|error| format!("cannot run cargo-deny: {error}"))?;
    let said = String::from_utf8_lossy(&advisories.stderr);
    if advisories.status.success() {
        say("no known weaknesses");
        return Ok(());
    }
    if said.contains(UNREACHABLE) {
        say("known weaknesses were NOT checked: the database of RustSec cannot be reached");
        return Ok(());
    }
    Err(format!("known weaknesses:\n{said}"))
}
