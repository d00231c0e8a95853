//! Docstrings from the descriptions in the schema.

use serde_json::Value as Json;

use super::form::{Key, alternatives, definition, description, forms, referred};
use super::names;

/// Maximum width of a line.
pub(super) const WIDTH: usize = 110;

/// Returns the description of a key with its limits, words and default value.
pub(super) fn meaning(schema: &Json, key: &Key) -> String {
    let text = description(key.schema).replace('\n', " ");
    let mut text = text.trim_end_matches('.').to_owned();
    let limits = limits(key.schema);
    if !limits.is_empty() {
        text += &format!(" ({limits})");
    }
    text.push('.');
    let words = words(schema, key.schema);
    if !words.is_empty() {
        text += &format!(" One of {}.", words.join(", "));
    }
    if let Some(value) = key.schema.get("default").filter(|_| !text.contains("by default")) {
        text += &format!(" Default: `{}`.", default(schema, key.schema, value));
    }
    text
}

fn limits(of: &Json) -> String {
    let signs = [("exclusiveMinimum", ">"), ("minimum", ">="), ("exclusiveMaximum", "<"), ("maximum", "<=")];
    let limits = signs.iter().filter(|(key, _)| !of[*key].is_null());
    limits.map(|(key, sign)| format!("{sign} {}", of[*key])).collect::<Vec<_>>().join(", ")
}

/// Returns the words that a key accepts.
fn words(schema: &Json, of: &Json) -> Vec<String> {
    let mut words = Vec::new();
    for form in alternatives(of) {
        if let Some(word) = form["const"].as_str() {
            words.push(format!("`\"{word}\"`"));
        } else if let Some(name) = referred(form) {
            let forms = alternatives(definition(schema, name));
            if forms.iter().all(|form| form["const"].is_string()) {
                words.extend(
                    forms.iter().filter_map(|form| Some(format!("`\"{}\"`", form["const"].as_str()?))),
                );
            }
        }
    }
    words
}

/// Formats a default value as Python code.
fn default(schema: &Json, of: &Json, value: &Json) -> String {
    match value {
        Json::Bool(yes) => if *yes { "True" } else { "False" }.into(),
        Json::Object(table) => {
            let name = referred(of).unwrap_or_default();
            let forms = forms(name, definition(schema, name));
            let is_own = |tag: Option<(&str, &str)>| tag.is_none_or(|(key, word)| value[key] == word);
            let Some(form) = forms.iter().find(|form| is_own(form.tag)) else { return value.to_string() };
            let given = form.keys.iter().filter_map(|key| Some((key, table.get(key.name)?)));
            let given: Vec<_> = given
                .map(|(key, value)| {
                    format!("{}={}", names::attribute(key.name), default(schema, key.schema, value))
                })
                .collect();
            format!("{}({})", form.class, given.join(", "))
        }
        Json::Array(items) => {
            let items: Vec<_> = items.iter().map(|item| default(schema, of, item)).collect();
            format!("[{}]", items.join(", "))
        }
        value => value.to_string(),
    }
}

/// Splits a text into the summary line and the paragraphs of a docstring.
pub(super) fn summary(text: &str, indent: usize) -> (String, String) {
    let (first, rest) = text.split_once("\n\n").unwrap_or((text, ""));
    let first = first.replace('\n', " ");
    let room = WIDTH - indent - 6;
    if first.chars().count() <= room {
        return (first, rest.to_owned());
    }
    let (head, tail) = sentence(&first)
        .into_iter()
        .chain([": ", "; "].iter().filter_map(|mark| first.split_once(mark)))
        .find(|(head, _)| head.chars().count() < room)
        .unwrap_or((&first, ""));
    let mut letters = tail.chars();
    let tail = letters.next().map(|letter| letter.to_uppercase().collect::<String>() + letters.as_str());
    let rest = [tail.unwrap_or_default(), rest.to_owned()];
    let rest: Vec<_> = rest.into_iter().filter(|text| !text.is_empty()).collect();
    (format!("{}.", head.trim_end_matches('.')), rest.join("\n\n"))
}

/// Splits off the first sentence. A full stop before a lower-case letter or a bracket does not end a sentence.
fn sentence(text: &str) -> Option<(&str, &str)> {
    let ends = text.match_indices(". ").map(|(at, _)| (&text[..at], &text[at + 2..]));
    ends.into_iter().find(|(_, rest)| rest.starts_with(char::is_uppercase))
}

/// Wraps a paragraph. The first line and the others have separate indents.
pub(super) fn wrapped(text: &str, first: usize, others: usize) -> String {
    let text = text.replace('`', "``").replace('\\', "\\\\");
    let mut lines = vec![" ".repeat(first)];
    let mut has_words = false;
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("the list starts with one line");
        if has_words && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(" ".repeat(others) + word);
        } else {
            if has_words {
                line.push(' ');
            }
            line.push_str(word);
        }
        has_words = true;
    }
    lines.join("\n") + "\n"
}
