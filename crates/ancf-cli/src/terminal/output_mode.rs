//! What the program says: what was asked for on standard output, news and complaints on standard error.

use std::io::Write;
use std::sync::OnceLock;

use anstyle::{AnsiColor, Style};
use serde::Serialize;

/// How the user wants to be talked to.
#[derive(Clone, Copy, Debug, Default)]
pub struct Manners {
    /// Nothing on standard error but what went wrong.
    pub quiet: bool,
    /// One JSON object on standard output and nothing else.
    pub json: bool,
}

static MANNERS: OnceLock<Manners> = OnceLock::new();

/// Chooses the manners, once, before anything is said.
pub fn choose(manners: Manners) {
    // A second choice would be a mistake; the first one holds.
    let _ = MANNERS.set(manners);
}

fn manners() -> Manners {
    MANNERS.get().copied().unwrap_or_default()
}

/// Whether only what went wrong is to be said.
pub fn is_quiet() -> bool {
    manners().quiet
}

/// Whether the answer is to be JSON.
pub fn is_json() -> bool {
    manners().json
}

/// Tells news on standard error, unless it is to be quiet.
pub fn say(line: &str) {
    if !is_quiet() {
        complain(line);
    }
}

/// Says what went wrong on standard error.
pub fn complain(line: &str) {
    let (head, style) = headline(line);
    // Nothing is left to be done if standard error is closed.
    let _ = writeln!(anstream::stderr(), "{style}{head}{style:#}{}", &line[head.len()..]);
}

/// Prints for people on standard output, unless the answer is to be JSON; a closed pipe is no error.
pub fn print(text: &str) {
    if !is_json() {
        deliver(text);
    }
}

/// Prints what was asked for on standard output; a closed pipe is no error.
pub fn deliver(text: &str) {
    let _ = anstream::stdout().write_all(text.as_bytes());
}

/// Prints the answer as JSON, if it is wanted so.
pub fn answer(object: &impl Serialize) {
    if let (true, Ok(text)) = (is_json(), serde_json::to_string_pretty(object)) {
        deliver(&(text + "\n"));
    }
}

/// The word that a message begins with if it says how things stand, and how the word looks.
fn headline(line: &str) -> (&str, Style) {
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
