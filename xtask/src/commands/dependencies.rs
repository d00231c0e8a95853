//! Dependencies: licences, sources, known vulnerabilities, lock files.

use std::process::Command;

use crate::system::shell::{Done, root, run, say};
use crate::system::tools::Tool;

const DENY: Tool = Tool { name: "cargo-deny", version: "0.20.2" };

/// Message of cargo-deny if the database of vulnerabilities cannot be reached.
const UNREACHABLE: &str = "failed to fetch advisory database";

/// Checks that the lock files agree with the manifests.
pub(crate) fn locked() -> Done {
    for manifest in ["Cargo.toml", "fuzz/Cargo.toml"] {
        let mut command = Command::new(env!("CARGO"));
        command
            .args(["metadata", "--locked", "--format-version", "1", "--manifest-path"])
            .arg(root().join(manifest));
        let output = command.output().map_err(|error| format!("cannot run cargo: {error}"))?;
        if !output.status.success() {
            let why = String::from_utf8_lossy(&output.stderr).into_owned();
            return Err(format!(
                "the lock file of {manifest} is stale, or its crates cannot be downloaded:\n{why}"
            ));
        }
    }
    Ok(())
}

/// Checks licences, bans and sources by `deny.toml`, and known vulnerabilities if their database can be reached.
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
    let message = String::from_utf8_lossy(&advisories.stderr);
    if advisories.status.success() {
        say("no known vulnerabilities");
        return Ok(());
    }
    if message.contains(UNREACHABLE) {
        say("known vulnerabilities were NOT checked: the RustSec database cannot be reached");
        return Ok(());
    }
    Err(format!("known vulnerabilities:\n{message}"))
}
