//! What a run did, in a sentence and a small table.

use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;

use ancf::model::Analysis;
use ancf::record::Sink;
use ancf::{Outcome, Summary};

/// Keeps of the rows what the conclusion of an analysis tells.
pub struct Conclusion<'a> {
    analysis: &'a Analysis,
    /// Places of the columns in a row.
    columns: Vec<usize>,
    /// Their values, row by row.
    rows: Vec<Vec<f64>>,
}

impl<'a> Conclusion<'a> {
    /// Of an analysis that is about to run.
    pub const fn of(analysis: &'a Analysis) -> Self {
        Self { analysis, columns: Vec::new(), rows: Vec::new() }
    }

    /// Names of the columns that are kept.
    const fn names(&self) -> &'static [&'static str] {
        match self.analysis {
            Analysis::Dynamics(_) | Analysis::Statics(_) => &[],
            Analysis::Path(_) => &["limit"],
            Analysis::Modes(_) => &["squared", "frequency"],
            Analysis::Buckling(_) => &["factor"],
        }
    }

    /// The values of a kept column.
    fn column(&self, place: usize) -> impl Iterator<Item = f64> {
        self.rows.iter().filter_map(move |row| row.get(place).copied())
    }

    /// Modes and critical loads as aligned lines; nothing of another analysis.
    pub fn table(&self) -> String {
        let (heading, lines): (_, Vec<_>) = match self.analysis {
            Analysis::Modes(_) => ("mode       frequency\n", self.column(1).map(frequency).collect()),
            Analysis::Buckling(_) => ("mode     load factor\n", self.column(0).map(digits).collect()),
            _ => return String::new(),
        };
        if lines.is_empty() {
            return String::new();
        }
        let line = |(k, line): (usize, &String)| format!("{:4}  {line:>14}\n", k + 1);
        heading.to_owned() + &lines.iter().enumerate().map(line).collect::<String>()
    }

    /// Modes and critical loads, column by column; nothing of another analysis.
    pub fn columns(&self) -> BTreeMap<&'static str, Vec<f64>> {
        match self.analysis {
            Analysis::Modes(_) | Analysis::Buckling(_) => {
                self.names().iter().enumerate().map(|(k, &name)| (name, self.column(k).collect())).collect()
            }
            _ => BTreeMap::new(),
        }
    }

    /// How the run ended and what was done, for the terminal.
    pub fn sentence(&self, summary: &Summary, seconds: f64, folder: &str) -> String {
        let did = format!("{}, {seconds:.3} s", self.did(summary));
        match summary.outcome.failure(self.analysis) {
            Some(failure) => format!("{failure}\n{did}; results so far in {folder}"),
            None if summary.outcome.is_finished() => format!("done: {did}; results in {folder}"),
            None => format!("stopped: {did}; results so far in {folder}"),
        }
    }

    fn did(&self, summary: &Summary) -> String {
        let Summary { time, steps, iterations, .. } = summary;
        let newton = count(*iterations, "Newton iteration");
        match self.analysis {
            Analysis::Dynamics(_) => format!("{} to t = {}, {newton}", count(*steps, "step"), short(*time)),
            Analysis::Statics(_) if *steps == 0 => "no equilibrium".to_owned(),
            Analysis::Statics(_) => {
                let increments = if *steps > 1 { format!(" in {steps} increments") } else { String::new() };
                format!("equilibrium at load factor {}{increments}, {newton}", short(*time))
            }
            Analysis::Path(path) => {
                let limits = self.column(0).filter(|limit| *limit != 0.0).count() as u64;
                let limits = count(limits, "limit point");
                let end = match summary.outcome {
                    Outcome::Finished if *time != path.load => " (the most points permitted)",
                    _ => "",
                };
                let points = count(*steps, "point");
                format!("{points} to load factor {}{end}, {limits}, {newton}", short(*time))
            }
            Analysis::Modes(_) => self.modes(),
            Analysis::Buckling(_) => self.critical(),
        }
    }

    fn modes(&self) -> String {
        let of = |test: fn(f64) -> bool| self.column(0).filter(|squared| test(*squared)).count();
        let (rigid, unstable) = (of(|squared| squared == 0.0), of(|squared| squared < 0.0));
        let mut did = count(self.rows.len() as u64, "mode");
        for (number, kind) in [(rigid, "rigid"), (unstable, "unstable")] {
            if number > 0 {
                did += &format!(", {number} {kind}");
            }
        }
        did
    }

    fn critical(&self) -> String {
        let factors: Vec<f64> = self.column(0).collect();
        match factors[..] {
            [] => "no critical load factor".to_owned(),
            [factor] => format!("critical load factor {}", short(factor)),
            [first, .., last] => {
                format!("{} critical load factors, {} to {}", factors.len(), short(first), short(last))
            }
        }
    }
}

impl Sink for Conclusion<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        let place = |name: &&str| columns.iter().position(|column| column == name);
        self.columns = self.names().iter().filter_map(place).collect();
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        if !self.columns.is_empty() {
            self.rows.push(self.columns.iter().filter_map(|&place| row.get(place).copied()).collect());
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// "1 step", "2 steps".
pub fn count(number: u64, thing: &str) -> String {
    format!("{number} {thing}{}", if number == 1 { "" } else { "s" })
}

/// At most six digits, without trailing zeros; of numbers that are small or large with an exponent.
pub fn short(x: f64) -> String {
    let plain = x == 0.0 || (1e-4..1e9).contains(&x.abs());
    let rounded = format!("{x:.5e}").parse::<f64>();
    rounded.map_or_else(|_| x.to_string(), |x| if plain { x.to_string() } else { format!("{x:e}") })
}

/// Seven digits.
fn digits(x: f64) -> String {
    let places = 6 - x.abs().log10().floor().clamp(-4.0, 6.0) as i32;
    if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) {
        format!("{x:.6e}")
    } else {
        format!("{x:.*}", places.clamp(0, 10) as usize)
    }
}

fn frequency(x: f64) -> String {
    match x {
        0.0 => "rigid".to_owned(),
        _ if x.is_nan() => "unstable".to_owned(),
        _ => digits(x),
    }
}
