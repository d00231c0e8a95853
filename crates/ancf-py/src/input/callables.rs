//! Python callables as functions of time and forces of a model.

use ancf::Model;
use ancf::mechanics::functions::{ExternalFunction, ForceFunction, FunctionValue};
use ancf::mechanics::laws::{LawState, LawValue, UserForceLaw};
use ancf::model::{Joint, JointLaw, LawKind, Load, ModelErrors, Step, TimeFunction, Varying};
use ancf::units::Scales;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use toml::{Table, Value};

use super::errors::model_error;
use super::signals::Signals;
use super::threads::detached;

/// Callables in the data of a model, named by their paths.
#[derive(Debug, Default)]
pub(crate) struct Callables(Vec<Callable>);

#[derive(Debug)]
struct Callable {
    name: String,
    function: Py<PyAny>,
    role: CallableRole,
}

/// Role of a callable in a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CallableRole {
    /// Function of time f(t).
    Time,
    /// Force F(t, x, v), or force law f(t, x, v) of a joint.
    Force,
}

impl Callables {
    /// Adds a callable at a path and returns its name.
    pub(crate) fn name(&mut self, function: &Bound<'_, PyAny>, path: &str, role: CallableRole) -> String {
        self.0.push(Callable { name: path.to_owned(), function: function.clone().unbind(), role });
        path.to_owned()
    }

    /// Returns the path of the first callable.
    pub(crate) fn first(&self) -> Option<&str> {
        self.0.first().map(|one| one.name.as_str())
    }

    /// Returns the callable that a table names, if it has this role.
    pub(crate) fn function(&self, table: &Table, role: CallableRole) -> Option<&Py<PyAny>> {
        let name = table.get("name").filter(|_| table.get("kind").is_some_and(is_external))?.as_str()?;
        // A later callable at the same path replaces an earlier one.
        self.0.iter().rev().find(|one| one.role == role && one.name == name).map(|one| &one.function)
    }

    /// Supplies the callables to a model and calls `then` with it.
    ///
    /// Exceptions of callables end runs of the model. An exception within `then` is raised here.
    pub(crate) fn with<T: Send>(
        self,
        py: Python<'_>,
        mut model: Model,
        signals: &Signals,
        then: impl FnOnce(&Model) -> Result<T, ModelErrors> + Send,
    ) -> PyResult<(Model, T)> {
        self.supply(&mut model, signals);
        let done = detached(py, || then(&model));
        match (signals.take(), done) {
            (Some(error), _) => Err(error),
            (None, Ok(done)) => Ok((model, done)),
            (None, Err(errors)) => Err(model_error(py, &errors, None)),
        }
    }

    fn supply(self, model: &mut Model, signals: &Signals) {
        let step = model.analysis.dynamics().map_or(1.0, |settings| match settings.step {
            Step::Fixed(step) => step,
            Step::Adaptive { initial, .. } => initial.unwrap_or(1e-3 * settings.duration),
        });
        for Callable { name, function, role } in self.0 {
            let signals = signals.clone();
            if role == CallableRole::Force && model.loads.iter().any(|load| is_force(load, &name)) {
                let force = ForceCallable { name: name.clone(), function, signals };
                model.supply_force(&name, ForceFunction::new(move |t, x, v| force.at(t, x, v)));
            } else if role == CallableRole::Force
                && let Some((autonomous, kind, units)) =
                    model.joints.iter().find_map(|joint| is_law(joint, &name))
            {
                let length = if kind == LawKind::Moment { 1.0 } else { model.length() * units.length };
                let scales = [length, LAW_SPEED * length / (step * units.time)];
                let law = LawCallable { name: name.clone(), function, signals, scales };
                let law = UserForceLaw::with_derivatives(move |state| law.at(state), autonomous);
                model.supply_law(&name, law);
            } else {
                let step = (!model.loads.iter().any(|load| takes_value(load, &name)))
                    .then_some(step * DIFFERENCE_STEP);
                let function = TimeCallable { name: name.clone(), function, signals, step };
                model.supply(&name, ExternalFunction::new(move |t| function.at(t)));
            }
        }
    }
}

fn is_external(kind: &Value) -> bool {
    kind.as_str() == Some("external")
}

/// True if a load is the external force with a name.
fn is_force(load: &Load, name: &str) -> bool {
    matches!(load, Load::External(external) if external.name == name)
}

/// The key `autonomous`, the kind and the units of the external force law with a name, if a joint has one.
fn is_law(joint: &Joint, name: &str) -> Option<(bool, LawKind, Scales)> {
    joint.kind().laws().into_iter().find_map(|one| match one.law {
        JointLaw::External { name: own, autonomous, units, .. } if own == name => {
            Some((*autonomous, one.kind, *units))
        }
        _ => None,
    })
}

/// True if a load uses the value of the function with a name, but not its rates.
fn takes_value(load: &Load, name: &str) -> bool {
    let of_name = |time: &TimeFunction| match time {
        TimeFunction::Varying(Varying::External { name: own, .. }) => own == name,
        _ => false,
    };
    let its = load.time().is_some_and(of_name);
    its && !load.kind().uses_rates()
}

/// Step of finite differences relative to the time step, in which a resolved motion is smooth.
const DIFFERENCE_STEP: f64 = 0.02;

