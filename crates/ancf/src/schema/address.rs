//! Text of a path in the data of a model: keys separated by dots, indices in brackets.

use toml::{Table, Value};

use super::schema_check::join;
use crate::errors::ModelError;

/// Step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum PathStep {
    /// Key of a table, or name of an item.
    Key(String),
    /// Index of an item, from 0.
    Index(usize),
}

impl PathStep {
    /// Value in a table or an array.
    pub(crate) fn of<'a>(&self, value: &'a Value) -> Option<&'a Value> {
        match self {
            Self::Key(key) => value.get(key),
            Self::Index(i) => value.get(i),
        }
    }
}

/// Text of a path.
pub(crate) fn path_of<'a>(steps: impl IntoIterator<Item = &'a PathStep>) -> String {
    steps.into_iter().fold(String::new(), |path, step| match step {
        PathStep::Key(key) => join(&path, key),
        PathStep::Index(i) => format!("{path}[{i}]"),
    })
}

/// Steps of a path, at least one. Keys with other characters than letters, digits, `_` and `-` are in quotes, as in TOML.
pub(crate) fn path_steps(path: &str) -> Result<Vec<PathStep>, ModelError> {
    let wrong = |found: &str| {
        let hint = "such as `bodies.rod.elements` or `gravity[1]`";
        ModelError::new(path, found, "keys separated by dots, and indices in brackets").hint(hint)
    };
    let mut steps = Vec::new();
    let mut rest = path;
    loop {
        let (key, after) = key(rest).map_err(wrong)?;
        if key.is_empty() && !rest.starts_with(['"', '\'']) {
            return Err(wrong(if path.is_empty() { "an empty path" } else { "an empty key" }));
        }
        steps.push(PathStep::Key(key));
        rest = after;
        while let Some(bracket) = rest.strip_prefix('[') {
            let (index, after) =
                bracket.split_once(']').ok_or_else(|| wrong("a bracket that does not end"))?;
            let index = index.trim().parse().map_err(|_| wrong(&format!("`{index}` in brackets")))?;
            steps.push(PathStep::Index(index));
            rest = after;
        }
        match rest.strip_prefix('.') {
            Some(after) => rest = after,
            None if rest.is_empty() => return Ok(steps),
            None => return Err(wrong(&format!("`{rest}` after a bracket or quotes"))),
        }
    }
}

/// Splits the first key from a text; the error states what is wrong with its quotes.
fn key(text: &str) -> Result<(String, &str), &'static str> {
    let unended = "quotes that do not end";
    if let Some(literal) = text.strip_prefix('\'') {
        return literal.split_once('\'').map(|(key, rest)| (key.to_owned(), rest)).ok_or(unended);
    }
    if let Some(quoted) = text.strip_prefix('"') {
        let end = closing_quote(quoted).ok_or(unended)?;
        let key = unescaped(&quoted[..end]).ok_or("an invalid escape sequence")?;
        return Ok((key, &quoted[end + 1..]));
    }
    let end = text.find(['.', '[']).unwrap_or(text.len());
    Ok((text[..end].trim().to_owned(), &text[end..]))
}

/// Position of the first quote that is not escaped.
fn closing_quote(text: &str) -> Option<usize> {
    let mut is_escaped = false;
    text.char_indices().find_map(|(i, c)| {
        let ends = c == '"' && !is_escaped;
        is_escaped = c == '\\' && !is_escaped;
        ends.then_some(i)
    })
}

/// Resolves the escape sequences of TOML in a text.
fn unescaped(text: &str) -> Option<String> {
    if !text.contains('\\') {
        return Some(text.to_owned());
    }
    let table: Table = format!("text = \"{text}\"").parse().ok()?;
    table["text"].as_str().map(ToOwned::to_owned)
}
