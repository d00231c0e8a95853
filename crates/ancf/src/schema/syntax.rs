//! Parsing of a TOML text into data with positions, with recovery from syntax errors.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeInteger, DeTable, DeValue};
use toml::{Spanned, Table, Value};

use super::number_arrays::NumberArrays;
use super::schema_check::join;
use crate::errors::{ModelError, Position};

/// Number of syntax errors after which the rest of a text is ignored.
const MAX_SYNTAX_ERRORS: usize = 20;

/// Content of a TOML text.
#[derive(Debug, Default)]
pub(crate) struct Document {
    /// Data without the statements that have syntax errors; empty if there are too many.
    pub(crate) data: Table,
    /// Syntax errors, in the order of the text.
    pub(crate) errors: Vec<ModelError>,
    /// Text with blanked statements.
    rest: String,
    /// Positions of keys and values, by path. Created for the first error, since they need many times the memory of the text.
    entries: OnceCell<Entries>,
    /// Ranges of bytes that were blanked out.
    blank: Vec<Range<usize>>,
}

/// Positions by path.
type Entries = BTreeMap<String, EntrySpan>;

/// Positions of a key and its value, in bytes.
#[derive(Clone, Debug)]
struct EntrySpan {
    key: Range<usize>,
    value: Range<usize>,
}

impl Document {
    /// Parses a text.
    ///
    /// After a syntax error the statement is blanked out and the text is parsed again. Without this step, one unclosed bracket
    /// would hide all following errors.
    pub(crate) fn parse(text: &str) -> Self {
        if let Some(document) = NumberArrays::of(text).and_then(|arrays| Self::with_arrays(text, &arrays)) {
            return document;
        }
        let mut rest = text.to_owned();
        let mut document = Self::default();
        while let Some((error, blank)) = document.read_data(text, &rest) {
            document.errors.push(error);
            if document.errors.len() == MAX_SYNTAX_ERRORS || rest[blank.clone()].trim().is_empty() {
                document.data = Table::new();
                break;
            }
            let blanks =
                rest[blank.clone()].chars().map(|c| if c == '\n' { "\n" } else { &"    "[..c.len_utf8()] });
            rest.replace_range(blank.clone(), &blanks.collect::<String>());
            document.blank.push(blank);
        }
        document.rest = rest;
        document
    }

    /// Parses a text with long arrays of numbers; `None` if it has errors.
    fn with_arrays(text: &str, arrays: &NumberArrays<'_>) -> Option<Self> {
        let (table, errors) = DeTable::parse_recoverable(&arrays.marked);
        let data = errors.is_empty().then(|| data_of_table(table.get_ref(), Some(arrays)))?;
        Some(Self { data, rest: text.to_owned(), ..Self::default() })
    }

    /// Stores the data of a text; returns the first syntax error, if there is one, and the lines of its statement.
    fn read_data(&mut self, text: &str, rest: &str) -> Option<(ModelError, Range<usize>)> {
        let (table, errors) = DeTable::parse_recoverable(rest);
        self.data = data_of_table(table.get_ref(), None);
        let first = errors.into_iter().min_by_key(|error| error.span().map_or(0, |span| span.start))?;
        let span = first.span().unwrap_or(0..0);
        let entries = entries_of(table.get_ref());
        let unclosed = entries.values().filter(|entry| is_unclosed(&entry.value, span.start, rest));
        Some(match unclosed.min_by_key(|entry| entry.value.start) {
            Some(EntrySpan { key, value }) => {
                (unclosed_error(text, value.start), lines(rest, key.start, is_statement))
            }
            None if is_header(line(rest, span.start)) => {
                (error(text, &first, span.clone()), lines(rest, span.start, is_header))
            }
            None => (error(text, &first, span.clone()), lines(rest, span.start, |_| true)),
        })
    }

    /// Positions of all keys and values.
    fn entries(&self) -> &Entries {
        self.entries.get_or_init(|| entries_of(DeTable::parse_recoverable(&self.rest).0.get_ref()))
    }

    /// Position of the value of a path, or of its key; position of the nearest parent if the path is missing.
    pub(crate) fn find(&self, path: &str, at_key: bool) -> Range<usize> {
        match self.entries().get(path) {
            Some(entry) if at_key => entry.key.clone(),
            Some(entry) => entry.value.clone(),
            None => path.rfind(['.', '[']).map_or(0..0, |end| self.find(&path[..end], false)),
        }
    }

