use std::fmt;
use std::ops::{Deref, Range};

/// Error in a model.
///
/// All errors of a model are reported together. The path states the key in the model file, such as `bodies[0].material`. The
/// position is known if the model was read from a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModelError {
    /// Path of the key, empty for the file as a whole.
    pub path: String,
    /// Value or problem that was found.
    pub found: String,
    /// Expected value; empty if `found` is a complete message.
    pub expected: String,
    /// Suggestion, such as the corrected key.
    pub hint: Option<String>,
    /// Position in the text.
    pub at: Option<Position>,
}

/// Position in the text of a model file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Position {
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Range of bytes of the text.
    pub bytes: Range<usize>,
}

impl ModelError {
    /// Error at `path`.
    pub fn new(path: impl Into<String>, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self { path: path.into(), found: found.into(), expected: expected.into(), hint: None, at: None }
    }

    /// Adds a suggestion.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(at) = &self.at {
            write!(f, "{}:{}: ", at.line, at.column)?;
        }
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path)?;
        }
        match self.expected.as_str() {
            "" => f.write_str(&self.found)?,
            expected => write!(f, "found {}, expected {expected}", self.found)?,
        }
        if let Some(hint) = &self.hint {
            write!(f, " ({hint})")?;
        }
        Ok(())
    }
}

impl std::error::Error for ModelError {}

/// All errors of a model, in the order of its text. Dereferences to a slice of [`ModelError`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ModelErrors(pub Vec<ModelError>);

impl Deref for ModelErrors {
    type Target = [ModelError];

    fn deref(&self) -> &[ModelError] {
        &self.0
    }
}

impl IntoIterator for ModelErrors {
    type Item = ModelError;
    type IntoIter = std::vec::IntoIter<ModelError>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl fmt::Display for ModelErrors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines: Vec<String> = self.iter().map(ToString::to_string).collect();
        f.write_str(&lines.join("\n"))
    }
}

impl std::error::Error for ModelErrors {}
