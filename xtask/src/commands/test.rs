//! All tests of the workspace.

use std::process::Command;
use std::time::{Duration, Instant};

use super::release::container;
use super::{benchmark, dependencies, importers, package, playground, viewer};
use crate::layers;
use crate::packages::crates;
use crate::system::shell::{Done, cargo, say};

/// Runs all tests, the quick checks first, and prints the time of each part. Stops at the first failure.
pub(crate) fn all() -> Done {
    let mut timer = PartTimer::default();
    let done = parts(&mut timer);
    timer.print();
    done?;
    say("all tests passed");
    Ok(())
}

fn parts(timer: &mut PartTimer) -> Done {
    component("fmt", "rustfmt")?;
    component("clippy", "clippy")?;
    timer.run("lock files", dependencies::locked)?;
    timer.run("format", || cargo("format", &["fmt", "--all", "--check"], &[]))?;
    say("\n== layers");
    timer.run("layers", || layers::check(&[]))?;
    timer.run("manifests", || crates::check_manifests().and_then(|()| container::check()))?;
    let lints = ["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"];
    timer.run("lints", || cargo("lints", &lints, &[]))?;
    timer.run("test programs", || cargo("test programs", &["test", "--workspace", "--no-run"], &[]))?;
    timer.run("tests", || cargo("tests", &["test", "--workspace"], &[]))?;
    let documentation = ["doc", "--workspace", "--no-deps"];
    let warnings = [("RUSTDOCFLAGS", "-D warnings")];
    timer.run("documentation", || cargo("documentation", &documentation, &warnings))?;
    timer.run("instruction counts", || benchmark::instructions(&[]))?;
    timer.run("dependencies", dependencies::deny)?;
    timer.run("playground", playground::build)?;
    timer.run("viewer", viewer::test)?;
    timer.run("Python", package::test)?;
    timer.run("FMI", importers::test)
}

/// Wall-clock time of each part of the tests.
#[derive(Default)]
struct PartTimer(Vec<(&'static str, Duration)>);

impl PartTimer {
    /// Runs a part and records its time, also if it fails.
    fn run(&mut self, name: &'static str, part: impl FnOnce() -> Done) -> Done {
        let start = Instant::now();
        let done = part();
        self.0.push((name, start.elapsed()));
        done
    }

    /// Prints the time of each part and their sum.
    fn print(&self) {
        say("\n== time of each part");
        let sum = self.0.iter().map(|(_, time)| *time).sum();
        for (name, time) in self.0.iter().chain([&("sum", sum)]) {
            say(&format!("{:7.0} s  {name}", time.as_secs_f64()));
        }
    }
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
