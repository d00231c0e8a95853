//! Errors of a model, shown in its text.

use std::fmt::{self, Write};
use std::io::{self, IsTerminal};

use ancf::model::ModelError;
use miette::{
    Diagnostic, LabeledSpan, MietteDiagnostic, MietteHandler, MietteHandlerOpts, NamedSource, Report,
    ReportHandler,
};

use crate::colour;

/// The errors of the model file `file`: in its text, if stderr is a terminal or colours are wanted all the same, else one a
/// line as compilers do.
pub fn render(errors: &[ModelError], file: &str, text: &str) -> String {
    let is_colourful = colour::on_stderr();
    let is_shown = is_colourful || io::stderr().is_terminal();
    if is_shown { snippets(errors, file, text, is_colourful) } else { lines(errors, file) }
}

/// `file:line:column: path: found this, wanted that (hint)`, one error a line.
fn lines(errors: &[ModelError], file: &str) -> String {
    let separator = |error: &ModelError| if error.at.is_some() { ":" } else { ": " };
    errors.iter().map(|error| format!("{file}{}{error}\n", separator(error))).collect()
}

fn snippets(errors: &[ModelError], file: &str, text: &str, is_colourful: bool) -> String {
    let handler = MietteHandlerOpts::new().color(is_colourful).build();
    let mut shown = String::new();
    for error in errors {
        let report = report(error, file, text);
        writeln!(shown, "{}", Shown(&handler, report.as_ref())).expect("a String takes any text");
    }
    let count = errors.len();
    shown + &format!("{file}: {count} error{}\n", if count == 1 { "" } else { "s" })
}

/// The error as a report: found at the head, wanted at the place, a suggestion below.
fn report(error: &ModelError, file: &str, text: &str) -> Report {
    let path = if error.path.is_empty() { file } else { &error.path };
    let head = MietteDiagnostic::new(format!("{path}: found {}", error.found));
    let wanted = format!("wanted {}", error.wanted);
    let Some(at) = error.at.as_ref().filter(|at| at.bytes.end <= text.len()) else {
        let help = error.hint.iter().fold(wanted, |wanted, hint| format!("{wanted} ({hint})"));
        return Report::new(head.with_help(help));
    };
    // A label does not wrap, so that a long one goes below.
    let (label, below) =
        if wanted.chars().count() <= 60 { (Some(wanted), None) } else { (None, Some(wanted)) };
    let help = [below, error.hint.clone()].into_iter().flatten().collect::<Vec<_>>().join("; ");
    let head = head.with_label(LabeledSpan::new_with_span(label, at.bytes.clone()));
    let head = if help.is_empty() { head } else { head.with_help(help) };
    Report::new(head).with_source_code(NamedSource::new(file, text.to_owned()))
}

/// A diagnostic in the form of a handler.
struct Shown<'a>(&'a MietteHandler, &'a dyn Diagnostic);

impl fmt::Display for Shown<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.debug(self.1, f)
    }
}

#[cfg(test)]
mod tests {
    use ancf::model::Model;

    use super::*;

    #[test]
    fn lines_are_those_of_a_compiler() {
        let errors = Model::parse("gravity = [0, 1]\noutputs = 3").expect_err("no model");
        let lines = lines(&errors, "a.toml");
        assert!(
            lines.contains("\na.toml:1:11: gravity: found an array of 2, wanted an array of 3 numbers\n"),
            "{lines}"
        );
        assert!(
            lines.ends_with(" (did you mean `output`?)\na.toml:2:11: outputs: found 3, wanted a table\n"),
            "{lines}"
        );
    }

    #[test]
    fn snippets_show_all_there_is_to_say() {
        let text = "gravity = [0, 1]\noutputs = 3";
        let errors = Model::parse(text).expect_err("no model");
        let shown = snippets(&errors, "a.toml", text, false);
        let words: Vec<_> = shown.split_whitespace().collect();
        let shown = words.join(" ");
        for part in [
            "found unknown key `outputs`",
            "did you mean `output`?",
            "wanted an array of 3 numbers",
            "5 errors",
        ] {
            assert!(shown.contains(part), "{part} is not in {shown}");
        }
    }
}
