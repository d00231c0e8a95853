use std::any::Any;
use std::cell::RefCell;
use std::ffi::{CStr, CString, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

use ancf::StepError;

use crate::status::Status;

/// Error of a function of the interface.
#[derive(Debug)]
pub(crate) struct Fault {
    status: Status,
    message: String,
}

impl Fault {
    pub(crate) fn new(status: Status, message: impl Into<String>) -> Self {
        Self { status, message: message.into() }
    }

    /// Error of an argument.
    pub(crate) fn argument(message: impl Into<String>) -> Self {
        Self::new(Status::Argument, message)
    }
}

impl From<StepError> for Fault {
    fn from(error: StepError) -> Self {
        let status = match error {
            StepError::Model(_) => Status::Model,
            StepError::Argument(_) => Status::Argument,
            StepError::Failed(_) | StepError::Interrupted => Status::Failed,
            StepError::Snapshot(_) => Status::Snapshot,
        };
        Self::new(status, error.to_string())
    }
}

thread_local! {
    static LAST: RefCell<CString> = RefCell::default();
}

/// Runs the body of a function: stores the message of an error, and converts a panic into an error.
pub(crate) fn guarded(body: impl FnOnce() -> Result<(), Fault>) -> Status {
    let done = catch_unwind(AssertUnwindSafe(body));
    let done = done.unwrap_or_else(|panic| Err(Fault::new(Status::Internal, text_of(panic.as_ref()))));
    match done {
        Ok(()) => Status::Ok,
        Err(Fault { status, message }) => {
            LAST.with_borrow_mut(|last| *last = c_text(message));
            status
        }
    }
}

fn text_of(panic: &(dyn Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    format!("internal error of ancf: {}", text.unwrap_or("unknown"))
}

/// Text without null characters.
pub(crate) fn c_text(text: impl Into<String>) -> CString {
    let text = text.into().replace('\0', "\u{fffd}");
    CString::new(text).unwrap_or_default()
}

/// Message of the last error of the calling thread, in UTF-8; empty if there was none.
///
/// The text is valid until the next call of a function of `ancf` by the thread. Calls without an error keep it.
#[expect(unsafe_code, reason = "exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn ancf_last_error() -> *const c_char {
    LAST.try_with(|last| last.try_borrow().map(|text| text.as_ptr()).unwrap_or(c"".as_ptr()))
        .unwrap_or_else(|_| CStr::as_ptr(c""))
}

#[cfg(test)]
mod tests {
    use std::panic::panic_any;

    use super::*;

    #[test]
    fn panics_become_errors() {
        let status = guarded(|| panic_any("a cause"));
        assert_eq!(status, Status::Internal);
        let message = LAST.with_borrow(|last| last.to_string_lossy().into_owned());
        assert_eq!(message, "internal error of ancf: a cause");
    }
}
