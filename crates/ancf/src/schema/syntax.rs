//! A TOML text as data with positions, as much of it as can be understood.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeInteger, DeString, DeTable, DeValue};
use toml::{Spanned, Table, Value};

use super::schema_check::join;
use crate::errors::{ModelError, Position};

/// Errors of syntax after which the rest of a text is not looked at.
const MANY: usize = 20;

/// What a TOML text says.
#[derive(Debug, Default)]
pub(crate) struct Document {
    /// The data; what could not be understood is left out, all of it if that is too much.
    pub(crate) data: Table,
    /// Errors of syntax, in the order of the text.
    pub(crate) errors: Vec<ModelError>,
    /// Where keys and values are, by path.
    places: BTreeMap<String, Place>,
    /// Lines left out, in bytes.
    blank: Vec<Range<usize>>,
}

/// Where a key and its value are, in bytes.
#[derive(Clone, Debug)]
struct Place {
    key: Range<usize>,
    value: Range<usize>,
}

impl Document {
    /// Reads a text.
    ///
    /// After an error of syntax its statement is blanked out and the text is read again, so that one open bracket
    /// does not swallow all that follows.
    pub(crate) fn parse(text: &str) -> Self {
        let mut rest = text.to_owned();
        let mut document = Self::default();
        while let Some((error, blank)) = document.read(text, &rest) {
            document.errors.push(error);
            if document.errors.len() == MANY || rest[blank.clone()].trim().is_empty() {
                document.data = Table::new();
                break;
            }
            let blanks =
                rest[blank.clone()].chars().map(|c| if c == '\n' { "\n" } else { &"    "[..c.len_utf8()] });
            rest.replace_range(blank.clone(), &blanks.collect::<String>());
            document.blank.push(blank);
        }
        document
    }

    /// Notes what the text says; the first error of syntax, if there is one, and the lines it spoils.
    fn read(&mut self, text: &str, rest: &str) -> Option<(ModelError, Range<usize>)> {
        let (table, errors) = DeTable::parse_recoverable(rest);
        self.places.clear();
        self.data = self.table(table.get_ref(), "");
        let first = errors.into_iter().min_by_key(|error| error.span().map_or(0, |span| span.start))?;
        let span = first.span().unwrap_or(0..0);
        let unclosed = self.places.values().filter(|place| is_unclosed(&place.value, span.start, rest));
        Some(match unclosed.min_by_key(|place| place.value.start) {
            Some(Place { key, value }) => {
                (unclosed_error(text, value.start), lines(rest, key.start, is_statement))
            }
            None if is_header(line(rest, span.start)) => {
                (error(text, &first, span.clone()), lines(rest, span.start, is_header))
            }
            None => (error(text, &first, span.clone()), lines(rest, span.start, |_| true)),
        })
    }

    fn table(&mut self, table: &DeTable<'_>, path: &str) -> Table {
        let entry = |(key, value): (&Spanned<DeString<'_>>, &Spanned<DeValue<'_>>)| {
            (key.get_ref().to_string(), self.value(value, key.span(), join(path, key.get_ref())))
        };
        table.iter().map(entry).collect()
    }

    fn value(&mut self, value: &Spanned<DeValue<'_>>, key: Range<usize>, path: String) -> Value {
        let data = match value.get_ref() {
            DeValue::String(text) => text.to_string().into(),
            DeValue::Integer(n) => integer(n),
            DeValue::Float(x) => x.as_str().parse().map_or(Value::Float(f64::NAN), Value::Float),
            DeValue::Boolean(yes) => Value::Boolean(*yes),
            DeValue::Datetime(date) => Value::Datetime(*date),
            DeValue::Array(items) => {
                let item =
                    |(i, item): (_, &Spanned<_>)| self.value(item, item.span(), format!("{path}[{i}]"));
                Value::Array(items.iter().enumerate().map(item).collect())
            }
            DeValue::Table(table) => Value::Table(self.table(table, &path)),
        };
        self.places.insert(path, Place { key, value: value.span() });
        data
    }

