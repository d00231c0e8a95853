//! The commands: arguments to library calls to exit codes.

use std::fs;
use std::path::{Path, PathBuf};

use ancf::model::Diagnosis;
use ancf::{Model, ModelError};
use anyhow::{Context, Result};
use clap::Subcommand;
use serde::Serialize;

use crate::fault::Faults;
use crate::speech::{answer, complain, deliver, print, say};
use crate::{check, guide, new, paper, paraview, plot, run, study, verify, view};

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Write a model to start from, with comments; it runs as it is.
    #[command(after_help = new::EXAMPLES)]
    New(new::Arguments),
    /// Check a model file: report everything that is wrong with it, or what it consists of, what joints tie and what is free.
    #[command(after_help = CHECK_EXAMPLES)]
    Check {
        /// The model file (TOML).
        file: PathBuf,
        /// Print one JSON object on standard output and nothing else.
        #[arg(long)]
        json: bool,
    },
    /// Run a model file and write its results: motion, equilibrium, path of equilibria, modes or critical loads.
    #[command(after_help = run::EXAMPLES)]
    Run(run::Arguments),
    /// Go on with a run that was stopped, failed or killed, from its last checkpoint.
    #[command(after_help = run::RESUME_EXAMPLES)]
    Resume(run::Resumption),
    /// Write the results of a run as one HTML file: animation in space, charts, summary.
    #[command(after_help = view::REPORT_EXAMPLES)]
    Report(view::Report),
    /// Show the results of a run in a browser, live while it goes on.
    #[command(after_help = view::VIEW_EXAMPLES)]
    View(view::View),
    /// Plot columns of a run in the terminal, or into an SVG or PNG file; also while the run goes on.
    #[command(after_help = plot::EXAMPLES)]
    Plot(plot::Arguments),
    /// Write the results of a run as files for ParaView and PyVista.
    #[command(after_help = paraview::EXAMPLES)]
    Paraview(paraview::Arguments),
    /// Run a model in many cases, with values of its keys from lists and distributions, into a table.
    #[command(after_help = study::EXAMPLES)]
    Study(study::Arguments),
    /// Print the model in the units in which its equations are solved.
    #[command(after_help = SCALED_EXAMPLES)]
    Scaled {
        /// The model file (TOML).
        file: PathBuf,
    },
    /// Print the JSON Schema of model files, for editors.
    #[command(after_help = SCHEMA_EXAMPLES)]
    Schema,
    /// Reproduce every table and figure of Kim et al. (2017).
    #[command(after_help = PAPER_EXAMPLES)]
    Paper {
        /// The folder for index.html, figures, tables and results.json.
        #[arg(short, long, value_name = "DIR", default_value = "out/paper")]
        output: PathBuf,
        /// Timed repetitions of each run; times are their medians.
        #[arg(long, value_name = "N", default_value_t = 3)]
        repeats: usize,
    },
    /// Solve problems with known answers and report ours beside the references.
    #[command(after_help = VERIFY_EXAMPLES)]
    Verify {
        /// The folder for index.html and results.json.
        #[arg(short, long, value_name = "DIR", default_value = "out/verify")]
        output: PathBuf,
        /// The problems; all if there is none.
        #[arg(value_name = "NAME", value_parser = verify::names())]
        names: Vec<String>,
        /// Print one JSON object on standard output and nothing else.
        #[arg(long)]
        json: bool,
    },
    /// Print what completes commands and options in a shell.
    #[command(after_help = guide::COMPLETIONS_EXAMPLES)]
    Completions(guide::Completions),
    /// Write the manual pages: ancf.1 and one of each command.
    #[command(after_help = guide::MAN_EXAMPLES)]
    Man(guide::Man),
}

const CHECK_EXAMPLES: &str = "\
Examples:
  ancf check models/slider_crank.toml
  ancf check --json models/bow.toml          for editors and scripts

Exit code 0 if there is no error, 2 if there is one.";

const SCALED_EXAMPLES: &str = "\
Examples:
  ancf scaled models/revolute_pendulum.toml > scaled.toml";

const SCHEMA_EXAMPLES: &str = "\
Examples:
  ancf schema > model.schema.json

With `#:schema ./model.schema.json` as the first line of a model, editors complete its keys and mark its errors.";

