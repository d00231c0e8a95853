//! Reasons why a file cannot be read.

use std::io;

/// Returns the reason why a file cannot be read.
pub fn read_failure(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file".into(),
        io::ErrorKind::IsADirectory => "a directory".into(),
        _ => error.to_string(),
    }
}
