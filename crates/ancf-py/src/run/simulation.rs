//! Simulation of a model for Python.

use std::collections::{BTreeMap, HashMap};
use std::io;
use std::path::Path;
use std::sync::Arc;

use ancf::model::{Analysis, Body, ModelErrors, Units};
use ancf::{
    Column, Error, GivenState, GradientError, Model, Parameter, RefinedModel, RefinementHistory, StartState,
    Summary, can_refine, gradients, refine,
};
use ancf_results::given_state;
use ancf_surface::BodySurfaces;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyKeyboardInterrupt, PyMemoryError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use toml::Value;

use super::gradients::gradients_data;
use super::keep::Keep;
use super::recorder::{RecordedSimulation, RunRecorder};
use super::states::{AssembledModel, States};
use crate::input::detached;
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
    /// Model with external functions in place of the callables.
    supplied: Model,
    /// Refinement whose last mesh this is.
    history: Option<RefinementHistory>,
    /// Units of the columns by name.
    pub(crate) units: BTreeMap<String, String>,
    signals: Signals,
}

#[pymethods]
impl Simulation {
    /// Checks and assembles the model of data. Mesh files are relative to the current folder.
    #[new]
    fn new(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = data.py();
        Self::with_surfaces(data, |model| {
            let surfaces = detached(py, || BodySurfaces::read(model, Path::new("")));
            surfaces.map_err(|errors| model_error(py, &errors, None))
        })
    }

    /// Kind of the analysis, and the duration of a motion.
    #[getter]
    pub(crate) fn analysis(&self) -> (&'static str, Option<f64>) {
        match &self.supplied.analysis {
            Analysis::Dynamics(settings) => ("dynamics", Some(settings.duration)),
            Analysis::Statics(_) => ("statics", None),
            Analysis::Path(_) => ("path", None),
            Analysis::Modes(_) => ("modes", None),
            Analysis::Buckling(_) => ("buckling", None),
        }
    }

    /// Returns the names of the columns.
    fn columns(&self, py: Python<'_>) -> Vec<String> {
        detached(py, || self.assembled.simulation.columns().into_iter().map(|column| column.name).collect())
    }

