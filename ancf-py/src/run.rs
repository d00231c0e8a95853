use std::sync::Arc;

use ancf::Summary;
use ancf::model::Analysis;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use toml::{Table, Value};

use crate::data::{Data, object};
use crate::follower::Follower;
use crate::model::{refused, valid};
use crate::signals::Signals;
use crate::states::{Keep, States};

/// A model that is checked and assembled, ready to run.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct Simulation {
    simulation: Arc<ancf::Simulation>,
    data: Value,
    analysis: Analysis,
    every: u32,
    signals: Signals,
}

#[pymethods]
impl Simulation {
    /// Of data of a model.
    #[new]
    fn new(data: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = data.py();
        let mut reader = Data::default();
        let value = reader.read(data)?.unwrap_or_else(|| Value::Table(Table::new()));
        let (mut model, signals) = (valid(py, &value)?, Signals::default());
        reader.callables.supply(&mut model, &signals);
        let simulation = py.detach(|| ancf::Simulation::new(&model));
        if let Some(error) = signals.take() {
            return Err(error);
        }
        let simulation = simulation.map_err(|errors| refused(py, &errors, None))?;
        let simulation = Arc::new(simulation.heeding(signals.interrupt()));
        Ok(Self { simulation, data: value, analysis: model.analysis, every: model.output.every, signals })
    }

    /// The model as plain data; functions are those that a program supplies.
    #[getter]
    fn model<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        object(py, &self.data)
    }

    /// Kind of the analysis and, of a motion, its duration.
    #[getter]
    fn analysis(&self) -> (&'static str, Option<f64>) {
        match &self.analysis {
            Analysis::Dynamics(settings) => ("dynamics", Some(settings.duration)),
            Analysis::Statics(_) => ("statics", None),
            Analysis::Path(_) => ("path", None),
            Analysis::Modes(_) => ("modes", None),
            Analysis::Buckling(_) => ("buckling", None),
        }
    }

    /// Runs it; the results, in a dictionary.
    fn run<'py>(
        &self,
        py: Python<'py>,
        states: &str,
        callback: Option<Py<PyAny>>,
        tick: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let keep = Keep::named(states)?;
        let mut follower = Follower::new(&self.simulation, &self.signals, self.every, keep, [callback, tick]);
        let summary = py.detach(|| self.simulation.run(&mut follower))?;
        let results = PyDict::new(py);
        results.set_item("error", self.signals.take())?;
        results.set_item("failure", summary.outcome.failure(&self.analysis))?;
        results.set_item("summary", self.summary(py, &summary)?)?;
        let Follower { columns, rows, frames, .. } = follower;
        results.set_item("rows", table(py, rows, columns.len())?)?;
        results.set_item("columns", columns)?;
        results.set_item("states", States::new(&self.simulation, frames))?;
        Ok(results)
    }
}

impl Simulation {
    /// The summary as dictionaries, as in `summary.json`.
    fn summary<'py>(&self, py: Python<'py>, summary: &Summary) -> PyResult<Bound<'py, PyAny>> {
        let data = Value::try_from(summary);
        object(py, &data.map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?)
    }
}

/// Rows, one after the other, as an array of two dimensions; the numbers stay where they are.
fn table(py: Python<'_>, rows: Vec<f64>, columns: usize) -> PyResult<Bound<'_, PyArray2<f64>>> {
    let count = rows.len().checked_div(columns).unwrap_or(0);
    PyArray1::from_vec(py, rows).reshape([count, columns])
}
