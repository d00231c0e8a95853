//! Public items of the libraries, beside a listing in the repository.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::system::shell::{Done, root, run, say};

/// Libraries whose items other programs name. Crates of commands have no promise of stability.
const LIBRARIES: [&str; 5] = ["ancf", "ancf-mechanics", "ancf-solver", "ancf-results", "ancf-study"];

/// Compares the public items with the listings in `xtask/interface`, or records them by `--update`.
pub(crate) fn check(options: &[String]) -> Done {
    let update = match options {
        [] => false,
        [option] if option == "--update" => true,
        other => return Err(format!("expected --update, found {}", other.join(" "))),
    };
    if !cfg!(unix) {
        say("public items were NOT checked: the description of items requires a shell script");
        return Ok(());
    }
    let rustdoc = rustdoc()?;
    let mut changed = Vec::new();
    for library in LIBRARIES {
        let file = root().join(format!("xtask/interface/{library}.txt"));
        if !update && !file.exists() {
            say(&format!("{library} was NOT checked: no listing is recorded"));
            continue;
        }
        let now = items(library, &rustdoc)?;
        let recorded = fs::read_to_string(&file).unwrap_or_default();
        if update {
            super::release::create(file.parent().unwrap_or(&file))?;
            fs::write(&file, &now).map_err(|error| format!("{}: {error}", file.display()))?;
        } else if now != recorded {
            changed.push(difference(library, &recorded, &now));
        }
        say(&format!("{:5} public items  {library}", now.lines().count()));
    }
    match changed.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "public items changed:\n{}\nIf this is intended, run `cargo xtask interface --update` and note it in CHANGELOG.md",
            changed.join("\n")
        )),
    }
}

/// Items of a library, one a line, without those of derived traits.
fn items(library: &str, rustdoc: &Path) -> Result<String, String> {
    let mut command = Command::new(env!("CARGO"));
    command.args([
        "rustdoc",
        "--quiet",
        "--locked",
        "--package",
        library,
        "--lib",
        "--",
        "--output-format",
        "json",
    ]);
    command.args(["-Z", "unstable-options"]);
    command.env("RUSTDOC", rustdoc).current_dir(root());
    run(&format!("items of {library}"), &mut command)?;
    let target = env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let file = target.join("doc").join(format!("{}.json", library.replace('-', "_")));
    let mut command = Command::new(env!("CARGO"));
    command.args([
        "run",
        "--quiet",
        "--package",
        "xtask",
        "--features",
        "interface",
        "--example",
        "interface",
        "--",
    ]);
    let output = command.arg(file).current_dir(root()).output();
    let output = output.map_err(|error| format!("cannot run cargo: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(String::from_utf8_lossy(&output.stderr).into_owned()),
    }
}

/// Writes a script that lets the stable rustdoc describe items in JSON. The variable must not reach the compiler: crates would
/// be compiled again.
fn rustdoc() -> Result<PathBuf, String> {
    let script = root().join("target/interface/rustdoc");
    super::release::create(script.parent().unwrap_or(&script))?;
    let text = "#!/bin/sh\nRUSTC_BOOTSTRAP=1 exec rustdoc \"$@\"\n";
    fs::write(&script, text).map_err(|error| format!("{}: {error}", script.display()))?;
    run("rustdoc", Command::new("chmod").arg("+x").arg(&script))?;
    Ok(script)
}

/// Lines that were removed and added.
fn difference(library: &str, before: &str, after: &str) -> String {
    let missing = |from: &str, other: &str, sign: char| {
        let other: std::collections::BTreeSet<_> = other.lines().collect();
        let lines: Vec<_> =
            from.lines().filter(|line| !other.contains(line)).map(|line| format!("{sign} {line}")).collect();
        lines
    };
    let lines = [missing(before, after, '-'), missing(after, before, '+')].concat();
    format!("{library}\n{}", lines.join("\n"))
}
