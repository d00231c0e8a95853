//! Table of numbers: CSV in full precision, text with fewer digits.

use std::ops::Range;

use anyhow::{Context, Result};

use crate::page::number;

/// Table with named columns.
#[derive(Clone, Debug)]
pub struct PaperTable {
    /// Name of the CSV file without the extension.
    pub file: &'static str,
    /// Columns.
    pub columns: Vec<PaperColumn>,
    /// Rows, each as long as `columns`.
    pub rows: Vec<Vec<CellValue>>,
}

/// Heading and format of a column.
#[derive(Clone, Copy, Debug)]
pub struct PaperColumn {
    /// Heading shared with the neighbours, may be empty.
    pub group: &'static str,
    /// Heading.
    pub name: &'static str,
    /// Unit, may be empty.
    pub unit: &'static str,
    /// Number format.
    pub format: NumberFormat,
}

/// Number format, see [`number`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberFormat {
    /// Number of decimals.
    Fixed(usize),
    /// Number of decimals, with a sign.
    Signed(usize),
    /// Number of significant digits.
    Significant(usize),
    /// Power of ten with the number of digits of the factor.
    Scientific(usize),
}

/// Cell.
#[derive(Clone, Debug, PartialEq)]
pub enum CellValue {
    /// Number.
    Number(f64),
    /// Text.
    Text(String),
}

impl From<f64> for CellValue {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}

impl From<u32> for CellValue {
    fn from(x: u32) -> Self {
        Self::Number(f64::from(x))
    }
}

impl From<&str> for CellValue {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl PaperColumn {
    /// Creates a column without a shared heading.
    pub const fn new(name: &'static str, unit: &'static str, format: NumberFormat) -> Self {
        Self { group: "", name, unit, format }
    }

    /// Creates a column of text without a shared heading.
    pub const fn text(name: &'static str) -> Self {
        Self::new(name, "", NumberFormat::Fixed(0))
    }

    /// Sets the shared heading.
    #[must_use]
    pub const fn under(self, group: &'static str) -> Self {
        Self { group, ..self }
    }

    /// Returns the heading with the unit.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() { self.name.to_owned() } else { format!("{} ({})", self.name, self.unit) }
    }

    /// Returns both headings and the unit.
    fn full_heading(&self) -> String {
        if self.group.is_empty() { self.heading() } else { format!("{}: {}", self.group, self.heading()) }
    }

    /// Formats a cell.
    pub fn show(&self, value: &CellValue) -> String {
        match (value, self.format) {
            (CellValue::Text(text), _) => text.clone(),
            (&CellValue::Number(x), NumberFormat::Fixed(decimals)) => number::fixed(x, decimals),
            (&CellValue::Number(x), NumberFormat::Signed(decimals)) => number::signed(x, decimals),
            (&CellValue::Number(x), NumberFormat::Significant(digits)) => number::significant(x, digits),
            (&CellValue::Number(x), NumberFormat::Scientific(digits)) => number::scientific(x, digits),
        }
    }
}

impl PaperTable {
    /// Returns the table as CSV: a line of headings with units, then one line per row.
    ///
    /// # Errors
    /// If a row is not as long as the heading.
    pub fn csv(&self) -> Result<Vec<u8>> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(self.columns.iter().map(PaperColumn::full_heading))?;
        for row in &self.rows {
            writer.write_record(row.iter().map(|value| match value {
                CellValue::Number(x) => number::exact(*x),
                CellValue::Text(text) => text.clone(),
            }))?;
        }
        writer.into_inner().ok().context("memory can be written")
    }

    /// Returns a part of the rows and columns. The file name remains.
    #[must_use]
    pub fn part(&self, rows: Range<usize>, columns: Range<usize>) -> Self {
        let rows = self.rows.get(rows).unwrap_or_default().iter();
        Self {
            file: self.file,
            columns: self.columns.get(columns.clone()).unwrap_or_default().to_vec(),
            rows: rows.map(|row| row.get(columns.clone()).unwrap_or_default().to_vec()).collect(),
        }
    }

    /// Returns the shared headings in order, each with its number of columns. Empty if there are none.
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
