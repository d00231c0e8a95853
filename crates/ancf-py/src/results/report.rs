//! HTML report of a result.

use ancf::Summary;
use ancf::estimate::BodyError;
use ancf::record::{Series, Sink};
use ancf_report::{BUDGET, Ending, Recording, Snapshot, page, scene, summary_rows, summary_warnings};
use numpy::PyReadonlyArray2;
use pyo3::prelude::*;
use toml::Value;

use crate::input::detached;
use crate::input::{DataReader, read_table, valid_model, value_error};
use crate::run::States;

/// Returns the page of a result from its states, the first numbers of their rows, all columns and the summary.
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
    let data = DataReader::default().model(states.model.bind(py))?;
    let model = valid_model(py, &data)?;
    let text = match &states.text {
        Some(text) => text.clone(),
        None => toml::to_string(&data).map_err(value_error)?,
    };
    let mut series = Series::new();
    series.begin(&columns)?;
    for row in rows.as_array().rows() {
        let _ = series.record(&row.to_vec())?;
    }
    let text_of_summary = SummaryText::new(read_table(summary)?, &model)?;
    let title = title.or_else(|| model.title.clone());
    let html = detached(py, || {
        let snapshot = |(state, value)| Snapshot { value, state };
        let recording = Recording {
            simulation: &states.simulation,
            model: &model,
            text: &text,
            title: title.as_deref().unwrap_or("ancf"),
            frames: states.all()?.into_iter().zip(values).map(snapshot).collect(),
            series: &series,
            summary: text_of_summary.rows,
            surfaces: &states.surfaces,
            body_errors: text_of_summary.body_errors,
            ending: text_of_summary.ending,
            messages: text_of_summary.messages,
            live: false,
        };
        Ok::<_, PyErr>(page(&scene(&recording, BUDGET)))
    })?;
    Ok(html)
}

/// Text of a summary.
struct SummaryText {
    rows: Vec<(String, String)>,
    body_errors: Vec<BodyError>,
    ending: Ending,
    messages: Vec<String>,
}

impl SummaryText {
    fn new(data: Value, model: &ancf::Model) -> PyResult<Self> {
        let text = |value: Option<&Value>| value.and_then(Value::as_str).unwrap_or_default().to_owned();
        let outcome = data.get("outcome");
        match text(outcome.and_then(|outcome| outcome.get("kind"))).as_str() {
            "running" => Ok(Self::unfinished(Ending::Running, Vec::new())),
            "broken" => {
                let messages = vec![text(outcome.and_then(|outcome| outcome.get("reason")))];
                Ok(Self::unfinished(Ending::Stopped, messages))
            }
            _ => {
                let mut rows = Vec::new();
                rows.extend(["model", "program"].map(|key| (key.to_owned(), text(data.get(key)))));
                let seconds = data.get("wall_seconds").and_then(Value::as_float);
                rows.extend(seconds.map(|seconds| ("seconds".to_owned(), format!("{seconds:.3}"))));
                rows.retain(|(_, value)| !value.is_empty());
                let summary: Summary = data.try_into().map_err(|error: toml::de::Error| {
                    value_error(format!("the summary of the result: {error}"))
                })?;
                rows.extend(summary_rows(&summary));
                let messages = summary_warnings(&summary);
                let ending = Ending::new(&summary.outcome, &model.analysis);
                let body_errors = summary.body_errors().to_vec();
                Ok(Self { rows, body_errors, ending, messages })
            }
        }
    }

    const fn unfinished(ending: Ending, messages: Vec<String>) -> Self {
        Self { rows: Vec::new(), body_errors: Vec::new(), ending, messages }
    }
}
