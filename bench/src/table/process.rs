//! Measurements in separate processes: memory, threads, and the program `ancf`.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::Result;
use crate::measure::{clock, median};
use crate::subjects::{CantileverKind, Plant, step};

/// Cost of a number of steps of a beam.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct StepCost {
    /// CPU time per element and step, summed over all threads, in seconds.
    pub processor: f64,
    /// Wall-clock time per element and step in seconds.
    pub wall: f64,
    /// Newton iterations per step.
    pub iterations: f64,
    /// Maximum resident memory of the process in bytes.
    pub memory: f64,
}

/// Measures steps of a beam in a separate process.
///
/// # Errors
/// If the process fails.
pub fn step_cost(elements: u32, steps: u32, threads: usize) -> Result<StepCost> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new(own)
        .args(["steps", &elements.to_string(), &steps.to_string()])
        .env("RAYON_NUM_THREADS", threads.to_string())
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("{elements} elements: {}", output.status));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())
}

/// Measures steps of a beam in this process.
///
/// # Errors
/// If a step fails.
pub fn step_cost_here(elements: u32, steps: u32) -> Result<StepCost> {
    let plant = Plant::new(CantileverKind::Beam, elements)?;
    let mut motion = plant.motion()?;
    // The first step is not measured, because memory is touched for the first time.
    step(&mut motion)?;
    let (start, wall, mut iterations) = (clock::own(), Instant::now(), 0);
    for _ in 0..steps {
        iterations += step(&mut motion)?.iterations;
    }
    let count = f64::from(elements) * f64::from(steps);
    Ok(StepCost {
        processor: (clock::own() - start) / count,
        wall: wall.elapsed().as_secs_f64() / count,
        iterations: f64::from(iterations) / f64::from(steps),
        memory: kilobytes("/proc/self/status", "VmHWM:"),
    })
}

/// Available memory in bytes; NaN if the system does not report it.
pub fn available() -> f64 {
    kilobytes("/proc/meminfo", "MemAvailable:")
}

/// Reads a line `name number kB` of a file; the number in bytes.
fn kilobytes(file: &str, name: &str) -> f64 {
    let text = fs::read_to_string(file).unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(name));
    let number = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    number.map_or(f64::NAN, |number| 1024.0 * number)
}

/// Measures the CPU time of the program `ancf` for a model file, output files included, in seconds: the median of `runs` runs.
///
/// # Errors
/// If the program is not in the folder of this program, or fails.
pub fn program_cost(text: &str, runs: usize) -> Result<f64> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (model, out) = (folder.path().join("model.toml"), folder.path().join("out"));
    fs::write(&model, text).map_err(|error| error.to_string())?;
    let program = program()?;
    let one = |_| {
        let start = clock::of_children();
        let mut command = Command::new(&program);
        let command = command.arg("run").arg(&model).arg("--output").arg(&out).arg("--quiet");
        let output = command.output().map_err(|error| format!("{}: {error}", program.display()))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        Ok(clock::of_children() - start)
    };
    (0..runs).map(one).collect::<Result<_>>().map(median)
}

/// Cost of a run of the program `ancf`.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct ProgramCost {
    /// CPU time in seconds.
    pub processor: f64,
    /// Maximum resident memory in bytes.
    pub memory: f64,
}

/// Measures a run of the program `ancf` with one thread in a folder.
///
/// A separate process runs the program, because the system reports the memory of all child processes together.
///
/// # Errors
/// If the program is not in the folder of this program, or fails.
pub fn program_run(folder: &Path, arguments: &[&str]) -> Result<ProgramCost> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let mut command = Command::new(own);
    let command = command.arg("program").args(arguments).current_dir(folder).env("RAYON_NUM_THREADS", "1");
    let output = command.stderr(Stdio::inherit()).output().map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(format!("ancf {}: {}", arguments.join(" "), output.status));
    }
    serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())
}

/// Calls `measure` with a folder that contains the file `model.toml`.
///
/// # Errors
/// If the file cannot be written, or those of `measure`.
pub fn with_model(text: &str, measure: impl FnOnce(&Path) -> Result<ProgramCost>) -> Result<ProgramCost> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    fs::write(folder.path().join("model.toml"), text).map_err(|error| error.to_string())?;
    measure(folder.path())
}

/// Runs a model into the folder `out`.
///
/// # Errors
/// If the run fails.
pub fn run(folder: &Path) -> Result<ProgramCost> {
    program_run(folder, &["run", "model.toml", "--output", "out", "--quiet"])
}

/// Measures a run of the program `ancf`. It is the only child process of this process.
///
/// # Errors
/// If the program is not in the folder of this program, or fails.
pub fn program_run_here(arguments: &[String]) -> Result<ProgramCost> {
    let program = program()?;
    let run = Command::new(&program).args(arguments).stdout(Stdio::null()).stderr(Stdio::null()).status();
    let status = run.map_err(|error| format!("{}: {error}", program.display()))?;
    if !status.success() {
        return Err(format!("ancf {}: {status}", arguments.join(" ")));
    }
    Ok(ProgramCost { processor: clock::of_children(), memory: clock::memory_of_children() })
}

/// Path of the program `ancf`, built together with this program.
fn program() -> Result<PathBuf> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let path = own.with_file_name(format!("ancf{}", std::env::consts::EXE_SUFFIX));
    if path.exists() {
        Ok(path)
    } else {
        Err(format!("{} does not exist; use cargo xtask bench", path.display()))
    }
}
