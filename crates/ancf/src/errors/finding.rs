use ancf_mechanics::functions::ExpressionError;
use nalgebra::Vector3;

use super::error::ModelError;
use super::words::{number, quoted};

/// Error of a model, with the conditions under which it is reported.
#[derive(Debug)]
pub struct Finding {
    /// Error of the model.
    pub error: ModelError,
    /// Paths on which the finding depends. If one of them has an error, the finding is not reported.
    pub rests_on: Vec<String>,
    /// True if a part is missing. A syntax error may hide it.
    pub absence: bool,
    /// True if the key is wrong, not its value.
    pub at_key: bool,
}

impl From<ModelError> for Finding {
    fn from(error: ModelError) -> Self {
        Self { error, rests_on: Vec::new(), absence: false, at_key: false }
    }
}

/// Finding at the path of a key, with the found and the expected value.
pub fn finding(path: String, found: impl Into<String>, expected: impl Into<String>) -> Finding {
    ModelError::new(path, found, expected).into()
}

impl Finding {
    /// Adds a suggestion.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.error = self.error.hint(hint);
        self
    }

    /// Sets the paths on which the finding depends.
    #[must_use]
    pub fn rests_on(self, paths: impl IntoIterator<Item = String>) -> Self {
        Self { rests_on: paths.into_iter().collect(), ..self }
    }
}

/// True if a vector has a direction: its norm is a normal number.
pub(crate) fn is_direction(vector: [f64; 3]) -> bool {
    Vector3::from(vector).norm().is_normal()
}

/// Finding for a vector without direction.
pub(crate) fn no_direction(path: String, vector: [f64; 3]) -> Finding {
    finding(path, format!("a vector of length {}", number(Vector3::from(vector).norm())), "a direction")
}

/// Finding for a syntax error of a formula.
pub(crate) fn formula_error(path: String, text: &str, error: ExpressionError) -> Finding {
    let rest: String = text.chars().skip(error.at).collect();
    let found = match rest.as_str() {
        "" => "its end".to_owned(),
        rest => quoted(rest),
    };
    let found = format!("{found} at character {}", error.at + 1);
    finding(path, found, error.expected)
}