    /// True if the value of a path contains a syntax error.
    pub(crate) fn has_syntax_error(&self, path: &str) -> bool {
        let value = self.find(path, false);
        self.blank.iter().any(|blank| value.start <= blank.start && blank.start < value.end)
    }
}

/// Converts a table without positions.
fn data_of_table(table: &DeTable<'_>, arrays: Option<&NumberArrays<'_>>) -> Table {
    table.iter().map(|(key, value)| (key.get_ref().to_string(), data_of(value.get_ref(), arrays))).collect()
}

fn data_of(value: &DeValue<'_>, arrays: Option<&NumberArrays<'_>>) -> Value {
    match value {
        DeValue::String(text) => text.to_string().into(),
        DeValue::Integer(n) => integer(n),
        DeValue::Float(x) => x.as_str().parse().map_or(Value::Float(f64::NAN), Value::Float),
        DeValue::Boolean(yes) => Value::Boolean(*yes),
        DeValue::Datetime(date) => Value::Datetime(*date),
        DeValue::Array(items) => {
            let mark = items.first().and_then(|item| item.get_ref().as_str());
            let long = arrays.zip(mark).and_then(|(arrays, mark)| arrays.numbers(mark));
            let each = || items.iter().map(|item| data_of(item.get_ref(), arrays)).collect();
            Value::Array(long.unwrap_or_else(each))
        }
        DeValue::Table(table) => Value::Table(data_of_table(table, arrays)),
    }
}

/// Collects the positions of a table.
fn entries_of(table: &DeTable<'_>) -> Entries {
    let mut entries = Entries::new();
    add_table(&mut entries, table, "");
    entries
}

fn add_table(entries: &mut Entries, table: &DeTable<'_>, path: &str) {
    for (key, value) in table {
        add_value(entries, value, key.span(), join(path, key.get_ref()));
    }
}

fn add_value(entries: &mut Entries, value: &Spanned<DeValue<'_>>, key: Range<usize>, path: String) {
    match value.get_ref() {
        DeValue::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                add_value(entries, item, item.span(), format!("{path}[{i}]"));
            }
        }
        DeValue::Table(table) => add_table(entries, table, &path),
        _ => {}
    }
    entries.insert(path, EntrySpan { key, value: value.span() });
}

/// Converts integers of more than 64 bits to numbers with a decimal point.
fn integer(n: &DeInteger<'_>) -> Value {
    let exact = i64::from_str_radix(n.as_str(), n.radix()).map(Value::Integer);
    exact.unwrap_or_else(|_| n.as_str().parse().map_or(Value::Float(f64::NAN), Value::Float))
}

/// Position of a range of bytes.
pub(crate) fn position(text: &str, bytes: Range<usize>) -> Position {
    let before = text.get(..bytes.start).unwrap_or(text);
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let column = before[start..].trim_start_matches('\u{feff}').chars().count() + 1;
    Position { line: before.matches('\n').count() + 1, column, bytes }
}

/// Converts an error of the TOML parser.
fn error(text: &str, error: &toml::de::Error, span: Range<usize>) -> ModelError {
    let word = text.get(span.clone()).unwrap_or_default().trim();
    let (what, expected) =
        error.message().split_once(", expected ").unwrap_or((error.message(), "valid TOML"));
    let (found, expected) = match what {
        "string values must be quoted" if word.is_empty() => ("no value".into(), "a value"),
        "string values must be quoted" => {
            (format!("`{word}` without quotes"), "a text in quotes, a number, true or false")
        }
        "duplicate key" => (format!("`{word}` a second time"), "every key once"),
        _ if word.is_empty() || what.contains(word) => (what.into(), expected),
        _ => (format!("{what} `{word}`"), expected),
    };
    ModelError { at: Some(position(text, span)), ..ModelError::new("", found, expected) }
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

/// True if a value is unclosed at the position of an error: at the end of the text, or at the next statement.
fn is_unclosed(value: &Range<usize>, error: usize, text: &str) -> bool {
    let inside = value.start < error && error <= value.end;
    inside
        && text[value.start..error].contains('\n')
        && (text[error..].trim().is_empty() || is_statement(line(text, error)))
}

/// Range of lines from the line of a byte to the next line that passes a test.
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

/// Line of a byte.
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
