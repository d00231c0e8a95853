//! A table of numbers, written as CSV in full precision and shown with fewer digits.

use std::ops::Range;

use anyhow::{Context, Result};

use crate::report::number;

/// A table with named columns.
#[derive(Clone, Debug)]
pub struct Table {
    /// Name of its CSV file without the ending.
    pub file: &'static str,
    /// The columns.
    pub columns: Vec<Column>,
    /// The rows, each as long as `columns`.
    pub rows: Vec<Vec<Value>>,
}

/// What a column holds.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// Heading shared with its neighbours, may be empty.
    pub group: &'static str,
    /// Its own heading.
    pub name: &'static str,
    /// Unit, may be empty.
    pub unit: &'static str,
    /// How its numbers are shown.
    pub format: Format,
}

/// How numbers are shown; see [`number`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// So many decimals.
    Fixed(usize),
    /// So many decimals, with a sign.
    Signed(usize),
    /// So many digits that count.
    Significant(usize),
    /// Powers of ten with so many digits in front.
    Scientific(usize),
}

/// One cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// Words.
    Text(String),
}

impl From<f64> for Value {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}

impl From<u32> for Value {
    fn from(x: u32) -> Self {
        Self::Number(f64::from(x))
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl Column {
    /// A column under no shared heading.
    pub const fn new(name: &'static str, unit: &'static str, format: Format) -> Self {
        Self { group: "", name, unit, format }
    }

    /// A column of words under no shared heading.
    pub const fn text(name: &'static str) -> Self {
        Self::new(name, "", Format::Fixed(0))
    }

    /// The same column under a shared heading.
    #[must_use]
    pub const fn under(self, group: &'static str) -> Self {
        Self { group, ..self }
    }

    /// Its own heading with the unit.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.to_owned() } else { format!("{} ({})", self.name, self.unit) }
    }

    /// Both headings and the unit.
    fn full_heading(&self) -> String {
        if self.group.is_empty() { self.heading() } else { format!("{}: {}", self.group, self.heading()) }
    }

    /// A cell as it is shown.
    pub fn show(&self, value: &Value) -> String {
        match (value, self.format) {
            (Value::Text(text), _) => text.clone(),
            (&Value::Number(x), Format::Fixed(decimals)) => number::fixed(x, decimals),
            (&Value::Number(x), Format::Signed(decimals)) => number::signed(x, decimals),
            (&Value::Number(x), Format::Significant(digits)) => number::significant(x, digits),
            (&Value::Number(x), Format::Scientific(digits)) => number::scientific(x, digits),
        }
    }
}

impl Table {
    /// The table as CSV: a line of headings with units, then a line per row.
    ///
    /// # Errors
    /// If a row is not as long as the heading.
    pub fn csv(&self) -> Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(Column::full_heading))?;
        for row in &self.rows {
            writer.write_record(row.iter().map(|value| match value {
                Value::Number(x) => number::exact(*x),
                Value::Text(text) => text.clone(),
            }))?;
        }
        writer.into_inner().ok().context("memory can be written")
    }

    /// Some of its rows and columns, under the name of the same file.
    #[must_use]
    pub fn part(&self, rows: Range<usize>, columns: Range<usize>) -> Self {
        let rows = self.rows.get(rows).unwrap_or_default().iter();
        Self {
            file: self.file,
            columns: self.columns.get(columns.clone()).unwrap_or_default().to_vec(),
            rows: rows.map(|row| row.get(columns.clone()).unwrap_or_default().to_vec()).collect(),
        }
    }

    /// The shared headings in order, each with the number of its columns; none if there is no such heading.
    pub fn groups(&self) -> Vec<(&'static str, usize)> {
        let mut groups: Vec<(&'static str, usize)> = Vec::new();
        for column in &self.columns {
            match groups.last_mut() {
                Some((group, count)) if *group == column.group => *count += 1,
                _ => groups.push((column.group, 1)),
            }
        }
        if groups.iter().all(|(group, _)| group.is_empty()) { Vec::new() } else { groups }
    }
}
