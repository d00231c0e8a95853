//! Texts of the schema as documentation of Python.

use serde_json::Value as Json;

use super::form::{Key, alternatives, definition, description, forms, referred};
use super::names;

/// Width of a line.
pub(super) const WIDTH: usize = 110;

/// What a key means, what it allows and what it is by default.
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

/// The words among which a key chooses.
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

/// A default value as it is written in Python.
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

/// A text as the first line and the paragraphs of a docstring.
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

/// The first sentence and the rest; a full stop before a small letter or a bracket ends none.
fn sentence(text: &str) -> Option<(&str, &str)> {
    let ends = text.match_indices(". ").map(|(at, _)| (&text[..at], &text[at + 2..]));
    ends.into_iter().find(|(_, rest)| rest.starts_with(char::is_uppercase))
}

/// A paragraph in lines with an indent; those after the first have another.
pub(super) fn wrapped(text: &str, first: usize, others: usize) -> String {
    let text = text.replace('`', "``").replace('\\', "\\\\");
    let mut lines = vec![" ".repeat(first)];
    let mut is_begun = false;
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is a first line");
        if is_begun && line.chars().count() + 1 + word.chars().count() > WIDTH {
            lines.push(" ".repeat(others) + word);
        } else {
            if is_begun {
                line.push(' ');
            }
            line.push_str(word);
        }
        is_begun = true;
    }
    lines.join("\n") + "\n"
}
