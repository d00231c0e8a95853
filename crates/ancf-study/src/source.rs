//! Study file and the model it names.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use ancf::{Model, ModelError, ModelErrors};
use toml::Value;

use crate::cases::BaseModel;
use crate::statement::{Study, read_failure};
use crate::table::StudyError;

/// Study with its text and the data of its model.
#[derive(Clone, Debug)]
pub struct StudySource {
    /// The study.
    pub study: Study,
    /// Text of the study file.
    pub text: String,
    /// Model of the study.
    pub base: BaseModel,
}

impl StudySource {
    /// Reads a study file and the model file that it names.
    ///
    /// # Errors
    /// If one of the files cannot be read or is invalid.
    pub fn read(file: &Path) -> Result<Self, StudyError> {
        let invalid = |path: PathBuf| move |errors: ModelErrors| StudyError::Invalid { path, errors };
        let text = fs::read_to_string(file)
            .map_err(|error| ModelErrors(vec![ModelError::new("", read_failure(&error), "a study file")]))
            .map_err(invalid(file.to_owned()))?;
        let folder = file.parent().unwrap_or(Path::new(""));
        let study = Study::parse(&text, folder).map_err(invalid(file.to_owned()))?;
        let path = folder.join(&study.model);
        let model = Model::read(&path).map_err(invalid(path.clone()))?;
        if model.starts_from().is_some() {
            let expected = "no results folder: every case of a study starts from its model alone";
            let error = ModelError::new("initial.from", "a results folder", expected);
            return Err(invalid(path)(ModelErrors(vec![error])));
        }
        let data = Model::read_text(&path)
            .map_err(io::Error::other)
            .and_then(|text| text.parse::<toml::Table>().map(Value::Table).map_err(io::Error::other))
            .map_err(|source| StudyError::File { action: "read", path: path.clone(), source })?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { study, text, base: BaseModel { data, folder } })
    }
}
