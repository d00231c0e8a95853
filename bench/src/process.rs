//! Measurements that want a process of their own: memory, threads, and the program as its users start it.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::Instant;

use serde::{Deserialize, Serialize};

use crate::clock;
use crate::measure::{Result, median};
use crate::model::{Kind, cantilever};
use crate::motion::{Plant, step};

/// What so many steps of a beam took.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Stepped {
    /// Time of the processor per element and step, all threads together, s.
    pub processor: f64,
    /// Time on the wall per element and step, s.
    pub wall: f64,
    /// Newton iterations a step.
    pub iterations: f64,
    /// The most memory that the process had, bytes.
    pub memory: f64,
}

/// Steps a beam in a process of its own.
///
/// # Errors
/// If it fails.
pub fn stepped(elements: u32, steps: u32, threads: usize) -> Result<Stepped> {
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

/// The same in this process.
///
/// # Errors
/// If it fails.
pub fn step_here(elements: u32, steps: u32) -> Result<Stepped> {
    let plant = Plant::new(Kind::Beam, elements)?;
    let mut motion = plant.motion()?;
    // The first step touches memory for the first time.
    step(&mut motion)?;
    let (begun, clock, mut iterations) = (clock::own(), Instant::now(), 0);
    for _ in 0..steps {
        iterations += step(&mut motion)?.iterations;
    }
    let count = f64::from(elements) * f64::from(steps);
    Ok(Stepped {
        processor: (clock::own() - begun) / count,
        wall: clock.elapsed().as_secs_f64() / count,
        iterations: f64::from(iterations) / f64::from(steps),
        memory: status("/proc/self/status", "VmHWM:"),
    })
}

/// Memory that is to be had, bytes; not a number where the system does not tell.
pub fn available() -> f64 {
    status("/proc/meminfo", "MemAvailable:")
}

/// A line `name number kB`, in bytes.
fn status(file: &str, name: &str) -> f64 {
    let text = fs::read_to_string(file).unwrap_or_default();
    let line = text.lines().find_map(|line| line.strip_prefix(name));
    let number = line.and_then(|rest| rest.split_whitespace().next()?.parse::<f64>().ok());
    number.map_or(f64::NAN, |number| 1024.0 * number)
}

/// Time of the processor of the program `ancf` with a model of so many elements and steps, its files included, s: the median of
/// some runs.
///
/// # Errors
/// If the program is not beside this one, or fails.
pub fn whole(kind: Kind, elements: u32, steps: u32, runs: usize) -> Result<f64> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (model, out) = (folder.path().join("model.toml"), folder.path().join("out"));
    fs::write(&model, cantilever(kind, elements, steps)).map_err(|error| error.to_string())?;
    let program = program()?;
    let one = |_| {
        let begun = clock::of_children();
        let mut command = Command::new(&program);
        let command = command.arg("run").arg(&model).arg("--output").arg(&out).arg("--quiet");
        let output = command.output().map_err(|error| format!("{}: {error}", program.display()))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        Ok(clock::of_children() - begun)
    };
    (0..runs).map(one).collect::<Result<_>>().map(median)
}

/// The program `ancf`, built with this one.
fn program() -> Result<PathBuf> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let path = own.with_file_name(format!("ancf{}", std::env::consts::EXE_SUFFIX));
    if path.exists() {
        Ok(path)
    } else {
        Err(format!("there is no {}; use cargo xtask bench", path.display()))
    }
}
