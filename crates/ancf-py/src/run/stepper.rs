//! Motions that Python advances step by step.

use std::path::Path;
use std::sync::{Mutex, MutexGuard, TryLockError};

use ancf::{CompleteState, StepError};
use ancf_results::given_state;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyKeyError, PyKeyboardInterrupt, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use toml::Value;

use super::linear::linear_data;
use crate::input::detached;
use crate::input::{DataReader, Signals, model_error, to_python, to_python_with, valid_model};

/// A motion that is advanced step by step.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct Stepper {
    stepper: Mutex<ancf::Stepper>,
    signals: Signals,
    /// Model as plain data with callables.
    #[pyo3(get)]
    model: Py<PyAny>,
}

/// Data of a step: number of substeps, of iterations, and of attempts that error control rejected.
type StepNumbers = (u32, u32, u32);

/// Layout of the coordinates of a body or joint: name, first coordinate, kinds and references of its vectors, number of coordinates of
/// a joint.
type Layout = (String, usize, Vec<bool>, Vec<[f64; 3]>, usize);

#[pymethods]
impl Stepper {
    /// Checks and assembles the model of data, and computes its initial state. Results folders are relative to the current folder.
    #[new]
    fn new(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = data.py();
        let mut reader = DataReader::default();
        let value = reader.model(data)?;
        let (model, signals) = (valid_model(py, &value)?, Signals::default());
        let data = to_python_with(py, &value, &reader.callables)?.unbind();
        let (model, simulation) = reader.callables.with(py, model, &signals, ancf::Simulation::new)?;
        let simulation = simulation.with_interrupt(signals.interrupt());
        signals.begin(None);
        let stepper = detached(py, || {
            let given = given_state(&model, Path::new(""))?;
            let start = given.map(|given| simulation.start_from(&given)).transpose()?;
            ancf::Stepper::start(simulation, start.as_ref())
        });
        let stepper = stepper.map_err(|error| raised(py, &signals, error))?;
        Ok(Self { stepper: Mutex::new(stepper), signals, model: data })
    }

    /// Time.
    #[getter]
    fn time(&self) -> PyResult<f64> {
        Ok(self.lock()?.time())
    }

    /// Performs one step.
    fn step(&self, py: Python<'_>, h: f64) -> PyResult<StepNumbers> {
        self.run(py, |stepper| stepper.step(h))
    }

    /// Advances to a time in steps of the model.
    fn advance(&self, py: Python<'_>, until: f64) -> PyResult<StepNumbers> {
        self.run(py, |stepper| stepper.advance(until))
    }

    /// Sets an input, with a linear transition over a duration.
    fn set(&self, py: Python<'_>, name: &str, value: f64, ramp: f64) -> PyResult<()> {
        self.lock()?.set_within(name, value, ramp).map_err(|error| raised(py, &self.signals, error))
    }

    /// Returns the value of an input.
    fn input(&self, py: Python<'_>, name: &str) -> PyResult<f64> {
        self.lock()?.input(name).map_err(|error| raised(py, &self.signals, error))
    }

    /// Returns the names of the inputs.
    fn inputs(&self) -> PyResult<Vec<String>> {
        Ok(self.lock()?.inputs().map(str::to_owned).collect())
    }

    /// Returns the value of a column.
    fn read(&self, column: &str) -> PyResult<f64> {
        let mut stepper = self.lock()?;
        stepper.read(column).map_err(|error| PyKeyError::new_err(error.to_string()))
    }

