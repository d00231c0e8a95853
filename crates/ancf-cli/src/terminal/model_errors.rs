//! Errors of a model file as text: with source lines on a terminal, otherwise one line per error.

use std::io::{self, IsTerminal};

use ancf::model::ModelError;
use annotate_snippets::renderer::DecorStyle;
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

use super::colour::is_stderr_coloured;
use super::locale::is_unicode;

/// Maximum length of a label at its place. Longer texts are printed below the source line.
const LABEL_LENGTH: usize = 60;

/// Returns the errors of the model file `file`.
///
/// They are shown in the text of the file if standard error is a terminal or coloured, otherwise one per line as by compilers.
pub fn render(errors: &[ModelError], file: &str, text: &str) -> String {
    let is_coloured = is_stderr_coloured();
    if is_coloured || io::stderr().is_terminal() {
        snippets(errors, file, text, is_coloured)
    } else {
        lines(errors, file)
    }
}

/// Returns `file:line:column: path: found this, expected that (hint)`, one error per line.
fn lines(errors: &[ModelError], file: &str) -> String {
    let separator = |error: &ModelError| if error.at.is_some() { ":" } else { ": " };
    errors.iter().map(|error| format!("{file}{}{error}\n", separator(error))).collect()
}

/// Returns the errors with their source lines.
fn snippets(errors: &[ModelError], file: &str, text: &str, is_coloured: bool) -> String {
    let renderer = if is_coloured { Renderer::styled() } else { Renderer::plain() };
    let renderer = renderer.decor_style(if is_unicode() { DecorStyle::Unicode } else { DecorStyle::Ascii });
    let mut shown = String::new();
    for error in errors {
        shown += &renderer.render(&[report(error, file, text)]);
        shown += "\n\n";
    }
    let count = errors.len();
    shown + &format!("{file}: {count} error{}\n", if count == 1 { "" } else { "s" })
}

/// Returns an error as a report: the value found as title, the value required at its place, the hint below.
fn report<'a>(error: &'a ModelError, file: &'a str, text: &'a str) -> Group<'a> {
    let path = if error.path.is_empty() { file } else { &error.path };
    let hint = error.hint.iter().map(|hint| Level::HELP.message(hint.as_str()));
    if error.expected.is_empty() {
        return Level::ERROR.primary_title(format!("{path}: {}", error.found)).elements(hint);
    }
    let title = Level::ERROR.primary_title(format!("{path}: found {}", error.found));
    let expected = format!("expected {}", error.expected);
    // Positions refer to the file as it was read, which may have changed.
    let place = error
        .at
        .as_ref()
        .map(|at| at.bytes.clone())
        .filter(|place| !text.is_empty() && text.get(place.clone()).is_some());
    let Some(place) = place else {
        return title.element(Level::HELP.message(expected)).elements(hint);
    };
    let is_short = expected.chars().count() <= LABEL_LENGTH;
    let (label, below) = if is_short { (Some(expected), None) } else { (None, Some(expected)) };
    let annotation = AnnotationKind::Primary.span(place).label(label);
    let help = below.into_iter().chain(error.hint.clone()).map(|text| Level::HELP.message(text));
    title.element(Snippet::source(text).path(file).annotation(annotation)).elements(help)
}

#[cfg(test)]
mod tests {
    use ancf::Model;

    use super::*;

    #[test]
    fn lines_are_those_of_a_compiler() {
        let errors = Model::parse("gravity = [0, 1]\noutputs = 3").expect_err("no model");
        let lines = lines(&errors, "a.toml");
        assert!(
            lines.contains("\na.toml:1:11: gravity: found an array of 2, expected an array of 3 numbers\n"),
            "{lines}"
        );
        assert!(
            lines.ends_with(" (did you mean `output`?)\na.toml:2:11: outputs: found 3, expected a table\n"),
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
            "expected an array of 3 numbers",
            "a.toml:1:11",
            "a.toml:2:1",
            "1 | gravity = [0, 1] | ^^^^^^ expected an array of 3 numbers",
            "5 errors",
        ] {
            assert!(
                shown.replace("╰╴", "|").replace('│', "|").replace('━', "^").contains(part),
                "{part} is not in {shown}"
            );
        }
    }

    /// An error without a place, and one whose place is not in the text.
    #[test]
    fn errors_without_a_place_have_no_source_line() {
        let missing = ModelError::new("", "no such file", "").hint("a hint");
        let mut errors = Model::parse("gravity = 3").expect_err("no model").0;
        errors.insert(0, missing);
        let shown = snippets(&errors, "a.toml", "", false);
        assert!(shown.contains("error: a.toml: no such file"), "{shown}");
        assert!(shown.contains("a hint"), "{shown}");
        assert!(!shown.contains("a.toml:1:"), "{shown}");
    }
}