    /// Runs the simulation and returns the results in a dictionary.
    ///
    /// A motion or an equilibrium starts in the last state of another run, with its last row by the columns, if there is one.
    #[pyo3(signature = (states, callback, tick, stop=None, after=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        states: &str,
        callback: Option<Py<PyAny>>,
        tick: Option<Py<PyAny>>,
        stop: Option<Py<PyAny>>,
        after: Option<(Py<States>, HashMap<String, f64>)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let keep = Keep::from_word(states)?;
        let last = after.map(|(states, row)| states.get().last(&row)).transpose()?;
        let start = detached(py, || self.start(last)).map_err(|errors| model_error(py, &errors, None))?;
        self.signals.begin(stop);
        let mut recorder = RunRecorder::new(self.recorded(py), keep, [callback, tick]);
        let simulation = &self.assembled.simulation;
        let summary = detached(py, || match &start {
            Some(start) => simulation.run_from(start, &mut recorder),
            None => simulation.run(&mut recorder),
        });
        let mut summary = summary.map_err(|error| match error.kind() {
            io::ErrorKind::OutOfMemory => PyMemoryError::new_err(RUN_MEMORY),
            _ => error.into(),
        })?;
        if let Some(history) = &self.history {
            history.add_to(&mut summary);
        }
        let results = PyDict::new(py);
        results.set_item("error", self.signals.take())?;
        results.set_item("failure", summary.outcome.failure(&self.supplied.analysis))?;
        results.set_item("summary", self.summary(py, &summary)?)?;
        let RunRecorder { columns, rows, frames, .. } = recorder;
        results.set_item("rows", rows_to_array(py, rows, columns.len())?)?;
        results.set_item("columns", columns)?;
        results.set_item("units", &self.units)?;
        results.set_item("states", States::new(&self.assembled, self.model.clone_ref(py), frames))?;
        Ok(results)
    }

    /// Returns the simulation on the mesh that has the requested error, or on the last mesh if the error cannot be reduced.
    fn refine(&self, py: Python<'_>, requested: f64) -> PyResult<Self> {
        if !can_refine(&self.supplied.analysis) {
            return Err(PyValueError::new_err(
                "to: refines the meshes of statics, modes and buckling; `output.errors` states the errors of motions",
            ));
        }
        if !(1e-9..1.0).contains(&requested) {
            let found = format!("to: found {requested}, expected a relative error between 1e-9 and 1");
            return Err(PyValueError::new_err(found));
        }
        self.signals.begin(None);
        let interrupt = self.signals.interrupt();
        let refined = detached(py, || refine(&self.supplied, requested, &interrupt, |_, _| ()));
        if let Some(error) = self.signals.take() {
            return Err(error);
        }
        let RefinedModel { model, simulation, history } = refined.map_err(|error| match error {
            Error::Model(errors) => model_error(py, &errors, None),
            error => PyRuntimeError::new_err(error.to_string()),
        })?;
        let surfaces = Arc::clone(&self.assembled.surfaces);
        Ok(Self {
            assembled: AssembledModel { simulation: Arc::new(simulation), surfaces },
            model: with_elements(self.model.bind(py), &model)?.unbind(),
            supplied: model,
            history: Some(history),
            units: self.units.clone(),
            signals: self.signals.clone(),
        })
    }

    /// Returns the derivatives of the results with respect to numbers of the model, each a path with the size of its change.
    fn gradients<'py>(
        &self,
        py: Python<'py>,
        parameters: Vec<(String, Option<f64>)>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let parameters: Vec<Parameter> =
            parameters.into_iter().map(|(path, size)| Parameter { path, size }).collect();
        self.signals.begin(None);
        let interrupt = self.signals.interrupt();
        let found = detached(py, || gradients(&self.supplied, &parameters, &interrupt));
        if let Some(error) = self.signals.take() {
            return Err(error);
        }
        match found {
            Ok(found) => gradients_data(py, &found),
            Err(GradientError::Model(errors)) => Err(model_error(py, &errors, None)),
            Err(GradientError::Interrupted) => {
                Err(PyKeyboardInterrupt::new_err("the computation of gradients was interrupted"))
            }
            Err(error @ GradientError::Failed { .. }) => Err(PyRuntimeError::new_err(error.to_string())),
        }
    }
}

/// Copies the data of a model with the numbers of elements of another one, and with its request of errors.
fn with_elements<'py>(data: &Bound<'py, PyAny>, model: &Model) -> PyResult<Bound<'py, PyAny>> {
    let (py, copy) = (data.py(), data.call_method0("copy")?);
    let bodies = PyList::empty(py);
    for (entry, body) in data.get_item("bodies")?.try_iter()?.zip(&model.bodies) {
        let entry = entry?.call_method0("copy")?;
        match body {
            Body::Shell(shell) => entry.set_item("elements", shell.elements)?,
            Body::Beam(_) | Body::Cable(_) => entry.set_item("elements", body.elements())?,
            // The mesh of a shell with shear is given by its nodes.
            Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => {}
        }
        bodies.append(entry)?;
    }
    copy.set_item("bodies", bodies)?;
    if model.output.errors {
        let output = match copy.get_item("output") {
            Ok(output) if !output.is_none() => output.call_method0("copy")?,
            _ => PyDict::new(py).into_any(),
        };
        output.set_item("errors", true)?;
        copy.set_item("output", output)?;
    }
    Ok(copy)
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
        let assembled = AssembledModel { simulation, surfaces };
        Ok(Self { assembled, model: data, supplied: model, history: None, units, signals })
    }

    /// Returns the state in which the motion starts: that of a run before it, or of a results folder relative to the current folder.
    fn start(&self, last: Option<GivenState>) -> Result<Option<StartState>, ModelErrors> {
        let given = match last {
            Some(last) => Some(last),
            None => given_state(&self.supplied, Path::new(""))?,
        };
        given.map(|given| self.assembled.simulation.start_from(&given)).transpose()
    }

    /// Returns the parts that the recorder of a run needs.
    fn recorded(&self, py: Python<'_>) -> RecordedSimulation {
        RecordedSimulation {
            assembled: self.assembled.clone(),
            model: self.model.clone_ref(py),
            signals: self.signals.clone(),
            every: self.supplied.row_interval(),
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