/// Callable of time.
struct TimeCallable {
    name: String,
    function: Py<PyAny>,
    signals: Signals,
    /// Step of finite differences, if rates are required.
    step: Option<f64>,
}

impl TimeCallable {
    /// Returns value and rates: those of the callable, or finite differences.
    fn at(&self, t: f64) -> FunctionValue {
        Python::attach(|py| self.evaluate(py, t)).unwrap_or_else(|error| {
            self.signals.raise(error);
            FunctionValue { value: f64::NAN, rate: f64::NAN, acceleration: f64::NAN }
        })
    }

    fn evaluate(&self, py: Python<'_>, t: f64) -> PyResult<FunctionValue> {
        let answer = self.function.call1(py, (t,))?.into_bound(py);
        let three = answer.extract::<[f64; 3]>().ok().filter(are_finite);
        if let Some([value, rate, acceleration]) = three {
            return Ok(FunctionValue { value, rate, acceleration });
        }
        let value = self.number(t, &answer)?;
        match self.step {
            None => Ok(FunctionValue { value, ..FunctionValue::default() }),
            Some(h) => self.differences(py, t, value, h),
        }
    }

    fn number(&self, t: f64, answer: &Bound<'_, PyAny>) -> PyResult<f64> {
        let number = answer.extract::<f64>().ok().filter(|number| number.is_finite());
        number
            .ok_or_else(|| invalid_answer(&self.name, t, answer, "a number, or value, rate and acceleration"))
    }

    /// Computes rates by finite differences of fourth order: central, near t = 0 forward, as negative times are undefined.
    fn differences(&self, py: Python<'_>, t: f64, value: f64, h: f64) -> PyResult<FunctionValue> {
        let of = |k: i32| {
            let there = t + f64::from(k) * h;
            self.number(there, &self.function.call1(py, (there,))?.into_bound(py))
        };
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
        Ok(FunctionValue { value, rate: rate / (12.0 * h), acceleration: acceleration / (12.0 * h * h) })
    }
}

/// Callable of time, position and velocity.
struct ForceCallable {
    name: String,
    function: Py<PyAny>,
    signals: Signals,
}

impl ForceCallable {
    fn at(&self, t: f64, x: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        let force = Python::attach(|py| {
            let (x, v) = (PyArray1::from_slice(py, &x), PyArray1::from_slice(py, &v));
            let answer = self.function.call1(py, (t, x, v))?.into_bound(py);
            let numbers = answer.extract::<[f64; 3]>().ok().filter(are_finite);
            numbers.ok_or_else(|| invalid_answer(&self.name, t, &answer, "three numbers"))
        });
        force.unwrap_or_else(|error| {
            self.signals.raise(error);
            [f64::NAN; 3]
        })
    }
}

/// Callable of time, coordinate and rate.
struct LawCallable {
    name: String,
    function: Py<PyAny>,
    signals: Signals,
    /// Smallest reference values of x and v for difference steps.
    scales: [f64; 2],
}

/// Relative step of central differences of a force law, the cube root of the rounding error.
const LAW_STEP: f64 = 6.055e-6;
/// Smallest reference rate, in reference values of x per time step.
const LAW_SPEED: f64 = 1e-3;

impl LawCallable {
    fn at(&self, state: LawState) -> LawValue {
        Python::attach(|py| self.evaluate(py, state)).unwrap_or_else(|error| {
            self.signals.raise(error);
            LawValue { force: f64::NAN, by_position: f64::NAN, by_rate: f64::NAN }
        })
    }

    /// Calls the function once if it returns the derivatives, else five times.
    fn evaluate(&self, py: Python<'_>, LawState { t, x, v }: LawState) -> PyResult<LawValue> {
        let answer = self.function.call1(py, (t, x, v))?.into_bound(py);
        let three = answer.extract::<[f64; 3]>().ok().filter(are_finite);
        if let Some([force, by_position, by_rate]) = three {
            return Ok(LawValue { force, by_position, by_rate });
        }
        let force = self.number(t, &answer)?;
        let of = |x: f64, v: f64| self.number(t, &self.function.call1(py, (t, x, v))?.into_bound(py));
        let [dx, dv] = [(x, 0), (v, 1)].map(|(size, k)| LAW_STEP * size.abs().max(self.scales[k]));
        let by_position = (of(x + dx, v)? - of(x - dx, v)?) / ((x + dx) - (x - dx));
        let by_rate = (of(x, v + dv)? - of(x, v - dv)?) / ((v + dv) - (v - dv));
        Ok(LawValue { force, by_position, by_rate })
    }

    fn number(&self, t: f64, answer: &Bound<'_, PyAny>) -> PyResult<f64> {
        let number = answer.extract::<f64>().ok().filter(|number| number.is_finite());
        let expected = "a number, or force, derivative by x and derivative by v";
        number.ok_or_else(|| invalid_answer(&self.name, t, answer, expected))
    }
}

fn are_finite(numbers: &[f64; 3]) -> bool {
    numbers.iter().all(|number| number.is_finite())
}

/// Creates the error of a callable with an invalid return value.
fn invalid_answer(name: &str, t: f64, answer: &Bound<'_, PyAny>, expected: &str) -> PyErr {
    let found = answer.repr().map_or_else(|_| "?".to_owned(), |text| text.to_string());
    let found: String = found.chars().take(80).collect();
    PyValueError::new_err(format!("{name} at t = {t}: found {found}, expected {expected}"))
}
