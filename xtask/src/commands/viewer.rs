//! The viewer of results: what a browser runs, and its tests in one.

use std::path::PathBuf;
use std::process::Command;

use crate::system::debian;
use crate::system::shell::{Done, cargo, root, run, say};

/// Names under which a Chromium may be found.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// Checks and tests the viewer: types, format, lints, the committed bundle, and reports in a browser.
pub(crate) fn test() -> Done {
    installed()?;
    npm("types and lints of the viewer", &["run", "--silent", "check"])?;
    if std::env::var_os("CHROMIUM").is_none()
        && !BROWSERS.iter().any(|name| debian::has(name))
        && !debian::install("chromium")
    {
        return Err("a Chromium is missing; install one, or name it in the variable CHROMIUM".to_owned());
    }
    cargo("program", &["build", "--workspace"], &[])?;
    npm("tests of the viewer", &["test", "--silent"])
}

/// Builds the bundle that the crate `ancf-report` embeds.
pub(crate) fn build() -> Done {
    installed()?;
    npm("viewer", &["run", "--silent", "build"])
}

fn installed() -> Done {
    if !debian::has("npm") && !debian::install("npm") {
        return Err("npm is missing; install Node 20 or later from https://nodejs.org".to_owned());
    }
    npm("packages of the viewer", &["ci", "--silent", "--no-fund", "--no-audit"])
}

fn npm(what: &str, arguments: &[&str]) -> Done {
    say(&format!("\n== {what}: npm {}", arguments.join(" ")));
    run(what, Command::new("npm").args(arguments).current_dir(folder()))
}

fn folder() -> PathBuf {
    root().join("viewer")
}
