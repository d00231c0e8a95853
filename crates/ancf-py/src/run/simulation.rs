//! Simulation of a model for Python.

use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::Arc;

use ancf::model::{Analysis, Units};
use ancf::{Column, Model, Summary};
use ancf_surface::BodySurfaces;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::Value;

use super::keep::Keep;
use super::recorder::{RecordedSimulation, RunRecorder};
use super::states::{AssembledModel, States};
use crate::input::{DataReader, Signals, model_error, to_python, to_python_with, valid_model};

/// Message about rows and states that do not fit into memory.
const RUN_MEMORY: &str =
    "rows and states of the run do not fit into memory; `states=` and `output.every` keep fewer";

/// A checked and assembled model.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct Simulation {
    pub(crate) assembled: AssembledModel,
    /// Model as plain data with callables.
    #[pyo3(get)]
    pub(crate) model: Py<PyAny>,
    analysis: Analysis,
    /// Units of the columns by name.
    pub(crate) units: BTreeMap<String, String>,
    every: u32,
    signals: Signals,
}

#[pymethods]
impl Simulation {
    /// Checks and assembles the model of data. Mesh files are relative to the current folder.
    #[new]
    fn new(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = data.py();
        Self::with_surfaces(data, |model| {
            let surfaces = py.detach(|| BodySurfaces::read(model, Path::new("")));
            surfaces.map_err(|errors| model_error(py, &errors, None))
        })
    }
    /// Kind of the analysis, and the duration of a motion.
    #[getter]
    pub(crate) fn analysis(&self) -> (&'static str, Option<f64>) {
        match &self.analysis {
            Analysis::Dynamics(settings) => ("dynamics", Some(settings.duration)),
            Analysis::Statics(_) => ("statics", None),
            Analysis::Path(_) => ("path", None),
            Analysis::Modes(_) => ("modes", None),
            Analysis::Buckling(_) => ("buckling", None),
        }
    }

    /// Returns the names of the columns.
    fn columns(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.assembled.simulation.columns().into_iter().map(|column| column.name).collect())
    }

    /// Runs the simulation and returns the results in a dictionary.
    #[pyo3(signature = (states, callback, tick, stop=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        states: &str,
        callback: Option<Py<PyAny>>,
        tick: Option<Py<PyAny>>,
        stop: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let keep = Keep::from_word(states)?;
        self.signals.begin(stop);
        let mut recorder = RunRecorder::new(self.recorded(py), keep, [callback, tick]);
        let summary = py.detach(|| self.assembled.simulation.run(&mut recorder));
        let summary = summary.map_err(|error| match error.kind() {
            io::ErrorKind::OutOfMemory => PyMemoryError::new_err(RUN_MEMORY),
            _ => error.into(),
        })?;
        let results = PyDict::new(py);
        results.set_item("error", self.signals.take())?;
        results.set_item("failure", summary.outcome.failure(&self.analysis))?;
        results.set_item("summary", self.summary(py, &summary)?)?;
        let RunRecorder { columns, rows, frames, .. } = recorder;
        results.set_item("rows", rows_to_array(py, rows, columns.len())?)?;
        results.set_item("columns", columns)?;
        results.set_item("units", &self.units)?;
        results.set_item("states", States::new(&self.assembled, self.model.clone_ref(py), frames))?;
        Ok(results)
    }
}

impl Simulation {
    /// Checks and assembles the model of data, with the surfaces of its rigid bodies.
    pub(crate) fn with_surfaces(
        data: &Bound<'_, PyAny>,
        surfaces: impl FnOnce(&Model) -> PyResult<BodySurfaces>,
    ) -> PyResult<Self> {
        let py = data.py();
        let mut reader = DataReader::default();
        let value = reader.model(data)?;
        let (model, signals) = (valid_model(py, &value)?, Signals::default());
        let surfaces = Arc::new(surfaces(&model)?);
        let data = to_python_with(py, &value, &reader.callables)?.unbind();
        let (model, simulation) = reader.callables.with(py, model, &signals, ancf::Simulation::new)?;
        let simulation = Arc::new(simulation.with_interrupt(signals.interrupt()));
        let units = model.units.as_ref().map(|units| column_units(units, &simulation)).unwrap_or_default();
        let every = model.output.every;
        let assembled = AssembledModel { simulation, surfaces };
        Ok(Self { assembled, model: data, analysis: model.analysis, units, every, signals })
    }

    /// Returns the parts that the recorder of a run needs.
    fn recorded(&self, py: Python<'_>) -> RecordedSimulation {
        RecordedSimulation {
            assembled: self.assembled.clone(),
            model: self.model.clone_ref(py),
            signals: self.signals.clone(),
            every: self.every.max(1),
        }
    }

    /// Returns the summary as dictionaries, as in `summary.json`.
    fn summary<'py>(&self, py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyAny>> {
        let data = Value::try_from(summary);
        to_python(py, &data.map_err(|error| PyValueError::new_err(error.to_string()))?)
    }
}

/// Returns the units of all columns that have one, `1` of pure numbers.
fn column_units(units: &Units, simulation: &ancf::Simulation) -> BTreeMap<String, String> {
    let of = |column: Column| column.unit(units).map(|unit| (column.name, unit));
    simulation.columns().into_iter().filter_map(of).collect()
}

/// Converts rows in contiguous memory to an array `[row, column]` without copying.
pub(crate) fn rows_to_array(
    py: Python<'_>,
    rows: Vec<f64>,
    columns: usize,
) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len().checked_div(columns).unwrap_or(0);
    PyArray1::from_vec(py, rows).reshape([count, columns])
}
