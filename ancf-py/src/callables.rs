use ancf::Model;
use ancf::function::{External, ForceFunction, Instant};
use ancf::model::{Load, Step, TimeFunction, Varying};
use pyo3::prelude::*;
use toml::{Table, Value};

use crate::signals::Signals;

/// Python's functions in the data of a model, by the names under which the model asks for them.
#[derive(Debug, Default)]
pub(crate) struct Callables(Vec<Callable>);

#[derive(Debug)]
struct Callable {
    name: String,
    function: Py<PyAny>,
    role: Role,
}

/// What the model wants of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Role {
    /// f(t).
    Time,
    /// F(t, x, v).
    Force,
}

impl Callables {
    /// The name of a function that was met at a path.
    pub(crate) fn name(&mut self, function: &Bound<'_, PyAny>, path: &str, role: Role) -> String {
        self.0.push(Callable { name: path.to_owned(), function: function.clone().unbind(), role });
        path.to_owned()
    }

    /// The function that a table asks for, if it was met in this role.
    pub(crate) fn function(&self, table: &Table, role: Role) -> Option<&Py<PyAny>> {
        let name = table.get("name").filter(|_| table.get("kind").is_some_and(is_external))?.as_str()?;
        self.0.iter().find(|one| one.role == role && one.name == name).map(|one| &one.function)
    }

    /// Gives them to the model; what they raise ends its runs.
    pub(crate) fn supply(self, model: &mut Model, signals: &Signals) {
        let step = model.analysis.dynamics().map_or(1.0, |settings| match settings.step {
            Step::Fixed(step) => step,
            Step::Adaptive { initial, .. } => initial.unwrap_or(1e-3 * settings.duration),
        });
        for Callable { name, function, role } in self.0 {
            let signals = signals.clone();
            if role == Role::Force {
                let force = move |t, x, v| force(&function, &signals, t, x, v);
                model.supply_force(&name, ForceFunction::new(force));
            } else {
                let step = (!model.loads.iter().any(|load| takes_value(load, &name))).then_some(step * FINE);
                let course = Course { function, signals, step };
                model.supply(&name, External::new(move |t| course.at(t)));
            }
        }
    }
}

fn is_external(kind: &Value) -> bool {
    kind.as_str() == Some("external")
}

/// Whether a load takes the value of the function of a name, and no rates.
fn takes_value(load: &Load, name: &str) -> bool {
    let time = load.time();
    let its = matches!(time, TimeFunction::Varying(Varying::External { name: own, .. }) if own == name);
    its && !matches!(load, Load::Fluid(_))
}

/// Rates by differences are taken over so much of a step, in which a motion that the steps resolve is smooth.
const FINE: f64 = 0.02;

/// A function of time.
struct Course {
    function: Py<PyAny>,
    signals: Signals,
    /// Between the times from which rates are computed, if they are wanted.
    step: Option<f64>,
}

impl Course {
    /// Value and rates: those that the function tells, or by differences.
    fn at(&self, t: f64) -> Instant {
        let told = Python::attach(|py| {
            let answer = self.function.call1(py, (t,))?;
            if let Ok((value, rate, acceleration)) = answer.extract(py) {
                return Ok(Instant { value, rate, acceleration });
            }
            let value = answer.extract(py)?;
            self.step
                .map_or(Ok(Instant { value, ..Instant::default() }), |h| self.differences(py, t, value, h))
        });
        told.unwrap_or_else(|error| {
            self.signals.raise(error);
            Instant { value: f64::NAN, rate: f64::NAN, acceleration: f64::NAN }
        })
    }

    /// Rates from five values, central ones of fourth order; near 0, before which nothing is known, those ahead.
    fn differences(&self, py: Python<'_>, t: f64, value: f64, h: f64) -> PyResult<Instant> {
        let of = |k: i32| self.function.call1(py, (t + f64::from(k) * h,))?.extract::<f64>(py);
        let (rate, acceleration) = if t < 2.0 * h {
            let [f1, f2, f3, f4] = [of(1)?, of(2)?, of(3)?, of(4)?];
            (
                -25.0 * value + 48.0 * f1 - 36.0 * f2 + 16.0 * f3 - 3.0 * f4,
                35.0 * value - 104.0 * f1 + 114.0 * f2 - 56.0 * f3 + 11.0 * f4,
            )
        } else {
            let [a, b, c, d] = [of(-2)?, of(-1)?, of(1)?, of(2)?];
            (a - 8.0 * b + 8.0 * c - d, -a + 16.0 * b - 30.0 * value + 16.0 * c - d)
        };
        Ok(Instant { value, rate: rate / (12.0 * h), acceleration: acceleration / (12.0 * h * h) })
    }
}

fn force(function: &Py<PyAny>, signals: &Signals, t: f64, x: [f64; 3], v: [f64; 3]) -> [f64; 3] {
    let told = Python::attach(|py| {
        let (x, v) = (numpy::PyArray1::from_slice(py, &x), numpy::PyArray1::from_slice(py, &v));
        function.call1(py, (t, x, v))?.extract::<[f64; 3]>(py)
    });
    told.unwrap_or_else(|error| {
        signals.raise(error);
        [f64::NAN; 3]
    })
}
