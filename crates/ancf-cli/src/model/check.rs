//! `ancf check`: errors or diagnosis of a model file.

use std::path::PathBuf;

use ancf::Model;
use ancf::diagnosis::Diagnosis;
use clap::Args;
use serde::Serialize;

use crate::terminal::{Ended, print, print_json, print_status, refuse};

/// Arguments of `ancf check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Model file (TOML).
    file: PathBuf,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const CHECK_EXAMPLES: &str = "\
Examples:
  ancf check models/slider_crank.toml
  ancf check --json models/bow.toml          for editors and scripts

Exit code 0 without errors, 2 with errors.";

/// JSON output for a model without errors.
#[derive(Serialize)]
struct CheckedModel<'a> {
    file: String,
    errors: [(); 0],
    diagnosis: &'a Diagnosis,
}

impl CheckArguments {
    /// Checks the model.
    pub fn run(&self) -> Ended {
        let diagnosis = match Model::read(&self.file).and_then(|model| model.diagnose()) {
            Ok(diagnosis) => diagnosis,
            Err(errors) => return refuse(&errors, &self.file),
        };
        let file = self.file.display().to_string();
        print_status(&format!("{file}: no errors"));
        print(&diagnosis.to_string());
        print_json(&CheckedModel { file, errors: [], diagnosis: &diagnosis });
        Ended::Done
    }
}
