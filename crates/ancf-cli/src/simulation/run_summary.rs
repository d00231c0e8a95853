//! Summary of a run: a sentence and a small table.

use std::collections::BTreeMap;
use std::io;
use std::ops::ControlFlow;

use ancf::errors::{percentage, short};
use ancf::model::{Analysis, Modes};
use ancf::record::Sink;
use ancf::{Outcome, Summary};

use crate::terminal::count;

/// Values of the rows that the summary of an analysis needs.
pub struct RunSummary<'a> {
    analysis: &'a Analysis,
    /// Indices of the columns in a row.
    columns: Vec<usize>,
    /// Values, row by row.
    rows: Vec<Vec<f64>>,
}

impl<'a> RunSummary<'a> {
    /// Creates an empty summary of an analysis.
    pub const fn new(analysis: &'a Analysis) -> Self {
        Self { analysis, columns: Vec::new(), rows: Vec::new() }
    }

    /// Returns the names of the recorded columns.
    const fn names(&self) -> &'static [&'static str] {
        match self.analysis {
            Analysis::Dynamics(_) => &[],
            Analysis::Statics(_) => &["unstable"],
            Analysis::Path(_) => &["limit", "unstable"],
            Analysis::Modes(Modes { damped: true, .. }) => &["growth_rate", "frequency", "damping_ratio"],
            Analysis::Modes(_) => &["squared", "frequency", "frequency_error"],
            Analysis::Buckling(_) => &["factor", "factor_error"],
        }
    }

    /// Returns the values of a recorded column.
    fn column(&self, place: usize) -> impl Iterator<Item = f64> {
        self.rows.iter().filter_map(move |row| row.get(place).copied())
    }

    /// Returns modes and critical loads as aligned lines. Empty for other analyses.
    pub fn table(&self) -> String {
        let (heading, place, format): (_, _, fn(f64) -> String) = match self.analysis {
            Analysis::Modes(Modes { damped: true, .. }) => return self.damped_table(),
            Analysis::Modes(_) => ("frequency", 1, frequency),
            Analysis::Buckling(_) => ("load factor", 0, digits),
            _ => return String::new(),
        };
        if self.rows.is_empty() {
            return String::new();
        }
        let line = |(k, (value, error)): (usize, (f64, f64))| {
            let line = format!("{:4}  {:>14}  {:>11}", k + 1, format(value), excess(value, error));
            line.trim_end().to_owned() + "\n"
        };
        let values = self.column(place).zip(self.column(place + 1));
        format!("mode  {heading:>14}  too high by\n") + &values.enumerate().map(line).collect::<String>()
    }

    /// Returns damped modes as aligned lines.
    fn damped_table(&self) -> String {
        let line = |(k, row): (usize, &Vec<f64>)| {
            let value = |place: usize| row.get(place).copied().map_or_else(String::new, digits);
            format!("{:4}  {:>14}  {:>13}  {:>14}\n", k + 1, value(1), value(2), value(0))
        };
        let heading = format!("mode  {:>14}  {:>13}  {:>14}\n", "frequency", "damping ratio", "growth rate");
        if self.rows.is_empty() {
            String::new()
        } else {
            heading + &self.rows.iter().enumerate().map(line).collect::<String>()
        }
    }

    /// Returns modes and critical loads by column. Empty for other analyses.
    pub fn columns(&self) -> BTreeMap<&'static str, Vec<f64>> {
        match self.analysis {
            Analysis::Modes(_) | Analysis::Buckling(_) => {
                self.names().iter().enumerate().map(|(k, &name)| (name, self.column(k).collect())).collect()
            }
            _ => BTreeMap::new(),
        }
    }

    /// Returns outcome and extent of the run, for the terminal.
    pub fn sentence(&self, summary: &Summary, seconds: f64, folder: &str) -> String {
        let extent = format!("{}, {seconds:.3} s", self.extent(summary));
        match summary.outcome.failure(self.analysis) {
            Some(failure) => format!("{failure}\n{extent}; results so far in {folder}"),
            None if summary.outcome.is_finished() => format!("done: {extent}; results in {folder}"),
            None => format!("stopped: {extent}; results so far in {folder}"),
        }
    }

    /// Returns steps, iterations and the value reached.
    fn extent(&self, summary: &Summary) -> String {
        let Summary { time, steps, iterations, .. } = summary;
        let newton = count(*iterations, "Newton iteration");
        match self.analysis {
            Analysis::Dynamics(_) => format!("{} to t = {}, {newton}", count(*steps, "step"), short(*time)),
            Analysis::Statics(_) if *steps == 0 => "no equilibrium".to_owned(),
            Analysis::Statics(_) => {
                let increments = if *steps > 1 { format!(" in {steps} increments") } else { String::new() };
                let unstable = self.unstable(0);
                format!("{unstable}equilibrium at load factor {}{increments}, {newton}", short(*time))
            }
            Analysis::Path(path) => {
                let limits = self.column(0).filter(|limit| *limit != 0.0).count() as u64;
                let limits = count(limits, "limit point");
                let end = match summary.outcome {
                    Outcome::Finished if *time != path.load => " (maximum number of points)",
                    _ => "",
                };
                let points = count(*steps, "point");
                let unstable = if self.unstable(1).is_empty() { "" } else { " (unstable)" };
                format!("{points} to load factor {}{unstable}{end}, {limits}, {newton}", short(*time))
            }
            Analysis::Modes(_) => self.modes(),
            Analysis::Buckling(_) => self.critical(),
        }
    }

    /// Returns a word for the stability of the last equilibrium, which is empty if it is stable.
    fn unstable(&self, place: usize) -> &'static str {
        match self.column(place).last() {
            Some(count) if count > 0.0 => "unstable ",
            _ => "",
        }
    }

    fn modes(&self) -> String {
        if matches!(self.analysis, Analysis::Modes(Modes { damped: true, .. })) {
            let unstable = self.column(0).filter(|growth| *growth > 0.0).count();
            let text = count(self.rows.len() as u64, "damped mode");
            return if unstable > 0 { format!("{text}, {unstable} unstable") } else { text };
        }
        let of = |test: fn(f64) -> bool| self.column(0).filter(|squared| test(*squared)).count();
        let rigid = of(|squared| squared == 0.0);
        let unstable = self.column(1).filter(|frequency| frequency.is_nan()).count();
        let mut text = count(self.rows.len() as u64, "mode");
        for (number, kind) in [(rigid, "rigid"), (unstable, "unstable")] {
            if number > 0 {
                text += &format!(", {number} {kind}");
            }
        }
        text
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

impl Sink for RunSummary<'_> {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        let index = |name: &&str| columns.iter().position(|column| column == name);
        self.columns = self.names().iter().filter_map(index).collect();
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        if !self.columns.is_empty() {
            self.rows.push(self.columns.iter().filter_map(|&place| row.get(place).copied()).collect());
        }
        Ok(ControlFlow::Continue(()))
    }
}

/// Formats a number with seven digits.
fn digits(x: f64) -> String {
    let places = 6 - x.abs().log10().floor().clamp(-4.0, 6.0) as i32;
    if x != 0.0 && !(1e-4..1e7).contains(&x.abs()) {
        format!("{x:.6e}")
    } else {
        format!("{x:.*}", places.clamp(0, 10) as usize)
    }
}

/// Formats the estimated error of a value as the percentage by which it is too high.
fn excess(value: f64, error: f64) -> String {
    let relative = -error / value;
    match value {
        _ if relative.is_finite() => percentage(relative),
        0.0 => String::new(),
        _ => "?".to_owned(),
    }
}

fn frequency(x: f64) -> String {
    match x {
        0.0 => "rigid".to_owned(),
        _ if x.is_nan() => "unstable".to_owned(),
        _ => digits(x),
    }
}
