//! `ancf gradients`: derivatives of the results of a model with respect to its numbers.

use std::path::{Path, PathBuf};

use ancf::{GradientError, Gradients, Model, Parameter, gradients};
use anyhow::{Context, Result};
use clap::Args;
use serde::Serialize;

use crate::terminal::{
    Ended, JsonErrors, count, interrupt, print, print_error, print_json, print_status, report_model_errors,
};

/// Arguments of `ancf gradients`.
#[derive(Debug, Args)]
pub struct GradientsArguments {
    /// Model file (TOML) with statics, modes or buckling.
    file: PathBuf,
    /// Number of the model, such as `materials.steel.young`; repeatable. SIZE is the largest change for differences, by default an eighth of the number; a zero needs it.
    #[arg(short, long = "parameter", value_name = "PATH[:SIZE]", value_parser = parameter, required = true)]
    parameters: Vec<Parameter>,
    /// CSV file of all derivatives with their errors, one row for each result and parameter.
    #[arg(short, long, value_name = "CSV")]
    output: Option<PathBuf>,
    /// Print one JSON object on standard output and nothing else.
    #[arg(long)]
    pub json: bool,
}

/// Examples of the help.
pub const GRADIENTS_EXAMPLES: &str = "\
Examples:
  ancf gradients models/elastica.toml -p materials.steel.young -p 'loads[0].force[1]'
  ancf gradients models/tuning_fork.toml -p materials.steel.density -o gradients.csv
  ancf gradients models/column.toml -p materials.steel.young --json

Results are the columns of the last equilibrium, frequencies, or critical load factors.
Paths are those of studies.";

/// Reads `PATH` or `PATH:SIZE`.
fn parameter(text: &str) -> Result<Parameter, String> {
    let Some((path, size)) = text.rsplit_once(':') else { return Ok(Parameter::new(text.trim())) };
    match size.trim().parse() {
        Ok(size) if f64::is_finite(size) && size > 0.0 => {
            Ok(Parameter { path: path.trim().to_owned(), size: Some(size) })
        }
        _ => Err(format!("the size is {size:?}, expected a positive number")),
    }
}

impl GradientsArguments {
    /// Computes the gradients, prints them and writes them into a file on request.
    pub fn run(&self) -> Result<Ended> {
        let model = match Model::read(&self.file) {
            Ok(model) => model,
            Err(errors) => return Ok(report_model_errors(&errors, &self.file)),
        };
        let found = match gradients(&model, &self.parameters, &interrupt()?) {
            Ok(found) => found,
            Err(GradientError::Model(errors)) => return Ok(report_model_errors(&errors, &self.file)),
            Err(GradientError::Interrupted) => return Ok(Ended::Stopped),
            Err(error) => {
                print_error(&format!("error: {error}"));
                print_json(&JsonErrors::from_message(error.to_string()));
                return Ok(Ended::Failed);
            }
        };
        found.warnings.iter().for_each(|warning| print_error(&format!("warning: {warning}")));
        if let Some(file) = &self.output {
            write(&found, file).with_context(|| format!("cannot write {}", file.display()))?;
        }
        print(&table(&found));
        print_json(&GradientsJson::new(&found));
        if let Some(file) = &self.output {
            let derivatives = count((found.quantities.len() * found.parameters.len()) as u64, "derivative");
            print_status(&format!("done: {}: {derivatives}", file.display()));
        }
        Ok(Ended::Done)
    }
}

/// Table with a row for each result and a column for each parameter.
fn table(found: &Gradients) -> String {
    let number = |x: f64| format!("{x:.9e}");
    let heads = ["result", "value"].into_iter().map(str::to_owned);
    let heads: Vec<String> = heads.chain(found.parameters.iter().map(|path| format!("d/d {path}"))).collect();
    let row = |i: usize| {
        let derivatives = (0..found.parameters.len()).map(|k| number(found.derivatives[(i, k)]));
        [found.quantities[i].clone(), number(found.values[i])].into_iter().chain(derivatives).collect()
    };
    let rows: Vec<Vec<String>> = std::iter::once(heads).chain((0..found.quantities.len()).map(row)).collect();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..found.parameters.len() + 2).map(width).collect();
    let line = |row: &Vec<String>| {
        let cells = row.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| match column {
            0 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        cells.collect::<Vec<_>>().join("  ") + "\n"
    };
    rows.iter().map(line).collect()
}

/// Row of the file.
#[derive(Serialize)]
struct GradientRow<'a> {
    result: &'a str,
    value: f64,
    parameter: &'a str,
    parameter_value: f64,
    derivative: f64,
    error: f64,
}

fn write(found: &Gradients, file: &Path) -> Result<()> {
    let mut writer = csv::Writer::from_path(file)?;
    for (i, result) in found.quantities.iter().enumerate() {
        for (k, parameter) in found.parameters.iter().enumerate() {
            writer.serialize(GradientRow {
                result,
                value: found.values[i],
                parameter,
                parameter_value: found.parameter_values[k],
                derivative: found.derivatives[(i, k)],
                error: found.errors[(i, k)],
            })?;
        }
    }
    Ok(writer.flush()?)
}

/// JSON output.
#[derive(Serialize)]
struct GradientsJson<'a> {
    results: &'a [String],
    values: &'a [f64],
    parameters: &'a [String],
    parameter_values: &'a [f64],
    derivatives: Vec<Vec<f64>>,
    errors: Vec<Vec<f64>>,
    warnings: &'a [String],
}

impl<'a> GradientsJson<'a> {
    fn new(found: &'a Gradients) -> Self {
        let rows = |of: &ancf::nalgebra::DMatrix<f64>| {
            of.row_iter().map(|row| row.iter().copied().collect()).collect()
        };
        Self {
            results: &found.quantities,
            values: &found.values,
            parameters: &found.parameters,
            parameter_values: &found.parameter_values,
            derivatives: rows(&found.derivatives),
            errors: rows(&found.errors),
            warnings: &found.warnings,
        }
    }
}
