//! All tests of the workspace.

use std::process::Command;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::release::container;
use super::{benchmark, dependencies, importers, package, playground, viewer};
use crate::layers;
use crate::packages::crates;
use crate::system::shell::{Done, cargo, say, side_by_side};

/// Runs all tests, the quick checks first, and prints the time of each part. Stops at the first failure.
pub(crate) fn all() -> Done {
    let timer = PartTimer::new();
    let done = parts(&timer);
    timer.print();
    done?;
    say("all tests passed");
    Ok(())
}

fn parts(timer: &PartTimer) -> Done {
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
    let debug = || {
        timer.run("tests", || cargo("tests", &["test", "--workspace"], &[]))?;
        let documentation = ["doc", "--workspace", "--no-deps"];
        timer.run("documentation", || {
            cargo("documentation", &documentation, &[("RUSTDOCFLAGS", "-D warnings")])
        })
    };
    // Counting instructions and linking the module occupy one core each, with programs of another profile.
    let release = || {
        timer.run("instruction counts", || benchmark::instructions(&[]))?;
        timer.run("dependencies", dependencies::deny)?;
        timer.run("playground", playground::build)
    };
    side_by_side(debug, release)?;
    timer.run("viewer", viewer::test)?;
    timer.run("Python", package::test)?;
    timer.run("FMI", importers::test)
}

/// Wall-clock times of the parts of the tests. Parts may overlap.
struct PartTimer {
    start: Instant,
    parts: Mutex<Vec<(&'static str, Duration)>>,
}

impl PartTimer {
    fn new() -> Self {
        Self { start: Instant::now(), parts: Mutex::default() }
    }

    /// Runs a part and records its time, also if it fails.
    fn run(&self, name: &'static str, part: impl FnOnce() -> Done) -> Done {
        let start = Instant::now();
        let done = part();
        self.parts().push((name, start.elapsed()));
        done
    }

    fn parts(&self) -> MutexGuard<'_, Vec<(&'static str, Duration)>> {
        self.parts.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Prints the time of each part, and of all since the start.
    fn print(&self) {
        say("\n== time of each part");
        for (name, time) in self.parts().iter().chain([&("all", self.start.elapsed())]) {
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
