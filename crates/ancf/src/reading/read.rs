use std::io::{ErrorKind, Read};
use std::path::Path;
use std::{fs, io};

use serde::de::DeserializeOwned;
use serde_json::Value as Json;
use toml::Value;

use super::check::check_data;
use super::meshes::embed_meshes;
use crate::errors::{Finding, ModelError, ModelErrors};
use crate::model::Model;
use crate::schema::{Document, SchemaCheck, position};

/// Maximum size of a model file in bytes.
const MAX_BYTES: u64 = 100_000_000;

impl Model {
    /// Reads a model file and checks the model.
    ///
    /// # Errors
    /// All errors of the model, in the order of the text; or the reason why the file cannot be read.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, ModelErrors> {
        Self::parse(&Self::read_text(path)?)
    }

    /// Reads the text of a model file, for [`Model::parse`]. Paths of mesh files are replaced by the texts of the files.
    ///
    /// # Errors
    /// The reason why the file or a mesh file cannot be read.
    pub fn read_text(path: impl AsRef<Path>) -> Result<String, ModelErrors> {
        let path = path.as_ref();
        let file = fs::File::open(path).map_err(|error| ModelErrors(vec![unreadable(&error)]))?;
        embed_meshes(Self::read_text_from(file)?, path.parent().unwrap_or(Path::new("")))
    }

    /// Reads the text of a model from a stream, such as standard input.
    ///
    /// # Errors
    /// The reason why the text cannot be read.
    pub fn read_text_from(stream: impl Read) -> Result<String, ModelErrors> {
        // At most one byte more than the maximum size, since a pipe may be endless.
        let mut bytes = Vec::new();
        let read = stream.take(MAX_BYTES + 1).read_to_end(&mut bytes);
        read.map_err(|error| ModelErrors(vec![unreadable(&error)]))?;
        if bytes.len() as u64 > MAX_BYTES {
            return Err(ModelErrors(vec![too_large()]));
        }
        String::from_utf8(bytes).map_err(|error| ModelErrors(vec![not_utf8(error.as_bytes())]))
    }

    /// Reads the text of a model file and checks the model.
    ///
    /// # Errors
    /// All errors of the model, in the order of the text.
    ///
    /// ```
    /// let errors = ancf::Model::parse("gravity = [0, -9.81]").unwrap_err();
    /// assert_eq!(errors[2].to_string(), "1:11: gravity: found an array of 2, expected an array of 3 numbers");
    /// ```
    pub fn parse(text: &str) -> Result<Self, ModelErrors> {
        read_document(Document::parse(text), text)
    }
}

/// Reads the model of a parsed text and checks it.
pub(super) fn read_document(document: Document, text: &str) -> Result<Model, ModelErrors> {
    checked(document, text, check_data)
}

/// Reads a TOML text of another type like a model file. `schema` states the form of the data, `rules` returns violated rules.
///
/// The schema is the schemars schema of the type without references (`SchemaSettings::inline_subschemas`).
///
/// # Errors
/// All errors of the data, in the order of the text. Rules are checked only if the data satisfy the schema.
pub fn parse_as<T: DeserializeOwned>(
    text: &str,
    schema: &'static Json,
    rules: impl FnOnce(&T) -> Vec<ModelError>,
) -> Result<T, ModelErrors> {
    checked(Document::parse(text), text, |data| {
        let (check, corrected) = SchemaCheck::of(schema, data);
        let mut findings = check.findings;
        match T::deserialize(corrected) {
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

/// Checks the data of a parsed text, and locates the findings in the text.
fn checked<T>(
    mut document: Document,
    text: &str,
    check: impl FnOnce(Value) -> (Option<T>, Vec<Finding>),
) -> Result<T, ModelErrors> {
    let (value, findings) = check(Value::Table(std::mem::take(&mut document.data)));
    let is_hidden = |finding: &Finding| finding.absence || document.has_syntax_error(&finding.error.path);
    let findings = findings.into_iter().filter(|finding| document.errors.is_empty() || !is_hidden(finding));
    let mut errors: Vec<_> = findings.map(|finding| located(finding, &document, text)).collect();
    errors.extend(document.errors);
    errors.sort_by_key(|error| error.at.as_ref().map(|at| at.bytes.start));
    value.filter(|_| errors.is_empty()).ok_or(ModelErrors(errors))
}

/// Adds the places in the text of a model file to errors without positions.
#[must_use]
pub fn with_places(errors: ModelErrors, text: &str) -> ModelErrors {
    let document = Document::parse(text);
    ModelErrors(errors.0.into_iter().map(|error| located(error.into(), &document, text)).collect())
}

pub(super) fn located(finding: Finding, document: &Document, text: &str) -> ModelError {
    let bytes = document.find(&finding.error.path, finding.at_key);
    ModelError { at: Some(position(text, bytes)), ..finding.error }
}

fn too_large() -> ModelError {
    let (found, expected) = ("more than 100 MB", "a model file of at most 100 MB");
    ModelError::new("", found, expected)
        .hint("long bodies are one entry with many `elements`; series are `table`s of time")
}

fn unreadable(error: &io::Error) -> ModelError {
    let found = match error.kind() {
        ErrorKind::NotFound => "no such file".into(),
        ErrorKind::IsADirectory => "a directory, not a model file".into(),
        ErrorKind::PermissionDenied => "no read permission".into(),
        _ => error.to_string(),
    };
    ModelError::new("", found, "")
}

fn not_utf8(bytes: &[u8]) -> ModelError {
    let valid = bytes.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    let at = valid.len();
    let byte = bytes.get(at).copied().unwrap_or_default();
    let error = ModelError::new("", format!("the byte 0x{byte:02X}"), "a text in UTF-8");
    ModelError { at: Some(position(valid, at..at + 1)), ..error }
}
