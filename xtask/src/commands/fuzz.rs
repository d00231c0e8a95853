//! Fuzzing: random bytes for the readers of the library.

use std::process::Command;

use crate::system::shell::{Done, root, run, say};
use crate::system::tools::Tool;

const FUZZ: Tool = Tool { name: "cargo-fuzz", version: "0.13.2" };

/// Default duration of each target in seconds.
const SECONDS: &str = "600";

/// Runs all targets one after the other, each for the given seconds. New inputs are kept in `fuzz/corpus`.
pub(crate) fn fuzz(options: &[String]) -> Done {
    let seconds = options.first().map_or(SECONDS, String::as_str);
    seconds.parse::<u32>().map_err(|_| format!("`{seconds}` is not a whole number of seconds"))?;
    let program = FUZZ.program()?;
    let command = |arguments: &[&str]| {
        let mut command = Command::new(&program);
        // libFuzzer needs compiler flags that a stable compiler accepts with this variable only. The code is safe Rust:
        // no sanitizer.
        command.current_dir(root()).env("RUSTC_BOOTSTRAP", "1").args(arguments);
        command
    };
    let targets = command(&["list"]).output().map_err(|error| format!("cannot run cargo-fuzz: {error}"))?;
    if !targets.status.success() {
        return Err(String::from_utf8_lossy(&targets.stderr).into_owned());
    }
    for target in String::from_utf8_lossy(&targets.stdout).lines() {
        say(&format!("\n== fuzzing: {target}, {seconds} s"));
        let mut fuzz = command(&["run", "--sanitizer", "none", "--target-dir", "target/fuzz", target, "--"]);
        fuzz.arg(format!("-max_total_time={seconds}")).args([
            "-timeout=20",
            "-rss_limit_mb=3000",
            "-max_len=6000",
        ]);
        let words = root().join(format!("fuzz/{target}.dict"));
        if words.exists() {
            fuzz.arg(format!("-dict={}", words.display()));
        }
        run(target, &mut fuzz)?;
    }
    Ok(())
}
