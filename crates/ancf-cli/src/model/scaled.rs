//! `ancf scaled`: the model in the units of its equations.

use std::path::PathBuf;

use ancf::Model;
use anyhow::{Context, Result};
use clap::Args;

use crate::terminal::{Ended, print_output, report_model_errors};

/// Arguments of `ancf scaled`.
#[derive(Debug, Args)]
pub struct ScaledArguments {
    /// Model file (TOML).
    file: PathBuf,
}

/// Examples of the help.
pub const SCALED_EXAMPLES: &str = "\
Examples:
  ancf scaled models/revolute_pendulum.toml > scaled.toml";

impl ScaledArguments {
    /// Prints the scaled model.
    pub fn run(&self) -> Result<Ended> {
        match Model::read(&self.file) {
            Ok(model) => {
                print_output(&scaled(&model)?);
                Ok(Ended::Done)
            }
            Err(errors) => Ok(report_model_errors(&errors, &self.file)),
        }
    }
}

/// Returns the scaled model, with its units in the first line.
fn scaled(model: &Model) -> Result<String> {
    let chosen = model.scales();
    let ancf::Scales { length, time, force } = chosen.scales;
    let text =
        toml::to_string(&model.scaled(&chosen.scales)).context("the scaled model cannot be printed")?;
    Ok(format!("# Units: length {length}, time {time}, force {force} ({}).\n{text}", chosen.reason))
}
