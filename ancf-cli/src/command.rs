//! The commands: arguments to library calls to exit codes.

use std::fs;
use std::path::{Path, PathBuf};

use ancf::{Model, ModelError};
use anyhow::{Context, Result};
use clap::Subcommand;

use crate::check;
use crate::paper;
use crate::paraview;
use crate::progress::{print, say};
use crate::run;
use crate::study;
use crate::verify;
use crate::view;

/// What to do.
#[derive(Subcommand)]
pub enum Command {
    /// Check a model file: report everything that is wrong with it, or what it consists of, what joints tie and what is free.
    Check {
        /// The model file (TOML).
        file: PathBuf,
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
    /// Write the results of a run as files for ParaView and PyVista.
    #[command(after_help = paraview::EXAMPLES)]
    Paraview(paraview::Arguments),
    /// Run a model in many cases, with values of its keys from lists and distributions, into a table.
    #[command(after_help = study::EXAMPLES)]
    Study(study::Arguments),
    /// Print the model in the units in which its equations are solved.
    Scaled {
        /// The model file (TOML).
        file: PathBuf,
    },
    /// Print the JSON Schema of model files, for editors.
    Schema,
    /// Reproduce every table and figure of Kim et al. (2017).
    Paper {
        /// The folder for index.html, figures, tables and results.json.
        #[arg(short, long, value_name = "DIR", default_value = "out/paper")]
        output: PathBuf,
        /// Timed repetitions of each run; times are their medians.
        #[arg(long, default_value_t = 3)]
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
    },
}

const VERIFY_EXAMPLES: &str = "\
Examples:
  ancf verify                         all problems, report in out/verify/index.html
  ancf verify elastica -o /tmp/look   one of them

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

impl Command {
    /// Carries the command out.
    pub fn run(self) -> Result<Ended> {
        match self {
            Self::Check { file } => with_model(&file, |model| {
                let diagnosis = match model.diagnose() {
                    Ok(diagnosis) => diagnosis,
                    Err(errors) => return Ok(refuse(&errors, &file)),
                };
                say(&format!("{}: no errors", file.display()));
                print(&diagnosis.to_string());
                Ok(Ended::Done)
            }),
            Self::Scaled { file } => with_model(&file, |model| {
                print(&scaled(model)?);
                Ok(Ended::Done)
            }),
            Self::Run(arguments) => arguments.run(),
            Self::Resume(arguments) => arguments.run(),
            Self::Report(arguments) => arguments.run(),
            Self::View(arguments) => arguments.run(),
            Self::Paraview(arguments) => arguments.run(),
            Self::Study(arguments) => arguments.run(),
            Self::Schema => {
                print(&ancf::model::schema_text());
                Ok(Ended::Done)
            }
            Self::Paper { output, repeats } => {
                paper::reproduce(&output, repeats)?;
                Ok(Ended::Done)
            }
            Self::Verify { output, names } => {
                let holds = verify::verify(&names, &output)?;
                Ok(if holds { Ended::Done } else { Ended::Failed })
            }
        }
    }
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
    say(check::render(errors, &file.display().to_string(), &String::from_utf8_lossy(&text)).trim_end());
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
