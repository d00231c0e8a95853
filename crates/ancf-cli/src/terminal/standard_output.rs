//! Standard output. All commands write through [`write`]; `main` reports the first error.

use std::io::{self, Write};
use std::sync::{Mutex, PoisonError};

/// Kind of the first error of standard output, with its message.
static FIRST_ERROR: Mutex<Option<(io::ErrorKind, String)>> = Mutex::new(None);

/// Writes text to standard output, without a delay in a buffer. The first error is stored for [`check_output`].
pub(super) fn write(text: &str) {
    let mut stream = anstream::stdout();
    // Without the flush, text without a line feed is written at the end of the process, where errors are ignored.
    if let Err(error) = stream.write_all(text.as_bytes()).and_then(|()| stream.flush()) {
        let mut first = FIRST_ERROR.lock().unwrap_or_else(PoisonError::into_inner);
        first.get_or_insert_with(|| (error.kind(), error.to_string()));
    }
}

/// Returns the first error of standard output. A closed pipe is not an error: its reader has read enough.
///
/// # Errors
/// If text could not be written, for example on a full disk.
pub fn check_output() -> io::Result<()> {
    let first = FIRST_ERROR.lock().unwrap_or_else(PoisonError::into_inner);
    match &*first {
        Some((kind, message)) if *kind != io::ErrorKind::BrokenPipe => {
            Err(io::Error::new(*kind, format!("cannot write to standard output: {message}")))
        }
        _ => Ok(()),
    }
}
