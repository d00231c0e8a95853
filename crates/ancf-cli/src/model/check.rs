//! `ancf check`: errors or diagnosis of model files.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};
use std::{fs, io, thread};

use ancf::diagnosis::Diagnosis;
use ancf::model::ModelErrors;
use ancf::reading::{ModelFile, SequenceStage, with_places};
use ancf::{Model, Simulation};
use clap::Args;
use serde::Serialize;

use super::display::surfaces_of;
use super::sequence::check_stages;
use super::start::start_of;
use crate::terminal::{
    Ended, JsonErrors, print, print_error, print_json, print_model_errors, print_status,
    report_argument_error,
};

/// Arguments of `ancf check`.
#[derive(Debug, Args)]
pub struct CheckArguments {
    /// Model files (TOML); `-` is standard input.
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Check again whenever a file changes, until Ctrl-C.
    #[arg(long, conflicts_with = "json")]
    watch: bool,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const CHECK_EXAMPLES: &str = "\
Examples:
  ancf check models/slider_crank.toml
  ancf check models/*.toml                   errors and warnings of each file
  ancf check --watch beam.toml               again after each change
  cat beam.toml | ancf check -
  ancf check --json models/bow.toml          for editors and scripts

Exit code 0 without errors, 2 with errors.";

/// Path of standard input, and its name in messages.
const STANDARD_INPUT: &str = "-";
const STDIN: &str = "<stdin>";
/// Interval between two looks at the files.
const WATCH: Duration = Duration::from_millis(300);

/// A model without errors.
#[derive(Serialize)]
struct CheckedModel<'a> {
    file: &'a str,
    errors: [(); 0],
    #[serde(skip_serializing_if = "Option::is_none")]
    diagnosis: Option<&'a Diagnosis>,
    /// Diagnoses of several analyses.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    analyses: Vec<CheckedAnalysis<'a>>,
}

/// A model of an analysis of a sequence without errors.
#[derive(Serialize)]
struct CheckedAnalysis<'a> {
    name: &'a str,
    diagnosis: &'a Diagnosis,
}

/// Result of a file as JSON.
#[derive(Serialize)]
#[serde(untagged)]
enum CheckedFile<'a> {
    Valid(CheckedModel<'a>),
    Invalid(JsonErrors),
}

/// JSON output for several files.
#[derive(Serialize)]
struct CheckedFiles<'a> {
    files: Vec<CheckedFile<'a>>,
}

/// A model file with its text and the result of its check.
struct Checked {
    name: String,
    text: String,
    /// Diagnoses of all analyses. The name of a single analysis is empty.
    result: Result<Vec<(String, Diagnosis)>, ModelErrors>,
}

impl CheckArguments {
    /// Checks the models.
    pub fn run(&self) -> Ended {
        let standard_input = self.files.iter().filter(|file| is_standard_input(file)).count();
        if standard_input > 1 || (standard_input == 1 && self.watch) {
            return report_argument_error("standard input `-` can be read once");
        }
        loop {
            let stamps = self.stamps();
            let ended = self.check();
            if !self.watch {
                return ended;
            }
            print_status("waiting for changes; Ctrl-C ends");
            while self.stamps() == stamps {
                thread::sleep(WATCH);
            }
        }
    }

    /// Times of the last changes; `None` for a file that does not exist.
    fn stamps(&self) -> Vec<Option<SystemTime>> {
        self.files.iter().map(|file| fs::metadata(file).and_then(|file| file.modified()).ok()).collect()
    }

    fn check(&self) -> Ended {
        let checked: Vec<Checked> = self.files.iter().map(|file| Checked::new(file)).collect();
        match checked.as_slice() {
            [one] => one.report(),
            several => several.iter().for_each(Checked::report_briefly),
        }
        let mut json: Vec<CheckedFile<'_>> = checked.iter().map(Checked::json).collect();
        match json.pop() {
            Some(one) if json.is_empty() => print_json(&one),
            last => {
                json.extend(last);
                print_json(&CheckedFiles { files: json });
            }
        }
        let (count, invalid) = (checked.len(), checked.iter().filter(|one| one.result.is_err()).count());
        if invalid > 0 {
            if count > 1 {
                print_error(&format!("error: {invalid} of {count} files have errors"));
            }
            return Ended::BadInput;
        }
        if count > 1 {
            print_status(&format!("done: {count} files without errors"));
        }
        Ended::Done
    }
}

fn is_standard_input(file: &Path) -> bool {
    file.as_os_str() == STANDARD_INPUT
}

impl Checked {
    fn new(file: &Path) -> Self {
        let (name, read) = if is_standard_input(file) {
            (STDIN.to_owned(), Model::read_text_from(io::stdin()))
        } else {
            (file.display().to_string(), Model::read_text(file))
        };
        let result = read.as_ref().map_err(Clone::clone).and_then(|text| diagnose(text, file));
        Self { name, text: read.unwrap_or_default(), result }
    }

    /// Reports the errors or the diagnosis.
    fn report(&self) {
        let Self { name, text, result } = self;
        match result {
            Ok(diagnoses) => {
                for (analysis, diagnosis) in diagnoses {
                    if !analysis.is_empty() {
                        print(&format!("analysis `{analysis}`\n"));
                    }
                    print(&diagnosis.to_string());
                }
                let next = if name == STDIN { String::new() } else { format!("; next: ancf run {name}") };
                print_status(&format!("done: {name} has no errors{next}"));
            }
            Err(errors) => print_model_errors(errors, name, text),
        }
    }

    /// Reports the errors or the warnings, as one of several files.
    fn report_briefly(&self) {
        let Self { name, text, result } = self;
        match result {
            Ok(diagnoses) => {
                print(&format!("{name}: no errors\n"));
                let warnings = diagnoses.iter().flat_map(|(_, diagnosis)| &diagnosis.warnings);
                warnings.for_each(|warning| print(&format!("{name}: warning: {warning}\n")));
            }
            Err(errors) => print_model_errors(errors, name, text),
        }
    }

    fn json(&self) -> CheckedFile<'_> {
        let Self { name, result, .. } = self;
        let diagnoses = match result {
            Ok(diagnoses) => diagnoses,
            Err(errors) => return CheckedFile::Invalid(JsonErrors::from_errors(errors, name)),
        };
        let (mut diagnosis, mut analyses) = (None, Vec::new());
        for (name, found) in diagnoses {
            match name.as_str() {
                "" => diagnosis = Some(found),
                name => analyses.push(CheckedAnalysis { name, diagnosis: found }),
            }
        }
        CheckedFile::Valid(CheckedModel { file: name, errors: [], diagnosis, analyses })
    }
}

/// Diagnoses of the model of a file, or of the models of all its analyses.
fn diagnose(text: &str, file: &Path) -> Result<Vec<(String, Diagnosis)>, ModelErrors> {
    let model = match ModelFile::parse(text)? {
        ModelFile::Single(model) => model,
        ModelFile::Sequence(sequence) => {
            check_stages(&sequence, text)?;
            surfaces_of(&sequence.stages[0].model, text, file)?;
            let diagnosis = |stage: &SequenceStage| Ok((stage.name.clone(), stage.model.diagnose()?));
            return sequence.stages.iter().map(diagnosis).collect();
        }
    };
    surfaces_of(&model, text, file)?;
    let diagnosis = model.diagnose().map_err(|errors| with_places(errors, text))?;
    let has_conditions = model.analysis.dynamics().is_some_and(|own| !own.until.is_empty());
    if model.starts_from().is_some() || has_conditions {
        let simulation = Simulation::of_valid(&model).map_err(|errors| with_places(errors, text))?;
        start_of(&model, &simulation, text, file)?;
    }
    Ok(vec![(String::new(), diagnosis)])
}