    /// Returns all columns of the present state.
    fn row<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(PyArray1::from_slice(py, self.lock()?.row()))
    }

    /// Returns the names of the columns.
    fn columns(&self) -> PyResult<Vec<String>> {
        Ok(self.lock()?.columns().into_iter().map(|column| column.name).collect())
    }

    /// Returns the energies by name.
    fn energies<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let energies = PyDict::new(py);
        for (name, energy) in self.lock()?.energies() {
            energies.set_item(name, energy)?;
        }
        Ok(energies)
    }

    /// Returns the time, and coordinates, velocities and angles.
    fn state<'py>(&self, py: Python<'py>) -> PyResult<(f64, [Bound<'py, PyArray1<f64>>; 3])> {
        let CompleteState { time, coordinates, velocities, angles } = self.lock()?.state();
        Ok((time, [coordinates, velocities, angles].map(|numbers| PyArray1::from_vec(py, numbers))))
    }

    /// Continues from another state. Returns the largest displacement by its projection, and the relative kinetic energy of the
    /// correction of the velocities.
    fn set_state(
        &self,
        py: Python<'_>,
        time: f64,
        coordinates: PyReadonlyArray1<'_, f64>,
        velocities: PyReadonlyArray1<'_, f64>,
        angles: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<(f64, f64, f64)> {
        let [coordinates, velocities, angles] =
            [coordinates, velocities, angles].map(|numbers| numbers.as_array().to_vec());
        let state = CompleteState { time, coordinates, velocities, angles };
        let mut guard = self.lock()?;
        self.signals.begin(None);
        let stepper: &mut ancf::Stepper = &mut guard;
        let projection = detached(py, || stepper.set_state(&state));
        self.done(py, projection)
            .map(|projection| (projection.moved, projection.corrected, projection.turned))
    }

    /// Returns the layout of the coordinates.
    fn layout(&self) -> PyResult<Vec<Layout>> {
        let layout = self.lock()?.layout().into_iter();
        Ok(layout
            .map(|one| (one.name, one.first, one.are_positions, one.reference, one.joint_coordinates))
            .collect())
    }

    /// Returns a snapshot.
    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let bytes = self.lock()?.save().map_err(|error| raised(py, &self.signals, error))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Continues from a snapshot.
    fn restore(&self, py: Python<'_>, snapshot: &[u8]) -> PyResult<()> {
        let mut guard = self.lock()?;
        self.signals.begin(None);
        let stepper: &mut ancf::Stepper = &mut guard;
        let restored = detached(py, || stepper.restore(snapshot));
        self.done(py, restored)
    }

    /// Returns the linear model about the present state in a dictionary.
    fn linearize<'py>(&self, py: Python<'py>, outputs: Vec<String>) -> PyResult<Bound<'py, PyDict>> {
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        let mut guard = self.lock()?;
        self.signals.begin(None);
        let stepper: &mut ancf::Stepper = &mut guard;
        let model = detached(py, || stepper.linearise(&outputs));
        linear_data(py, &self.done(py, model)?)
    }

    /// Returns the summary of all steps as dictionaries.
    fn summary<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let data = Value::try_from(self.lock()?.summary());
        to_python(py, &data.map_err(|error| PyValueError::new_err(error.to_string()))?)
    }
}

impl Stepper {
    /// Locks the motion, or raises an exception if another thread advances it. A function of the model that calls the simulation
    /// would wait for itself.
    fn lock(&self) -> PyResult<MutexGuard<'_, ancf::Stepper>> {
        match self.stepper.try_lock() {
            Ok(stepper) => Ok(stepper),
            Err(TryLockError::WouldBlock) => Err(PyRuntimeError::new_err(
                "the simulation is in use: by another thread, or by a function of the model that calls it",
            )),
            Err(TryLockError::Poisoned(_)) => Err(PyRuntimeError::new_err("the simulation failed before")),
        }
    }

    /// Runs steps without the lock of the interpreter.
    fn run(
        &self,
        py: Python<'_>,
        advance: impl FnOnce(&mut ancf::Stepper) -> Result<ancf::solver::dynamics::StepReport, StepError> + Send,
    ) -> PyResult<StepNumbers> {
        let mut guard = self.lock()?;
        self.signals.begin(None);
        let stepper: &mut ancf::Stepper = &mut guard;
        let report = detached(py, || advance(stepper));
        self.done(py, report).map(|report| (report.substeps, report.iterations, report.rejected))
    }

    /// Returns a result, or raises its error or the exception of a function of Python.
    fn done<T>(&self, py: Python<'_>, result: Result<T, StepError>) -> PyResult<T> {
        match (self.signals.take(), result) {
            (Some(error), _) => Err(error),
            (None, result) => result.map_err(|error| raised(py, &self.signals, error)),
        }
    }
}

/// Exception of an error.
fn raised(py: Python<'_>, signals: &Signals, error: StepError) -> PyErr {
    if let Some(error) = signals.take() {
        return error;
    }
    match error {
        StepError::Model(errors) => model_error(py, &errors, None),
        StepError::Failed(message) => {
            let class = py.import("ancf.errors").and_then(|module| module.getattr("AnalysisError"));
            let error = class.and_then(|class| class.call1((message,)));
            error.map_or_else(|why| why, PyErr::from_value)
        }
        StepError::Interrupted => PyKeyboardInterrupt::new_err("the step was interrupted"),
        StepError::Argument(text) | StepError::Snapshot(text) => PyValueError::new_err(text),
    }
}
