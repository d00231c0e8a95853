//! Runs that end early, and their continuation.

use std::process::{Command, Stdio};
use std::time::Duration;

use super::trial::{Ended, Trial, expect, finish, wait_for};
use crate::system::shell::Done;

/// Files that are bit-identical after any number of interruptions.
const FILES: [&str; 3] = ["results.parquet", "states.parquet", "probes.csv"];

/// Starts a program that is ended by the caller.
fn spawn(trial: &Trial<'_>, arguments: &[&str]) -> Result<std::process::Child, String> {
    let mut command = trial.program.command(&trial.folder, arguments);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().map_err(|error| error.to_string())
}

pub(super) fn kill_and_resume(trial: &Trial<'_>) -> Done {
    trial.cantilever("lang.toml", 20.0)?;
    trial.done(&["run", "lang.toml", "-o", "ganz", "--checkpoint", "100"])?;
    let mut run = spawn(trial, &["run", "lang.toml", "-o", "Stücke", "--checkpoint", "100"])?;
    let written = wait_for(&trial.path("Stücke/checkpoint"));
    let killed = run.kill().and_then(|()| run.wait());
    written?;
    expect(killed.is_ok_and(|status| !status.success()), "a killed run", "a finished run")?;
    trial.done(&["plot", "Stücke", "tip.y"])?;
    resumed_equals(trial, "Stücke")
}

/// Resumes a run and compares its files with those of the uninterrupted run.
fn resumed_equals(trial: &Trial<'_>, run: &str) -> Done {
    trial.done(&["resume", run, "--checkpoint", "100"])?;
    for file in FILES {
        let [whole, pieces] = ["ganz", run].map(|run| trial.read(&format!("{run}/{file}")));
        expect(whole? == pieces?, "equal bits", file)?;
    }
    Ok(())
}

pub(super) fn ctrl_c(trial: &Trial<'_>) -> Done {
    let arguments = ["run", "lang.toml", "-o", "Halt", "--checkpoint", "100"];
    let file = "Halt/checkpoint";
    let ended = match trial.program.by_console(&trial.folder, "stop", file, &arguments) {
        Some(command) => finish(command)?,
        None => interrupted(trial, &arguments, file)?,
    };
    expect(ended.code == Some(130), "exit code 130", &ended)?;
    let summary = trial.text("Halt/summary.json")?;
    expect(summary.contains("stopped"), "the outcome `stopped`", summary)?;
    resumed_equals(trial, "Halt")
}

fn interrupted(trial: &Trial<'_>, arguments: &[&str], file: &str) -> Result<Ended, String> {
    let mut run = spawn(trial, arguments)?;
    let written = wait_for(&trial.path(file));
    let _ = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    let status = run.wait().map_err(|error| error.to_string())?;
    written?;
    Ok(Ended { code: status.code(), stdout: String::new(), stderr: String::new() })
}

/// Plots a run that continues. Its first rows are written after a second.
fn plot_of_running(trial: &Trial<'_>) -> Result<Ended, String> {
    for _ in 0..20 {
        let plotted = trial.ancf(&["plot", "belegt", "tip.y"])?;
        if plotted.code == Some(0) {
            return Ok(plotted);
        }
        std::thread::sleep(Duration::from_millis(500));
    }
    trial.ancf(&["plot", "belegt", "tip.y"])
}

/// Two runs do not write into one folder at a time.
pub(super) fn folder_in_use(trial: &Trial<'_>) -> Done {
    trial.cantilever("sehr lang.toml", 4000.0)?;
    let mut run = spawn(trial, &["run", "sehr lang.toml", "-o", "belegt"])?;
    let written = wait_for(&trial.path("belegt/probes.csv"));
    std::thread::sleep(Duration::from_millis(200));
    let second = trial.ancf(&["run", "sehr lang.toml", "-o", "belegt"]);
    let plotted = plot_of_running(trial);
    let _ = run.kill().and_then(|()| run.wait());
    written?;
    let second = second?;
    expect(second.code != Some(0) && second.stderr.contains("belegt"), "a rejection", &second)?;
    expect(plotted.as_ref().is_ok_and(|ended| ended.code == Some(0)), "a plot during the run", plotted)
}
