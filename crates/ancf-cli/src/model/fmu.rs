//! `ancf fmu`: the model as a co-simulation FMU.

use std::env;
use std::path::PathBuf;

use ancf::Model;
use ancf::reading::with_places;
use ancf_fmu::{ExportError, Exported, Fmi, Options, export, library_name};
use anyhow::{Context, Result};
use clap::{Args, ValueEnum};

use crate::terminal::{Ended, print_error, print_status, report_argument_error, report_model_errors};

/// Arguments of `ancf fmu`.
#[derive(Debug, Args)]
pub struct FmuArguments {
    /// Model file (TOML) with a motion.
    file: PathBuf,
    /// FMU to write; by default the name of the model file with the ending `.fmu`.
    #[arg(short, long, value_name = "FMU")]
    output: Option<PathBuf>,
    /// Version of FMI.
    #[arg(long, default_value = "3")]
    version: Version,
    /// Key of the model that can be set before the start, such as `bodies.rod.material.young`; repeatable. VALUE replaces that of the model.
    #[arg(short, long = "parameter", value_name = "PATH[=VALUE]", value_parser = parameter)]
    parameters: Vec<(String, Option<f64>)>,
    /// Shared library of the crate `ancf-fmu`; by default the one beside this program.
    #[arg(long, value_name = "FILE")]
    library: Option<PathBuf>,
}

/// Examples of the help.
pub const FMU_EXAMPLES: &str = "\
Examples:
  ancf fmu crane.toml                                  crane.fmu, FMI 3.0
  ancf fmu crane.toml -o crane2.fmu --version 2        FMI 2.0
  ancf fmu crane.toml -p bodies.boom.material.young    with a parameter

Inputs are those that the model declares, outputs the columns of a run.
The FMU contains the shared library of this platform, libancf_fmu. Archives and Python packages
have it beside the program; `cargo install` does not: cargo build --release -p ancf-fmu";

/// Version of FMI.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum Version {
    /// FMI 2.0.
    #[value(name = "2")]
    Two,
    /// FMI 3.0.
    #[value(name = "3")]
    Three,
}

/// Reads `PATH` or `PATH=VALUE`.
fn parameter(text: &str) -> Result<(String, Option<f64>), String> {
    let Some((path, value)) = text.split_once('=') else { return Ok((text.to_owned(), None)) };
    match value.trim().parse() {
        Ok(number) if f64::is_finite(number) => Ok((path.trim().to_owned(), Some(number))),
        _ => Err(format!("the value is {value:?}, expected a number")),
    }
}

impl FmuArguments {
    /// Writes the FMU.
    pub fn run(&self) -> Result<Ended> {
        let file = self.output.clone().unwrap_or_else(|| self.file.with_extension("fmu"));
        let library = match self.library() {
            Ok(library) => library,
            Err(message) => return Ok(report_argument_error(&message)),
        };
        let text = match Model::read_text(&self.file) {
            Ok(text) => text,
            Err(errors) => return Ok(report_model_errors(&errors, &self.file)),
        };
        let name = self.file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        let version = match self.version {
            Version::Two => Fmi::Two,
            Version::Three => Fmi::Three,
        };
        let options = Options { name: &name, version, parameters: &self.parameters, library: &library };
        match export(&text, &options, &file) {
            Ok(exported) => {
                exported.warnings.iter().for_each(|warning| print_error(&format!("warning: {warning}")));
                print_status(&format!("done: {}: {}", file.display(), summary(&exported)));
                Ok(Ended::Done)
            }
            Err(ExportError::Model(errors)) => {
                Ok(report_model_errors(&with_places(errors, &text), &self.file))
            }
            Err(ExportError::Write(error)) => {
                Err(error).with_context(|| format!("cannot write {}", file.display()))
            }
            Err(error) => Ok(report_argument_error(&error.to_string())),
        }
    }

    /// Path of the shared library: the stated one, or the first one beside the program or in the folder of libraries.
    fn library(&self) -> Result<PathBuf, String> {
        if let Some(library) = &self.library {
            return Ok(library.clone());
        }
        let name = library_name();
        let program = env::current_exe().map_err(|error| format!("the path of this program: {error}"))?;
        // A link in a folder of programs points to the folder with the library.
        let program = if cfg!(unix) { program.canonicalize().unwrap_or(program) } else { program };
        let folder = program.parent().map(PathBuf::from).unwrap_or_default();
        let candidates = ["", "deps", "../lib"].map(|place| folder.join(place).join(&name));
        candidates.into_iter().find(|library| library.is_file()).ok_or_else(|| {
            format!(
                "{name} is missing: found neither in {} nor in ../lib beside it. Archives and Python packages of a release contain it, `cargo install` does not install it. In a clone of the repository build it with `cargo build --release -p ancf-fmu` and state its path with `--library`",
                folder.display()
            )
        })
    }
}

fn summary(exported: &Exported) -> String {
    let count = |number: usize, what: &str| format!("{number} {what}{}", if number == 1 { "" } else { "s" });
    let derivatives = if exported.has_derivatives { ", directional derivatives" } else { "" };
    format!(
        "{}, {}, {}{derivatives}",
        count(exported.inputs.len(), "input"),
        count(exported.parameters.len(), "parameter"),
        count(exported.outputs, "output")
    )
}
