use std::path::Path;

use ancf::errors::short;
use ancf::model::{Analysis, ModelError, ModelErrors};
use ancf::{GivenState, Model};

use super::open_error::OpenError;
use super::results::{Results, StoredState};

/// Tolerance within which a stored state has a stated time, relative to the duration of its run.
const TIME_TOLERANCE: f64 = 1e-9;

/// Reads the state from which the model of a motion starts, if it states a results folder. Paths are relative to `base`.
///
/// # Errors
/// If the folder has no such state.
pub fn given_state(model: &Model, base: &Path) -> Result<Option<GivenState>, ModelErrors> {
    let Some(folder) = model.starts_from() else { return Ok(None) };
    let results = Results::open(base.join(folder)).map_err(|error| of_folder(folder, &error))?;
    let source = format!("the results folder {folder:?}");
    check_units(model, &results, &source)?;
    let duration = match &results.model().analysis {
        Analysis::Modes(_) | Analysis::Buckling(_) => {
            let found = format!("{source}, which has shapes and no states of a motion or of an equilibrium");
            return Err(wrong("from", found, "a run of dynamics, statics or a path"));
        }
        Analysis::Dynamics(own) => Some(own.duration),
        Analysis::Statics(_) | Analysis::Path(_) => None,
    };
    let stored =
        selected(&results, model.initial.time.zip(duration)).map_err(|error| of_folder(folder, &error))?;
    let Some(stored) = stored else {
        let error = ModelError::new(
            "initial.from",
            format!("{source} without stored states"),
            "a run with stored states",
        );
        return Err(ModelErrors(vec![
            error.hint("`output.states` of that run is the number of stored states"),
        ]));
    };
    let place = place(model.initial.time, &stored, duration, &source)?;
    let simulation = results.simulation();
    let given = simulation.given_state(&stored.state, format!("the state of {source} at {place}"));
    let counted = simulation.counted_angles();
    if counted.is_empty() {
        return Ok(Some(given));
    }
    if stored.angles.len() == counted.len() {
        return Ok(Some(given.with_angles(stored.angles)));
    }
    // Runs of earlier versions have the turns in their rows, if each step has one.
    let columns = results.columns().map_err(|error| of_folder(folder, &error))?;
    let row = (results.model().row_interval() == 1).then_some(stored.row as usize);
    let value = |name: &String| Some((name.clone(), *columns.column(name)?.get(row?)?));
    match counted.iter().map(value).collect::<Option<Vec<_>>>() {
        Some(angles) => Ok(Some(given.with_angles(angles))),
        None => {
            let found =
                format!("{source} of an earlier version, without the turns of {}", counted.join(", "));
            Err(wrong("from", found, "a run of this version"))
        }
    }
}

/// Checks that a stored state has the stated time, and describes its place in the run.
fn place(
    time: Option<f64>,
    stored: &StoredState,
    duration: Option<f64>,
    source: &str,
) -> Result<String, ModelErrors> {
    let at = short(stored.value);
    match (time, duration) {
        (Some(_), None) => {
            Err(wrong("time", "a time for a run without time", "no time: the last equilibrium is the start"))
        }
        (Some(time), Some(duration)) if (stored.value - time).abs() > TIME_TOLERANCE * duration => {
            let error = ModelError::new("initial.time", short(time), "the time of a stored state");
            let hint = format!(
                "the nearest one of {source} is at t = {}; a larger `output.states` of that run stores more",
                stored.value
            );
            Err(ModelErrors(vec![error.hint(hint)]))
        }
        (_, Some(_)) => Ok(format!("t = {at}")),
        (None, None) => Ok(format!("load factor {at}")),
    }
}

/// Returns the last stored state, or the one nearest to a time of a motion.
fn selected(results: &Results, at: Option<(f64, f64)>) -> Result<Option<StoredState>, OpenError> {
    let mut found: Option<StoredState> = None;
    for stored in results.frames() {
        let stored = stored?;
        let is_nearer = |best: &StoredState| {
            at.is_none_or(|(time, _)| (stored.value - time).abs() < (best.value - time).abs())
        };
        if found.as_ref().is_none_or(is_nearer) {
            found = Some(stored);
        }
    }
    Ok(found)
}

/// Checks that units that both models name are equal.
fn check_units(model: &Model, results: &Results, source: &str) -> Result<(), ModelErrors> {
    match (&model.units, &results.model().units) {
        (Some(own), Some(other)) if own != other => {
            let names =
                |units: &ancf::model::Units| format!("{}, {}, {}", units.length, units.time, units.force);
            Err(wrong("from", format!("{source} in {}", names(other)), format!("a run in {}", names(own))))
        }
        _ => Ok(()),
    }
}

fn of_folder(folder: &str, error: &OpenError) -> ModelErrors {
    let found = format!("{folder:?}: {error}");
    wrong("from", found, "\"undeformed\", \"equilibrium\", or a results folder")
}

fn wrong(key: &str, found: impl Into<String>, expected: impl Into<String>) -> ModelErrors {
    ModelErrors(vec![ModelError::new(format!("initial.{key}"), found, expected)])
}
