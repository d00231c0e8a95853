//! Program of `cargo xtask hunt`: random models, held to the same physics as their transformed twins.

use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs};

use ancf_hunt::hunt::{Report, Violation, case, check, hunt};
use ancf_hunt::shrink::{find, shrink};

/// Number of models between two lines of progress.
const PORTION: u64 = 500;

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match of_arguments(&arguments) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(why) => {
            say(&why);
            ExitCode::FAILURE
        }
    }
}

/// Runs the program. Returns true without new findings.
fn of_arguments(arguments: &[String]) -> Result<bool, String> {
    let number = |k: usize, default: u64| match arguments.get(k) {
        Some(text) => text.parse().map_err(|_| format!("`{text}` is not an integer")),
        None => Ok(default),
    };
    match arguments.first().map(String::as_str) {
        Some("show") => {
            let model = case(number(1, 1)?, number(2, 0)?)?;
            say(&text_of(&model)?);
            Ok(true)
        }
        Some("file") => of_file(Path::new(arguments.get(1).map_or("", String::as_str))),
        Some("one") => {
            let (seed, number) = (number(1, 1)?, number(2, 0)?);
            let report = check(seed, number, case(seed, number)?, 1.0);
            say(&report.to_string());
            report.refusals.iter().for_each(|(_, reason)| say(reason));
            let explained = report.explained.iter();
            explained.for_each(|(_, law, cause)| say(&format!("  {law}: deviates by {}", cause.word())));
            report.violations.iter().for_each(|violation| say(&line(violation)));
            Ok(report.new_findings().next().is_none())
        }
        _ => {
            let share = arguments.get(3).map_or(Ok(1.0), |text| text.parse());
            let share = share.map_err(|_| "the share of the laws is not a number".to_owned())?;
            of_seed(number(0, 1)?, number(1, 1000)?, arguments.get(2), share)
        }
    }
}

/// Checks all laws for a model file, and prints the last row of the run.
fn of_file(path: &Path) -> Result<bool, String> {
    let model = ancf::Model::read(path).map_err(|errors| errors.to_string())?;
    for column in ancf_hunt::run::run(&model).columns {
        say(&format!("{:<16} {:?}", column.name, column.values));
    }
    let report = check(1, 0, model, 1.0);
    say(&report.to_string());
    report.violations.iter().for_each(|violation| say(&line(violation)));
    Ok(report.new_findings().next().is_none())
}

/// Hunts with models of a seed. A law is checked with the probability `share`.
fn of_seed(seed: u64, models: u64, folder: Option<&String>, share: f64) -> Result<bool, String> {
    let mut report = Report::default();
    let mut stored = BTreeSet::new();
    let mut first = 0;
    while first < models {
        let last = (first + PORTION).min(models);
        let part = hunt(seed, first..last, share)?;
        for (number, reason) in &part.refusals {
            say(&format!("  {number}: {reason}"));
        }
        for (number, law, cause) in &part.explained {
            say(&format!("  {number}: {law}: deviates by {}", cause.word()));
        }
        for violation in &part.violations {
            say(&line(violation));
            // All new findings, and the first one of each known defect.
            let is_stored = violation.known.is_none_or(|known| stored.insert(known));
            if let Some(folder) = folder.filter(|_| is_stored) {
                store(Path::new(folder), seed, violation)?;
            }
        }
        say(&format!("{last} of {models} models"));
        report = report.with(part);
        first = last;
    }
    say(&report.to_string());
    Ok(report.new_findings().next().is_none())
}

fn line(violation: &Violation) -> String {
    let Violation { number, finding, known, .. } = violation;
    let known = known.map_or_else(String::new, |known| format!(" [{known}]"));
    format!("  {number}: {} {}: {}{known}", finding.law, finding.quantity, finding.values)
}

/// Writes the reduced model of a finding.
fn store(folder: &Path, seed: u64, violation: &Violation) -> Result<(), String> {
    let finding = &violation.finding;
    let model = shrink(&violation.model, finding, seed, violation.number);
    let again = find(&model, finding.law, seed, violation.number).unwrap_or_else(|| finding.clone());
    let text = format!(
        "# law: {}\n# quantity: {}\n# values: {}\n# case: seed {seed}, number {}\n\n{}",
        again.law,
        again.quantity,
        again.values.replace('\n', " "),
        violation.number,
        text_of(&model)?
    );
    fs::create_dir_all(folder).map_err(|error| error.to_string())?;
    let path = folder.join(format!("{}-{seed}-{}.toml", finding.law, violation.number));
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    say(&format!("    {}", path.display()));
    Ok(())
}

fn text_of(model: &ancf::Model) -> Result<String, String> {
    toml::to_string(model).map_err(|error| error.to_string())
}

/// Prints a line on standard error.
fn say(text: &str) {
    // A closed standard error cannot be reported anywhere.
    let _ = writeln!(io::stderr(), "{text}");
}
