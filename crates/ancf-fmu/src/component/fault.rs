use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use ancf::{ModelErrors, StepError};

/// Severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Level {
    /// The result is valid.
    Warning,
    /// The step was not completed; the importer may continue in another way.
    Discard,
    /// The call had no effect.
    Error,
}

/// Error of a function of the standard.
#[derive(Clone, Debug)]
pub(crate) struct Fault {
    pub(crate) level: Level,
    pub(crate) message: String,
}

impl Fault {
    pub(crate) fn error(message: impl Into<String>) -> Self {
        Self { level: Level::Error, message: message.into() }
    }

    pub(crate) fn discard(message: impl Into<String>) -> Self {
        Self { level: Level::Discard, message: message.into() }
    }
}

impl From<StepError> for Fault {
    fn from(error: StepError) -> Self {
        Self::error(error.to_string())
    }
}

impl From<ModelErrors> for Fault {
    fn from(errors: ModelErrors) -> Self {
        Self::error(errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    }
}

/// Runs the body of a function and converts a panic into an error.
pub(crate) fn guarded<T>(body: impl FnOnce() -> Result<T, Fault>) -> Result<T, Fault> {
    let done = catch_unwind(AssertUnwindSafe(body));
    done.unwrap_or_else(|panic| Err(Fault::error(text_of(panic.as_ref()))))
}

fn text_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    format!("internal error of ancf: {}", text.unwrap_or("unknown"))
}

#[cfg(test)]
mod tests {
    use std::panic::panic_any;

    use super::*;

    #[test]
    fn panics_become_errors() {
        let fault = guarded::<()>(|| panic_any("a cause")).unwrap_err();
        assert_eq!(fault.message, "internal error of ancf: a cause");
    }
}
