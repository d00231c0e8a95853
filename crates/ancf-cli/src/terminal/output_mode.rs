//! Output of the program: results on standard output, messages on standard error.

use std::io::Write;
use std::sync::OnceLock;

use anstyle::{AnsiColor, Style};
use serde::Serialize;

use super::standard_output;

/// Output mode: quiet and JSON.
#[derive(Clone, Copy, Debug, Default)]
pub struct OutputMode {
    /// Prints only warnings and errors on standard error.
    pub quiet: bool,
    /// Prints one JSON object on standard output and nothing else.
    pub json: bool,
}

static OUTPUT_MODE: OnceLock<OutputMode> = OnceLock::new();

/// Sets the output mode, once, before any output.
pub fn set_output_mode(mode: OutputMode) {
    // Later calls have no effect.
    let _ = OUTPUT_MODE.set(mode);
}

fn output_mode() -> OutputMode {
    OUTPUT_MODE.get().copied().unwrap_or_default()
}

/// True if status messages are suppressed.
pub fn is_quiet() -> bool {
    output_mode().quiet
}

/// True if the output is JSON.
fn is_json() -> bool {
    output_mode().json
}

/// Prints a status message on standard error, unless `--quiet` is set.
pub fn print_status(line: &str) {
    if !is_quiet() {
        print_error(line);
    }
}

/// Prints an error or a warning on standard error.
pub fn print_error(line: &str) {
    let (head, style) = status_word(line);
    // A closed standard error is ignored.
    let _ = writeln!(anstream::stderr(), "{style}{head}{style:#}{}", &line[head.len()..]);
}

/// Prints a result as text on standard output, unless the output is JSON.
pub fn print(text: &str) {
    if !is_json() {
        print_output(text);
    }
}

/// Prints the output of a command on standard output. `main` reports an error ([`super::check_output`]).
pub fn print_output(text: &str) {
    standard_output::write(text);
}

/// Prints an object as JSON, if the output is JSON.
pub fn print_json(object: &impl Serialize) {
    if let (true, Ok(text)) = (is_json(), serde_json::to_string_pretty(object)) {
        print_output(&(text + "\n"));
    }
}

/// Returns the status word at the start of a message and its style.
fn status_word(line: &str) -> (&str, Style) {
    const WORDS: [(&str, AnsiColor); 6] = [
        ("error:", AnsiColor::Red),
        ("failed", AnsiColor::Red),
        ("warning:", AnsiColor::Yellow),
        ("stopped:", AnsiColor::Yellow),
        ("done:", AnsiColor::Green),
        ("tip:", AnsiColor::Cyan),
    ];
    let found = WORDS.into_iter().find(|(word, _)| line.starts_with(word));
    found.map_or(("", Style::new()), |(word, colour)| (word, colour.on_default().bold()))
}
