//! Instructions of fixed work, counted by valgrind: the same on every run, whatever else the machine does.
//!
//! Valgrind shows programs a processor without AVX-512, so that what is chosen at run time is AVX2 on any recent x86 machine.

use std::hint::black_box;
use std::process::Command;

use ancf::record::Csv;
use ancf::{Model, simulate};

use crate::measure::Result;
use crate::model::{Kind, read};
use crate::subject::{OfEquations, OfSteps, OfSystem, Part, Subject};

/// Steps of the motions that are counted.
const STEPS: u32 = 100;

type Make = fn() -> Result<Box<dyn Subject>>;

/// Work by name: small enough for valgrind, and of every part of a step.
pub const WORK: [(&str, Make); 6] = [
    ("residual of 100 elements", || boxed(OfSystem::new(Kind::Beam, 100, Part::Force))),
    ("tangent of 100 elements", || boxed(OfSystem::new(Kind::Beam, 100, Part::Stiffness))),
    ("factorise and solve, 100 elements", || boxed(OfEquations::new(Kind::Beam, 100, 10))),
    ("beam of 20 elements, 100 steps", || boxed(OfSteps::new(Kind::Beam, 20, STEPS))),
    ("cable of 20 elements, 100 steps", || boxed(OfSteps::new(Kind::Cable, 20, STEPS))),
    ("model of 20 elements, 100 steps, recorded", || boxed(Recorded::new(20))),
];

fn boxed<S: Subject + 'static>(subject: Result<S>) -> Result<Box<dyn Subject>> {
    Ok(Box::new(subject?))
}

/// A whole simulation with its table, in memory.
struct Recorded(Model);

impl Recorded {
    fn new(elements: u32) -> Result<Self> {
        read(Kind::Beam, elements, STEPS).map(Self).map_err(|errors| errors.to_string())
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

/// Does work so many times: what valgrind runs.
///
/// # Errors
/// If there is no such work, or it fails.
pub fn work(name: &str, times: u32) -> Result<()> {
    let (_, make) = WORK.iter().find(|(known, _)| *known == name).ok_or("there is no such work")?;
    let mut subject = make()?;
    for _ in 0..times {
        subject.prepare()?;
        subject.run()?;
    }
    Ok(())
}

/// Instructions of work by name: those of doing it once, less those of getting ready for it.
///
/// # Errors
/// If valgrind is missing or does not tell.
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
        // As older versions write it.
        text.lines().find_map(|line| line.split_once("I   refs:"))
    });
    let digits = number.map(|(_, number)| number.trim().replace(',', ""));
    digits.and_then(|digits| digits.parse().ok()).ok_or_else(|| format!("valgrind tells no count:\n{text}"))
}