    /// Where the value of a path is, or its key; where its nearest parent is, if it is not there.
    pub(crate) fn find(&self, path: &str, at_key: bool) -> Range<usize> {
        match self.places.get(path) {
            Some(place) if at_key => place.key.clone(),
            Some(place) => place.value.clone(),
            None => path.rfind(['.', '[']).map_or(0..0, |end| self.find(&path[..end], false)),
        }
    }

    /// Whether an error of syntax lies within the value of a path.
    pub(crate) fn is_spoilt(&self, path: &str) -> bool {
        let value = self.find(path, false);
        self.blank.iter().any(|blank| value.start <= blank.start && blank.start < value.end)
    }
}

/// Integers beyond 64 bits become numbers with a decimal point.
fn integer(n: &DeInteger<'_>) -> Value {
    let exact = i64::from_str_radix(n.as_str(), n.radix()).map(Value::Integer);
    exact.unwrap_or_else(|_| n.as_str().parse().map_or(Value::Float(f64::NAN), Value::Float))
}

/// The position of a range of bytes.
pub(crate) fn position(text: &str, bytes: Range<usize>) -> Position {
    let before = text.get(..bytes.start).unwrap_or(text);
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let column = before[start..].trim_start_matches('\u{feff}').chars().count() + 1;
    Position { line: before.matches('\n').count() + 1, column, bytes }
}

/// The error of the TOML reader in our words.
fn error(text: &str, error: &toml::de::Error, span: Range<usize>) -> ModelError {
    let word = text.get(span.clone()).unwrap_or_default().trim();
    let (what, wanted) = error.message().split_once(", expected ").unwrap_or((error.message(), "valid TOML"));
    let (found, wanted) = match what {
        "string values must be quoted" if word.is_empty() => ("no value".into(), "a value"),
        "string values must be quoted" => {
            (format!("`{word}` without quotes"), "a text in quotes, a number, true or false")
        }
        "duplicate key" => (format!("`{word}` a second time"), "every key once"),
        _ if word.is_empty() || what.contains(word) => (what.into(), wanted),
        _ => (format!("{what} `{word}`"), wanted),
    };
    ModelError { at: Some(position(text, span)), ..ModelError::new("", found, wanted) }
}

fn unclosed_error(text: &str, start: usize) -> ModelError {
    let (what, end) = match text.as_bytes().get(start) {
        Some(b'[') => ("an array", "`]`"),
        Some(b'{') => ("a table", "`}`"),
        _ => ("a text", "quotes"),
    };
    let at = Some(position(text, start..start + line(text, start).len().min(1)));
    ModelError { at, ..ModelError::new("", format!("{what} that does not end"), format!("{end} at its end")) }
}

/// Whether a value is still open where an error was met: at the end, or at what looks like the next statement.
fn is_unclosed(value: &Range<usize>, error: usize, text: &str) -> bool {
    let inside = value.start < error && error <= value.end;
    inside
        && text[value.start..error].contains('\n')
        && (text[error..].trim().is_empty() || is_statement(line(text, error)))
}

/// The lines from that of a byte to the next one that passes a test.
fn lines(text: &str, at: usize, is_next: fn(&str) -> bool) -> Range<usize> {
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let mut end = start;
    for (i, line) in text[start..].split_inclusive('\n').enumerate() {
        if i > 0 && is_next(line) {
            break;
        }
        end += line.len();
    }
    start..end
}

/// The line of a byte.
fn line(text: &str, at: usize) -> &str {
    text[lines(text, at, |_| true)].trim()
}

fn is_statement(line: &str) -> bool {
    let is_key =
        |key: &str| !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-.'\" ".contains(c));
    is_header(line) || line.trim_start().split_once('=').is_some_and(|(key, _)| is_key(key))
}

fn is_header(line: &str) -> bool {
    let name = line.trim_start().strip_prefix('[').map(|rest| rest.trim_start_matches(['[', ' ']));
    name.is_some_and(|name| name.starts_with(|c: char| c.is_alphabetic() || "_'\"".contains(c)))
}