const PAPER_EXAMPLES: &str = "\
Examples:
  ancf paper                          some minutes; report in out/paper/index.html
  ancf paper --repeats 1 -o look      less exact times";

const VERIFY_EXAMPLES: &str = "\
Examples:
  ancf verify                         all problems, report in out/verify/index.html
  ancf verify elastica -o look        one of them

Exit code 0 if all hold, 1 if one does not.";

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// All done.
    Done,
    /// The analysis failed; what it computed is written.
    Failed,
    /// The input is wrong; nothing is written.
    BadInput,
    /// Ctrl-C; what was computed is written.
    Stopped,
}

/// The answer of a check that found nothing wrong.
#[derive(Serialize)]
struct Checked<'a> {
    file: String,
    errors: [(); 0],
    diagnosis: &'a Diagnosis,
}

impl Command {
    /// Whether the answer is to be JSON.
    pub fn wants_json(&self) -> bool {
        match self {
            Self::Check { json, .. } | Self::Verify { json, .. } => *json,
            Self::Run(arguments) => arguments.json,
            Self::Resume(arguments) => arguments.json,
            Self::Study(arguments) => arguments.json,
            Self::Plot(arguments) => arguments.json,
            _ => false,
        }
    }

    /// Carries the command out.
    pub fn run(self) -> Result<Ended> {
        match self {
            Self::New(arguments) => arguments.run(),
            Self::Check { file, .. } => with_model(&file, |model| Ok(check(model, &file))),
            Self::Scaled { file } => with_model(&file, |model| {
                deliver(&scaled(model)?);
                Ok(Ended::Done)
            }),
            Self::Run(arguments) => arguments.run(),
            Self::Resume(arguments) => arguments.run(),
            Self::Report(arguments) => arguments.run(),
            Self::View(arguments) => arguments.run(),
            Self::Plot(arguments) => arguments.run(),
            Self::Paraview(arguments) => arguments.run(),
            Self::Study(arguments) => arguments.run(),
            Self::Schema => {
                deliver(&ancf::model::schema_text());
                Ok(Ended::Done)
            }
            Self::Paper { output, repeats } => {
                paper::reproduce(&output, repeats)?;
                Ok(Ended::Done)
            }
            Self::Verify { output, names, .. } => {
                let holds = verify::verify(&names, &output)?;
                Ok(if holds { Ended::Done } else { Ended::Failed })
            }
            Self::Completions(arguments) => Ok(arguments.run()),
            Self::Man(arguments) => arguments.run(),
        }
    }
}

/// Says what a model consists of.
fn check(model: &Model, file: &Path) -> Ended {
    let diagnosis = match model.diagnose() {
        Ok(diagnosis) => diagnosis,
        Err(errors) => return refuse(&errors, file),
    };
    let file = file.display().to_string();
    say(&format!("{file}: no errors"));
    print(&diagnosis.to_string());
    answer(&Checked { file, errors: [], diagnosis: &diagnosis });
    Ended::Done
}

/// Reads and checks a model and goes on with it, or renders its errors.
fn with_model(file: &Path, then: impl FnOnce(&Model) -> Result<Ended>) -> Result<Ended> {
    match Model::read(file) {
        Ok(model) => then(&model),
        Err(errors) => Ok(refuse(&errors, file)),
    }
}

/// Says what is wrong with a file.
pub fn refuse(errors: &[ModelError], file: &Path) -> Ended {
    let text = fs::read(file).unwrap_or_default();
    complain(check::render(errors, &file.display().to_string(), &String::from_utf8_lossy(&text)).trim_end());
    answer(&Faults::of(errors, file));
    Ended::BadInput
}

/// Says what is wrong with what was asked.
pub fn reject(message: &str) -> Ended {
    complain(&format!("error: {message}"));
    answer(&Faults::other(message));
    Ended::BadInput
}

/// The model in the units in which its equations are solved, headed by these.
fn scaled(model: &Model) -> Result<String> {
    let chosen = model.scales();
    let ancf::Scales { length, time, force } = chosen.scales;
    let text =
        toml::to_string(&model.scaled(&chosen.scales)).context("the scaled model cannot be printed")?;
    Ok(format!("# Units: length {length}, time {time}, force {force} ({}).\n{text}", chosen.reason))
}
