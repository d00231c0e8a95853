use ancf::Summary;
use ancf::record::{Series, Sink};
use ancf_report::{BUDGET, Ending, Frame, Recording, numbers, page, scene, warnings};
use numpy::PyReadonlyArray2;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use toml::Value;

use crate::data::{Data, table};
use crate::model::valid;
use crate::states::States;

/// The page of a result: its states with the first numbers of their rows, all columns, and how it ended.
#[pyfunction]
pub(crate) fn report(
    states: &Bound<'_, States>,
    columns: Vec<String>,
    rows: PyReadonlyArray2<'_, f64>,
    values: Vec<f64>,
    summary: &Bound<'_, PyAny>,
    title: Option<String>,
) -> PyResult<String> {
    let py = states.py();
    let states = states.get();
    let data = Data::default().model(states.model.bind(py))?;
    let model = valid(py, &data)?;
    let text = match &states.text {
        Some(text) => text.clone(),
        None => toml::to_string(&data).map_err(|error| PyValueError::new_err(error.to_string()))?,
    };
    let mut series = Series::new();
    series.begin(&columns)?;
    for row in rows.as_array().rows() {
        let _ = series.record(&row.to_vec())?;
    }
    let told = Told::of(table(summary)?, &model)?;
    let title = title.or_else(|| model.title.clone());
    let html = py.detach(|| {
        let frame = |(state, value)| Frame { value, state };
        let recording = Recording {
            simulation: &states.simulation,
            model: &model,
            text: &text,
            title: title.as_deref().unwrap_or("ancf"),
            frames: states.all()?.into_iter().zip(values).map(frame).collect(),
            series: &series,
            summary: told.summary,
            ending: told.ending,
            messages: told.messages,
            live: false,
        };
        Ok::<_, PyErr>(page(&scene(&recording, BUDGET)))
    })?;
    Ok(html)
}

/// What a summary says.
struct Told {
    summary: Vec<(String, String)>,
    ending: Ending,
    messages: Vec<String>,
}

impl Told {
    fn of(data: Value, model: &ancf::Model) -> PyResult<Self> {
        let text = |value: Option<&Value>| value.and_then(Value::as_str).unwrap_or_default().to_owned();
        let outcome = data.get("outcome");
        match text(outcome.and_then(|outcome| outcome.get("kind"))).as_str() {
            "running" => Ok(Self { summary: Vec::new(), ending: Ending::Running, messages: Vec::new() }),
            "broken" => {
                let messages = vec![text(outcome.and_then(|outcome| outcome.get("reason")))];
                Ok(Self { summary: Vec::new(), ending: Ending::Stopped, messages })
            }
            _ => {
                let mut named = Vec::new();
                named.extend(["model", "program"].map(|key| (key.to_owned(), text(data.get(key)))));
                let seconds = data.get("wall_seconds").and_then(Value::as_float);
                named.extend(seconds.map(|seconds| ("seconds".to_owned(), format!("{seconds:.3}"))));
                named.retain(|(_, value)| !value.is_empty());
                let summary: Summary = data.try_into().map_err(|error: toml::de::Error| {
                    PyValueError::new_err(format!("the summary of the result: {error}"))
                })?;
                named.extend(numbers(&summary));
                let messages = warnings(&summary);
                let ending = Ending::new(&summary.outcome, &model.analysis);
                Ok(Self { summary: named, ending, messages })
            }
        }
    }
}
