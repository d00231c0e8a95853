//! Errors and warnings of a model text.

use ancf::ModelError;
use ancf::reading::ValidModel;
use serde::Serialize;

/// Error or warning of a model text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Problem {
    /// Severity.
    pub severity: Severity,
    /// Line, from 1; 1 if the place is unknown.
    pub line: usize,
    /// Column in characters, from 1; 1 if the place is unknown.
    pub column: usize,
    /// Number of characters of the wrong text; 0 if the place is unknown.
    pub length: usize,
    /// Message.
    pub message: String,
}

/// Severity of a problem.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Severity {
    /// The model cannot run.
    Error,
    /// The model can run.
    Warning,
}

/// Returns all errors of a model text in their order, or its warnings.
pub fn problems(text: &str) -> Vec<Problem> {
    match ValidModel::parse(text).and_then(|model| model.diagnose()) {
        Ok(diagnosis) => diagnosis.warnings.into_iter().map(warning).collect(),
        Err(errors) => errors.iter().map(|error| located(error, text)).collect(),
    }
}

fn warning(message: String) -> Problem {
    Problem { severity: Severity::Warning, line: 1, column: 1, length: 0, message }
}

fn located(error: &ModelError, text: &str) -> Problem {
    let message = ModelError { at: None, ..error.clone() }.to_string();
    let place = error.at.as_ref();
    let length = place.and_then(|at| text.get(at.bytes.clone())).map_or(0, |wrong| wrong.chars().count());
    let [line, column] = place.map_or([1, 1], |at| [at.line, at.column]);
    Problem { severity: Severity::Error, line, column, length, message }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_have_their_places() {
        let found = problems("gravity = [0, 1]\noutputs = 3");
        let at = |line| found.iter().find(|problem| problem.line == line && problem.length > 0);
        let gravity = at(1).expect("an error in line 1");
        assert_eq!((gravity.column, gravity.length), (11, 6));
        assert!(gravity.message.starts_with("gravity: found an array of 2"), "{}", gravity.message);
        assert!(at(2).expect("an error in line 2").message.contains("did you mean `output`?"));
    }

    #[test]
    fn models_without_errors_have_warnings_at_most() {
        let text = include_str!("../../../models/cantilever.toml");
        assert!(problems(text).iter().all(|problem| problem.severity == Severity::Warning));
    }
}
