//! The viewer of results: build, checks and browser tests.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::system::debian;
use crate::system::shell::{Done, cargo, root, run, say};

/// Program names of Chromium.
const BROWSERS: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];

/// Checks and tests the viewer: types, format, lints, the committed bundle, and reports in a browser.
pub(crate) fn test() -> Done {
    installed()?;
    npm("types and lints of the viewer", &["run", "--silent", "check"])?;
    browser()?;
    // `cargo build` has other features of the dependencies and would build them again.
    cargo("program", &["test", "--workspace", "--no-run"], &[])?;
    npm("tests of the viewer", &["test", "--silent"])
}

/// Installs Chromium, unless there is a browser.
pub(crate) fn browser() -> Done {
    if std::env::var_os("CHROMIUM").is_none()
        && !BROWSERS.iter().any(|name| debian::has(name))
        && !debian::install("chromium")
    {
        return Err("Chromium is missing; install it, or set the variable CHROMIUM to its path".to_owned());
    }
    Ok(())
}

/// Builds the bundle that the crate `ancf-report` embeds.
pub(crate) fn build() -> Done {
    installed()?;
    npm("viewer", &["run", "--silent", "build"])
}

/// Builds the page of the playground into a folder, from the files of wasm-bindgen.
pub(crate) fn playground(out: &Path, bindings: &Path) -> Done {
    installed()?;
    let [out, bindings] = [out, bindings].map(|path| path.display().to_string());
    npm("playground", &["run", "--silent", "playground", "--", &out, &bindings])
}

/// Installs npm and the packages of the viewer, once in a run.
fn installed() -> Done {
    static DONE: OnceLock<Done> = OnceLock::new();
    DONE.get_or_init(install).clone()
}

fn install() -> Done {
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
