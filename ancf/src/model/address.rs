//! The text of a path in the data of a model: keys with dots between them, places in brackets.

use toml::Value;

use super::ModelError;
use super::survey::join;

/// A step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// To a key of a table, or to the item of this name.
    Key(String),
    /// To an item by its place from 0.
    Index(usize),
}

impl Step {
    /// What is there in a table or an array.
    pub(super) fn of<'a>(&self, value: &'a Value) -> Option<&'a Value> {
        match self {
            Self::Key(key) => value.get(key),
            Self::Index(i) => value.get(i),
        }
    }
}

/// The steps as a path.
pub(super) fn spelt<'a>(steps: impl IntoIterator<Item = &'a Step>) -> String {
    steps.into_iter().fold(String::new(), |path, step| match step {
        Step::Key(key) => join(&path, key),
        Step::Index(i) => format!("{path}[{i}]"),
    })
}

/// The steps of a path, at least one; keys with other signs than letters, digits, `_` and `-` may be in quotes.
pub(super) fn segments(path: &str) -> Result<Vec<Step>, ModelError> {
    let wrong = |found: &str| {
        let hint = "such as `bodies.rod.elements` or `gravity[1]`";
        ModelError::new(path, found, "keys with dots between them and places in brackets").hint(hint)
    };
    let mut steps = Vec::new();
    let mut rest = path;
    loop {
        let (key, after) = key(rest).ok_or_else(|| wrong("quotes that do not end"))?;
        if key.is_empty() {
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

/// The key at the head of a text, and what follows it; `None` if its quotes do not end.
fn key(text: &str) -> Option<(String, &str)> {
    for quote in ['"', '\''] {
        if let Some(quoted) = text.strip_prefix(quote) {
            return quoted.split_once(quote).map(|(key, rest)| (key.to_owned(), rest));
        }
    }
    let end = text.find(['.', '[']).unwrap_or(text.len());
    Some((text[..end].trim().to_owned(), &text[end..]))
}
