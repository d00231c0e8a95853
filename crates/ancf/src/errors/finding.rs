use super::error::ModelError;

/// An error and what decides whether and where it is reported.
#[derive(Debug)]
pub(crate) struct Finding {
    pub(crate) error: ModelError,
    /// Other paths it rests on: if one of them had to be mended, the finding means nothing.
    pub(crate) rests_on: Vec<String>,
    /// Whether something is not there, which an error of syntax may have hidden.
    pub(crate) absence: bool,
    /// Whether it is the key that is wrong, not its value.
    pub(crate) at_key: bool,
}

impl From<ModelError> for Finding {
    fn from(error: ModelError) -> Self {
        Self { error, rests_on: Vec::new(), absence: false, at_key: false }
    }
}

pub(crate) fn finding(path: String, found: impl Into<String>, wanted: impl Into<String>) -> Finding {
    ModelError::new(path, found, wanted).into()
}

impl Finding {
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.error = self.error.hint(hint);
        self
    }

    pub(crate) fn rests_on(self, paths: impl IntoIterator<Item = String>) -> Self {
        Self { rests_on: paths.into_iter().collect(), ..self }
    }
}
