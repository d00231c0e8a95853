use std::io::{ErrorKind, Read};
use std::path::Path;
use std::{fs, io};

use serde::de::DeserializeOwned;
use serde_json::Value as Json;
use toml::Value;

use super::check::judge;
use crate::errors::{Finding, ModelError, ModelErrors};
use crate::model::Model;
use crate::schema::{Document, SchemaCheck, position};

/// Bytes beyond which a file is taken for something else than a model.
const LARGEST: u64 = 100_000_000;

impl Model {
    /// Reads a model file and checks the model.
    ///
    /// # Errors
    /// All that is wrong, in the order of the text; or why the file cannot be read.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ModelErrors> {
        Self::parse(&Self::read_text(path)?)
    }

    /// Reads the text of a model file, for [`Model::parse`].
    ///
    /// # Errors
    /// Why the file cannot be read.
    pub fn read_text(path: impl AsRef<Path>) -> Result<String, ModelErrors> {
        let bytes = bytes_of(path.as_ref()).map_err(|error| ModelErrors(vec![unreadable(&error)]))?;
        if bytes.len() as u64 > LARGEST {
            return Err(ModelErrors(vec![too_large()]));
        }
        String::from_utf8(bytes).map_err(|error| ModelErrors(vec![not_utf8(error.as_bytes())]))
    }

    /// Reads the text of a model file and checks the model.
    ///
    /// # Errors
    /// All that is wrong, in the order of the text.
    ///
    /// ```
    /// let errors = ancf::Model::parse("gravity = [0, -9.81]").unwrap_err();
    /// assert_eq!(errors[2].to_string(), "1:11: gravity: found an array of 2, wanted an array of 3 numbers");
    /// ```
    pub fn parse(text: &str) -> Result<Self, ModelErrors> {
        judged(text, judge)
    }
}

/// Reads a TOML text of another type by the rules for model files: `schema` says what it may have, `rules` what else must hold.
///
/// The schema is that of the type by schemars, with all it consists of in place (`SchemaSettings::inline_subschemas`).
///
/// # Errors
/// All that is wrong, in the order of the text; broken rules only where the text has the form of the schema.
pub fn parse_as<T: DeserializeOwned>(
    text: &str,
    schema: &'static Json,
    rules: impl FnOnce(&T) -> Vec<ModelError>,
) -> Result<T, ModelErrors> {
    judged(text, |data| {
        let (survey, mended) = SchemaCheck::of(schema, data);
        let mut findings = survey.findings;
        match T::deserialize(mended) {
            Ok(value) if findings.is_empty() => {
                findings.extend(rules(&value).into_iter().map(Finding::from));
                (Some(value), findings)
            }
            Err(error) if findings.is_empty() => {
                (None, vec![ModelError::new("", error.to_string(), "the form of the schema").into()])
            }
            _ => (None, findings),
        }
    })
}

/// Reads a text, has its data judged, and puts what was found in its place.
fn judged<T>(text: &str, judge: impl FnOnce(&Value) -> (Option<T>, Vec<Finding>)) -> Result<T, ModelErrors> {
    let mut document = Document::parse(text);
    let (value, findings) = judge(&Value::Table(std::mem::take(&mut document.data)));
    let is_hidden = |finding: &Finding| finding.absence || document.is_spoilt(&finding.error.path);
    let findings = findings.into_iter().filter(|finding| document.errors.is_empty() || !is_hidden(finding));
    let mut errors: Vec<_> = findings.map(|finding| placed(finding, &document, text)).collect();
    errors.extend(document.errors);
    errors.sort_by_key(|error| error.at.as_ref().map(|at| at.bytes.start));
    value.filter(|_| errors.is_empty()).ok_or(ModelErrors(errors))
}

fn placed(finding: Finding, document: &Document, text: &str) -> ModelError {
    let bytes = document.find(&finding.error.path, finding.at_key);
    ModelError { at: Some(position(text, bytes)), ..finding.error }
}

/// The bytes of a file, no more than one beyond the largest number, be it a pipe that never ends.
fn bytes_of(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(LARGEST + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn too_large() -> ModelError {
    let (found, wanted) = ("more than 100 MB", "a model file of at most 100 MB");
    ModelError::new("", found, wanted)
        .hint("long bodies are one entry with many `elements`; series are `table`s of time")
}

fn unreadable(error: &io::Error) -> ModelError {
    let found = match error.kind() {
        ErrorKind::NotFound => "no such file".into(),
        ErrorKind::IsADirectory => "a directory".into(),
        ErrorKind::PermissionDenied => "a file that may not be read".into(),
        _ => error.to_string(),
    };
    ModelError::new("", found, "a model file")
}

fn not_utf8(bytes: &[u8]) -> ModelError {
    let valid = bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    let at = valid.len();
    let byte = bytes.get(at).copied().unwrap_or_default();
    let error = ModelError::new("", format!("the byte 0x{byte:02X}"), "a text in UTF-8");
    ModelError { at: Some(position(valid, at..at + 1)), ..error }
}
