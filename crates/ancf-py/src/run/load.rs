//! Results in a results folder.

use std::ffi::CString;
use std::io;
use std::path::PathBuf;

use ancf::record::Series;
use ancf_results::{KILLED, OpenError, Results, RunStatus};
use ancf_surface::BodySurfaces;
use numpy::PyArray1;
use pyo3::exceptions::{PyFileNotFoundError, PyMemoryError, PyUserWarning};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::{Table, Value};

use super::frames::Frames;
use super::keep::Keep;
use super::simulation::{Simulation, rows_to_array};
use super::states::States;
use crate::input::detached;
use crate::input::{model_error, to_python, value_error};

/// Returns the results of a results folder in a dictionary.
#[pyfunction]
pub(crate) fn load(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyDict>> {
    let fail = |error| unreadable(py, error);
    let results = detached(py, || Results::open(path)).map_err(fail)?;
    if !detached(py, || results.has_checksums()).map_err(fail)? {
        let text =
            c"the run was written by an earlier version: without checksums, damaged files are not detected";
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), text, 1)?;
    }
    detached(py, || results.verify()).map_err(fail)?;
    if !results.model().output.parquet {
        let text = c"the run recorded no rows (`output.parquet = false`): columns are empty; `probes.csv` may have them";
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), text, 1)?;
    }
    let status = results.status();
    let recorded = detached(py, || RecordedRun::read(&results));
    let RecordedRun { frames, values, rows, columns, numbers } = recorded.map_err(fail)?;
    let data: Table = results.text().parse().map_err(|error: toml::de::Error| value_error(error))?;
    let (surfaces, messages) = BodySurfaces::of_run(results.model(), results.folder().path());
    for message in messages {
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &CString::new(message)?, 1)?;
    }
    let simulation = Simulation::with_surfaces(&to_python(py, &Value::Table(data))?, |_| Ok(surfaces))?;
    let done = PyDict::new(py);
    done.set_item("kind", simulation.analysis().0)?;
    done.set_item("summary", to_python(py, &summary(&results, status).map_err(fail)?)?)?;
    done.set_item("units", &simulation.units)?;
    done.set_item("rows", rows_to_array(py, numbers, columns.len())?)?;
    done.set_item("columns", columns)?;
    done.set_item("frames", PyArray1::from_vec(py, values))?;
    done.set_item("frame_rows", PyArray1::from_vec(py, rows))?;
    let states = States::new(&simulation.assembled, simulation.model.clone_ref(py), frames);
    done.set_item("states", states.with_text(Some(results.text().to_owned())))?;
    done.set_item("model", simulation.model)?;
    Ok(done)
}

fn unreadable(py: Python<'_>, error: OpenError) -> PyErr {
    match error {
        OpenError::NoRun(_) | OpenError::Sequence { .. } => PyFileNotFoundError::new_err(error.to_string()),
        OpenError::Model { path, errors } => model_error(py, &errors, Some(&path.display().to_string())),
        OpenError::Read(error) if error.kind() == io::ErrorKind::OutOfMemory => {
            PyMemoryError::new_err("the results do not fit into memory")
        }
        OpenError::Read(error) => error.into(),
    }
}

/// Rows and states of a run.
struct RecordedRun {
    frames: Frames,
    /// First number of the row of each state.
    values: Vec<f64>,
    /// Row of each state, -1 of a state between rows.
    rows: Vec<i64>,
    columns: Vec<String>,
    /// Rows in contiguous memory.
    numbers: Vec<f64>,
}

impl RecordedRun {
    fn read(results: &Results) -> Result<Self, OpenError> {
        // States are read first: the rows of a run in progress are ahead of its states.
        let (mut frames, mut at) = (Frames::new(Keep::All), Vec::new());
        for frame in results.frames() {
            let frame = frame?;
            frames.push(&frame.state).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
            at.push((frame.row, frame.value));
        }
        if at.is_empty() {
            frames = Frames::new(Keep::Nothing);
        }
        let series = results.columns()?;
        let (columns, numbers) = by_rows(&series)?;
        let firsts = series.columns().next().map_or(&[][..], |(_, values)| values);
        let every = u64::from(results.model().row_interval());
        let row = |(row, value): &(u64, f64)| row_of(*row, *value, every, firsts).unwrap_or(-1);
        let rows = at.iter().map(row).collect();
        Ok(Self { frames, values: at.iter().map(|(_, value)| *value).collect(), rows, columns, numbers })
    }
}

/// Returns the row of a state by its step and first number, if the step was recorded as a row.
fn row_of(step: u64, value: f64, every: u64, firsts: &[f64]) -> Option<i64> {
    let row = usize::try_from(step.div_ceil(every)).ok()?;
    let is_due = step.is_multiple_of(every);
    let is_last = row + 1 == firsts.len();
    (firsts.get(row) == Some(&value) && (is_due || is_last)).then(|| i64::try_from(row).ok())?
}

/// Returns the names of the columns, and all numbers row by row.
fn by_rows(series: &Series) -> io::Result<(Vec<String>, Vec<f64>)> {
    let columns: Vec<&[f64]> = series.columns().map(|(_, values)| values).collect();
    let count = columns.first().map_or(0, |column| column.len());
    let mut numbers = Vec::new();
    let size = count.saturating_mul(columns.len());
    numbers.try_reserve_exact(size).map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
    (0..count).for_each(|row| numbers.extend(columns.iter().map(|column| column[row])));
    Ok((series.names().map(str::to_owned).collect(), numbers))
}

/// Returns the summary of a run. A run in progress or a killed run has an outcome and sizes only.
fn summary(results: &Results, status: RunStatus) -> Result<Value, OpenError> {
    let (kind, reason) = match (status, results.summary_file()?) {
        (RunStatus::Running, _) => ("running", "the run is in progress"),
        (_, Some(conclusion)) => return Value::try_from(conclusion).map_err(|e| io::Error::other(e).into()),
        (_, None) => ("broken", KILLED),
    };
    let outcome = [("kind", kind), ("reason", reason)].map(|(key, text)| (key.to_owned(), text.into()));
    let scales = Value::try_from(results.simulation().scales()).map_err(io::Error::other)?;
    let rest = results.simulation().assembly().rest();
    let size = |numbers: &[f64]| Value::Integer(i64::try_from(numbers.len()).unwrap_or(i64::MAX));
    let known = [
        ("outcome".to_owned(), Value::Table(Table::from_iter(outcome))),
        ("coordinates".to_owned(), size(&rest.q)),
        ("multipliers".to_owned(), size(&rest.lambda)),
        ("scales".to_owned(), scales),
    ];
    Ok(Value::Table(Table::from_iter(known)))
}
