//! Models with several analyses.

use std::path::{Path, PathBuf};

use ancf::Model;
use ancf::model::ModelErrors;
use ancf::reading::{AnalysisSequence, SequenceStage};
use pyo3::prelude::*;
use toml::Value;

use super::data::to_python;
use super::errors::model_error;
use super::model::{resolve_files, to_toml};

/// Analysis of a list, with a model of its own.
#[pyclass(frozen, module = "ancf._ancf")]
#[derive(Debug)]
pub(crate) struct Stage {
    stage: SequenceStage,
    /// Model file, if it was read from one.
    file: Option<PathBuf>,
}

#[pymethods]
impl Stage {
    /// Name of the analysis.
    #[getter]
    fn name(&self) -> &str {
        &self.stage.name
    }

    /// Name of the results folder, by which later analyses state where they start.
    #[getter]
    fn folder(&self) -> &str {
        &self.stage.folder
    }

    /// Returns the data of the model, whose motion starts at a time.
    fn data<'py>(&self, py: Python<'py>, start_time: f64) -> PyResult<Bound<'py, PyAny>> {
        let mut data = self.stage.data(start_time);
        if let Some(file) = &self.file {
            resolve_files(&mut data, file);
        }
        to_python(py, &Value::Table(data))
    }
}

/// Returns the analyses of a model file with a list of them; none of a file with a single one.
#[pyfunction]
pub(crate) fn stages_of_file(py: Python<'_>, path: PathBuf) -> PyResult<Vec<Stage>> {
    let name = path.display().to_string();
    let stages = Model::read_text(&path).and_then(|text| stages_of(&text));
    let stages = stages.map_err(|errors| model_error(py, &errors, Some(&name)))?;
    let file = std::path::absolute(&path)?;
    Ok(with_file(stages, Some(&file)))
}

/// Returns the analyses of the data of a model with a list of them; none of a single one.
#[pyfunction]
pub(crate) fn stages(data: &Bound<'_, PyAny>) -> PyResult<Vec<Stage>> {
    let stages = stages_of(&to_toml(data)?).map_err(|mut errors| {
        // Places are those of a text that nobody has written.
        errors.0.iter_mut().for_each(|error| error.at = None);
        model_error(data.py(), &errors, None)
    })?;
    Ok(with_file(stages, None))
}

fn stages_of(text: &str) -> Result<Vec<SequenceStage>, ModelErrors> {
    Ok(AnalysisSequence::parse(text)?.map_or_else(Vec::new, |sequence| sequence.stages))
}

fn with_file(stages: Vec<SequenceStage>, file: Option<&Path>) -> Vec<Stage> {
    stages.into_iter().map(|stage| Stage { stage, file: file.map(Path::to_owned) }).collect()
}
