//! All tests of the workspace.

use std::process::Command;

use super::{benchmark, dependencies, package, viewer};
use crate::layers;
use crate::system::shell::{Done, cargo, say};

/// Runs all tests, the quick checks first. Stops at the first failure.
pub(crate) fn all() -> Done {
    component("fmt", "rustfmt")?;
    component("clippy", "clippy")?;
    dependencies::locked()?;
    cargo("format", &["fmt", "--all", "--check"], &[])?;
    say("\n== layers");
    layers::check(&[])?;
    cargo("lints", &["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"], &[])?;
    cargo("tests", &["test", "--workspace"], &[])?;
    let doc = ["doc", "--workspace", "--no-deps"];
    cargo("documentation", &doc, &[("RUSTDOCFLAGS", "-D warnings")])?;
    benchmark::instructions(&[])?;
    dependencies::deny()?;
    viewer::test()?;
    package::test()?;
    say("all tests passed");
    Ok(())
}

/// Installs a component of the toolchain if it is missing.
fn component(subcommand: &str, name: &str) -> Done {
    let installed = Command::new(env!("CARGO")).args([subcommand, "--version"]).output();
    if installed.is_ok_and(|output| output.status.success()) {
        return Ok(());
    }
    let install = Command::new("rustup").args(["component", "add", name]).status();
    match install {
        Ok(status) if status.success() => Ok(()),
        _ => Err(format!("`cargo {subcommand}` is missing; run: rustup component add {name}")),
    }
}
