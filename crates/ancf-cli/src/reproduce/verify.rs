//! `ancf verify`: problems with known answers.

use std::path::PathBuf;

use ancf_verification::{Problem, problems};
use anyhow::Result;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};

use crate::terminal::Ended;

/// Arguments of `ancf verify`.
#[derive(Debug, Args)]
pub struct VerifyArguments {
    /// Folder for index.html and results.json.
    #[arg(short, long, value_name = "DIR", default_value = "out/verify")]
    output: PathBuf,
    /// Names of problems; all by default.
    #[arg(value_name = "NAME", value_parser = names())]
    names: Vec<String>,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const VERIFY_EXAMPLES: &str = "\
Examples:
  ancf verify                         all problems, report in out/verify/index.html
  ancf verify elastica -o look        one problem

Exit code 0 if all passed, 1 if one failed.";

/// Returns the names of all problems as values of the argument. Other names are rejected, with the nearest as a suggestion.
fn names() -> PossibleValuesParser {
    let value = |problem: &Problem| PossibleValue::new(problem.name).help(problem.title);
    PossibleValuesParser::new(problems::all().map(value))
}

#[cfg(feature = "figures")]
impl VerifyArguments {
    /// Solves the problems and writes the report.
    pub fn run(&self) -> Result<Ended> {
        use std::time::Instant;

        use ancf_paper::{ReportFolder, solve_problems, write_verification};

        use crate::terminal::{print, print_json, print_status};

        let names = &self.names;
        let selected = |problem: &&Problem| names.is_empty() || names.iter().any(|name| name == problem.name);
        let problems: Vec<Problem> = problems::all().filter(selected).copied().collect();
        let folder = ReportFolder::create(&self.output)?;
        let clock = Instant::now();
        let width = problems.iter().map(|problem| problem.name.len()).max().unwrap_or(0);
        let verdicts = solve_problems(&problems, |verdict| print(&format!("{}\n", verdict.line(width))));
        let record = write_verification(&folder, &verdicts, clock.elapsed().as_secs_f64())?;
        let holding = verdicts.iter().filter(|verdict| verdict.holds()).count();
        print_status(&format!("{holding} of {} problems passed", verdicts.len()));
        let report = self.output.join("index.html").display().to_string();
        print_status(&format!("report in {report}"));
        print_json(&VerifyJson { report, record: &record });
        Ok(if holding == verdicts.len() { Ended::Done } else { Ended::Failed })
    }
}

#[cfg(not(feature = "figures"))]
impl VerifyArguments {
    /// Rejects the command: this program has no figures.
    pub fn run(&self) -> Result<Ended> {
        Ok(crate::terminal::reject_figures())
    }
}

/// JSON output of the verification.
#[cfg(feature = "figures")]
#[derive(serde::Serialize)]
struct VerifyJson<'a> {
    report: String,
    #[serde(flatten)]
    record: &'a ancf_paper::VerificationRecord,
}
