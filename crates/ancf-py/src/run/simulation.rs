use std::collections::BTreeMap;
use std::io;
use std::sync::Arc;

use ancf::model::{Analysis, Units};
use ancf::{Column, Summary};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::Value;

use crate::data::{Data, object, restored};
use crate::follower::Follower;
use crate::model::valid;
use crate::signals::Signals;
use crate::states::{Keep, States};

/// Said when rows and states of a run do not fit.
const TOO_MUCH: &str =
    "rows and states of the run do not fit into memory; `states=` and `output.every` keep fewer";

/// A model that is checked and assembled, ready to run.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct Simulation {
    pub(crate) simulation: Arc<ancf::Simulation>,
    /// The model as plain data, functions as they are.
    #[pyo3(get)]
    pub(crate) model: Py<PyAny>,
    analysis: Analysis,
    /// Units of the columns.
    pub(crate) units: BTreeMap<String, String>,
    pub(crate) every: u32,
    pub(crate) signals: Signals,
}

#[pymethods]
impl Simulation {
    /// Of data of a model.
    #[new]
    pub(crate) fn new(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = data.py();
        let mut reader = Data::default();
        let value = reader.model(data)?;
        let (model, signals) = (valid(py, &value)?, Signals::default());
        let data = restored(py, &value, &reader.callables)?.unbind();
        let (model, simulation) = reader.callables.with(py, model, &signals, ancf::Simulation::new)?;
        let simulation = Arc::new(simulation.heeding(signals.interrupt()));
        let units = model.units.as_ref().map(|units| named(units, &simulation)).unwrap_or_default();
        let every = model.output.every;
        Ok(Self { simulation, model: data, analysis: model.analysis, units, every, signals })
    }

    /// Kind of the analysis and, of a motion, its duration.
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

    /// Names of the columns of its rows.
    fn columns(&self, py: Python<'_>) -> Vec<String> {
        py.detach(|| self.simulation.columns().into_iter().map(|column| column.name).collect())
    }

    /// Runs it; the results, in a dictionary.
    #[pyo3(signature = (states, callback, tick, stop=None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        states: &str,
        callback: Option<Py<PyAny>>,
        tick: Option<Py<PyAny>>,
        stop: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let keep = Keep::named(states)?;
        self.signals.begin(stop);
        let mut follower = Follower::new(self, py, keep, [callback, tick]);
        let summary = py.detach(|| self.simulation.run(&mut follower));
        let summary = summary.map_err(|error| match error.kind() {
            io::ErrorKind::OutOfMemory => PyMemoryError::new_err(TOO_MUCH),
            _ => error.into(),
        })?;
        let results = PyDict::new(py);
        results.set_item("error", self.signals.take())?;
        results.set_item("failure", summary.outcome.failure(&self.analysis))?;
        results.set_item("summary", self.summary(py, &summary)?)?;
        let Follower { columns, rows, frames, .. } = follower;
        results.set_item("rows", table(py, rows, columns.len())?)?;
        results.set_item("columns", columns)?;
        results.set_item("units", &self.units)?;
        results.set_item("states", States::new(&self.simulation, self.model.clone_ref(py), frames))?;
        Ok(results)
    }
}

impl Simulation {
    /// The summary as dictionaries, as in `summary.json`.
    fn summary<'py>(&self, py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyAny>> {
        let data = Value::try_from(summary);
        object(py, &data.map_err(|error| PyValueError::new_err(error.to_string()))?)
    }
}

/// Units of all columns that have one, `1` of pure numbers.
fn named(units: &Units, simulation: &ancf::Simulation) -> BTreeMap<String, String> {
    let of = |column: Column| column.unit(units).map(|unit| (column.name, unit));
    simulation.columns().into_iter().filter_map(of).collect()
}

/// Rows, one after the other, as an array of two dimensions; the numbers stay where they are.
pub(crate) fn table(py: Python<'_>, rows: Vec<f64>, columns: usize) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len().checked_div(columns).unwrap_or(0);
    PyArray1::from_vec(py, rows).reshape([count, columns])
}
