//! Instructions of fixed work, counted by valgrind: reproducible and independent of the load of the machine.
//!
//! Valgrind emulates a processor without AVX-512. Code selected at run time is hence the AVX2 code on any recent x86 machine.

use std::hint::black_box;
use std::process::Command;

use ancf::record::Csv;
use ancf::{Model, simulate};

use crate::Result;
use crate::subjects::{
    CantileverKind, Evaluation, LinearSolution, Subject, SystemEvaluation, TimeSteps, read_cantilever,
};

/// Number of time steps.
const STEPS: u32 = 100;

/// Constructor of a subject.
type Make = fn() -> Result<Box<dyn Subject>>;

/// Work by name: small enough for valgrind, and covering each part of a step.
pub const WORK: [(&str, Make); 6] = [
    ("residual of 100 elements", || {
        boxed(SystemEvaluation::new(CantileverKind::Beam, 100, Evaluation::Residual))
    }),
    ("tangent of 100 elements", || {
        boxed(SystemEvaluation::new(CantileverKind::Beam, 100, Evaluation::Tangent))
    }),
    ("factorise and solve, 100 elements", || boxed(LinearSolution::new(CantileverKind::Beam, 100, 10))),
    ("beam of 20 elements, 100 steps", || boxed(TimeSteps::new(CantileverKind::Beam, 20, STEPS))),
    ("cable of 20 elements, 100 steps", || boxed(TimeSteps::new(CantileverKind::Cable, 20, STEPS))),
    ("model of 20 elements, 100 steps, recorded", || boxed(Recorded::new(20))),
];

fn boxed<S: Subject + 'static>(subject: Result<S>) -> Result<Box<dyn Subject>> {
    Ok(Box::new(subject?))
}

/// Simulation that records its table in memory.
struct Recorded(Model);

impl Recorded {
    fn new(elements: u32) -> Result<Self> {
        read_cantilever(CantileverKind::Beam, elements, STEPS).map(Self).map_err(|errors| errors.to_string())
    }
}

impl Subject for Recorded {
    fn count(&self) -> f64 {
        1.0
    }

    fn run(&mut self) -> Result<()> {
        let mut table = Vec::new();
        let summary = simulate(&self.0, &mut Csv::new(&mut table)).map_err(|error| error.to_string())?;
        black_box(&table);
        if summary.outcome.is_finished() { Ok(()) } else { Err(format!("{:?}", summary.outcome)) }
    }
}

/// Runs work a number of times, as called under valgrind.
///
/// # Errors
/// If there is no work of this name, or it fails.
pub fn run_work(name: &str, times: u32) -> Result<()> {
    let (_, make) = WORK.iter().find(|(known, _)| *known == name).ok_or("no work of this name")?;
    let mut subject = make()?;
    for _ in 0..times {
        subject.prepare()?;
        subject.run()?;
    }
    Ok(())
}

/// Counts the instructions of work by name, without those of its preparation.
///
/// # Errors
/// If valgrind is missing or its output contains no count.
pub fn count(name: &str) -> Result<u64> {
    Ok(instructions(name, 1)?.saturating_sub(instructions(name, 0)?))
}

fn instructions(name: &str, times: u32) -> Result<u64> {
    let own = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(own)
        .args(["work", name, &times.to_string()])
        .env("RAYON_NUM_THREADS", "1")
        .output()
        .map_err(|error| format!("valgrind cannot be run: {error}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("`{name}` under valgrind: {}\n{text}", output.status));
    }
    let number = text.lines().find_map(|line| line.split_once("I refs:")).or_else(|| {
        // Format of older versions.
        text.lines().find_map(|line| line.split_once("I   refs:"))
    });
    let digits = number.map(|(_, number)| number.trim().replace(',', ""));
    digits
        .and_then(|digits| digits.parse().ok())
        .ok_or_else(|| format!("no count in the output of valgrind:\n{text}"))
}
