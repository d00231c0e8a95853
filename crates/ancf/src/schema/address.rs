//! The text of a path in the data of a model: keys with dots between them, places in brackets.

use toml::{Table, Value};

use super::schema_check::join;
use crate::errors::ModelError;

/// A step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// To a key of a table, or to the item of this name.
    Key(String),
    /// To an item by its place from 0.
    Index(usize),
}

impl Step {
    /// What is there in a table or an array.
    pub(crate) fn of<'a>(&self, value: &'a Value) -> Option<&'a Value> {
        match self {
            Self::Key(key) => value.get(key),
            Self::Index(i) => value.get(i),
        }
    }
}

/// The steps as a path.
pub(crate) fn spelt<'a>(steps: impl IntoIterator<Item = &'a Step>) -> String {
    steps.into_iter().fold(String::new(), |path, step| match step {
        Step::Key(key) => join(&path, key),
        Step::Index(i) => format!("{path}[{i}]"),
    })
}

/// The steps of a path, at least one; keys with other signs than letters, digits, `_` and `-` may be in quotes, as in TOML.
pub(crate) fn segments(path: &str) -> Result<Vec<Step>, ModelError> {
    let wrong = |found: &str| {
        let hint = "such as `bodies.rod.elements` or `gravity[1]`";
        ModelError::new(path, found, "keys with dots between them and places in brackets").hint(hint)
    };
    let mut steps = Vec::new();
    let mut rest = path;
    loop {
        let (key, after) = key(rest).map_err(wrong)?;
        if key.is_empty() && !rest.starts_with(['"', '\'']) {
            return Err(wrong(if path.is_empty() { "an empty path" } else { "an empty key" }));
        }
        steps.push(Step::Key(key));
        rest = after;
        while let Some(bracket) = rest.strip_prefix('[') {
            let (index, after) =
                bracket.split_once(']').ok_or_else(|| wrong("a bracket that does not end"))?;
            let index = index.trim().parse().map_err(|_| wrong(&format!("`{index}` in brackets")))?;
            steps.push(Step::Index(index));
            rest = after;
        }
        match rest.strip_prefix('.') {
            Some(after) => rest = after,
            None if rest.is_empty() => return Ok(steps),
            None => return Err(wrong(&format!("`{rest}` after a bracket or quotes"))),
        }
    }
}

/// The key at the head of a text, and what follows it; or what is wrong with its quotes.
fn key(text: &str) -> Result<(String, &str), &'static str> {
    let unended = "quotes that do not end";
    if let Some(literal) = text.strip_prefix('\'') {
        return literal.split_once('\'').map(|(key, rest)| (key.to_owned(), rest)).ok_or(unended);
    }
    if let Some(quoted) = text.strip_prefix('"') {
        let end = closing(quoted).ok_or(unended)?;
        let key = unescaped(&quoted[..end]).ok_or("a backslash that TOML does not know")?;
        return Ok((key, &quoted[end + 1..]));
    }
    let end = text.find(['.', '[']).unwrap_or(text.len());
    Ok((text[..end].trim().to_owned(), &text[end..]))
}

/// The place of the first quote that no backslash stands before.
fn closing(text: &str) -> Option<usize> {
    let mut is_escaped = false;
    text.char_indices().find_map(|(i, c)| {
        let ends = c == '"' && !is_escaped;
        is_escaped = c == '\\' && !is_escaped;
        ends.then_some(i)
    })
}

/// A text with what its backslashes mean in TOML.
fn unescaped(text: &str) -> Option<String> {
    if !text.contains('\\') {
        return Some(text.to_owned());
    }
    let table: Table = format!("text = \"{text}\"").parse().ok()?;
    table["text"].as_str().map(ToOwned::to_owned)
}
