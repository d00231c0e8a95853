//! Results folder.

use std::borrow::Cow;
use std::path::Path;

use ancf::record::Series;
use ancf_report::{Ending, Recording};
use ancf_results::{OpenError, Results};
use ancf_surface::BodySurfaces;
use anyhow::Result;

use crate::terminal::{Ended, print_status, report_argument_error, report_model_errors};

/// Opens a results folder and verifies its files. Reports a folder without a run.
///
/// # Errors
/// If a file cannot be read or is damaged.
pub fn open_run(folder: &Path) -> Result<Result<Results, Ended>> {
    match Results::open(folder) {
        Ok(results) if results.folder().has_run() => {
            results.verify()?;
            if !results.has_checksums()? {
                let folder = folder.display();
                print_status(&format!(
                    "{folder} was written by an earlier version: without checksums, damaged files are not detected"
                ));
            }
            Ok(Ok(results))
        }
        Ok(_) => Ok(Err(report_argument_error(&format!(
            "{} contains no run: there is a model.toml and no results",
            folder.display()
        )))),
        Err(OpenError::Model { path, errors }) => Ok(Err(report_model_errors(&errors, &path))),
        Err(error @ (OpenError::NoRun(_) | OpenError::Sequence { .. })) => {
            Ok(Err(report_argument_error(&error.to_string())))
        }
        Err(error) => Err(error.into()),
    }
}

/// Returns the title of a run: the title of its model, or the name of its folder.
pub fn title(results: &Results) -> Cow<'_, str> {
    let folder = results.folder().path();
    let name = || folder.file_name().unwrap_or(folder.as_os_str()).to_string_lossy();
    results.model().title.as_deref().map_or_else(name, Cow::Borrowed)
}

/// Returns a recording with the columns of a run, without frames, summary and outcome.
pub fn recording<'a>(
    results: &'a Results,
    title: &'a str,
    series: &'a Series,
    surfaces: &'a BodySurfaces,
) -> Recording<'a> {
    Recording {
        simulation: results.simulation(),
        model: results.model(),
        text: results.text(),
        title,
        surfaces,
        frames: Vec::new(),
        series,
        summary: Vec::new(),
        ending: Ending::Running,
        messages: Vec::new(),
        body_errors: Vec::new(),
        live: false,
    }
}
