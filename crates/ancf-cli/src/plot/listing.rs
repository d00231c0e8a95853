//! List of the columns of a run.

use std::path::Path;

use ancf::errors::short;
use serde::Serialize;

use super::source::{PlotQuantity, PlotSource};
use crate::terminal::count;

/// List of the columns of a run.
#[derive(Debug, Serialize)]
pub struct ColumnListing {
    folder: String,
    status: &'static str,
    rows: usize,
    columns: Vec<ColumnEntry>,
}

/// Column with its smallest and largest value, `None` without finite values.
#[derive(Debug, Serialize)]
struct ColumnEntry {
    name: String,
    /// Unit, may be empty.
    unit: String,
    least: Option<f64>,
    largest: Option<f64>,
}

impl ColumnListing {
    /// Lists the columns of a run or a study.
    pub fn new(folder: &Path, source: &PlotSource) -> Self {
        let series = &source.series;
        let entry = |quantity: PlotQuantity| {
            let values = series.column(&quantity.name).unwrap_or_default();
            let bound = |better: fn(f64, f64) -> f64| {
                values.iter().copied().filter(|value| !value.is_nan()).reduce(better)
            };
            let (least, largest) = (bound(f64::min), bound(f64::max));
            ColumnEntry { name: quantity.name, unit: quantity.unit, least, largest }
        };
        Self {
            folder: folder.display().to_string(),
            status: source.status,
            rows: series.columns().next().map_or(0, |(_, values)| values.len()),
            columns: source.quantities.iter().cloned().map(entry).collect(),
        }
    }

    /// Returns aligned lines.
    pub fn text(&self) -> String {
        let shown = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), short);
        let mut lines = vec![["column", "unit", "least", "largest"].map(str::to_owned)];
        lines.extend(self.columns.iter().map(|ColumnEntry { name, unit, least, largest }| {
            [name.clone(), unit.clone(), shown(*least), shown(*largest)]
        }));
        let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max().unwrap_or(0);
        let (first, second) = (width(0), width(1));
        let line = |[name, unit, least, largest]: &[String; 4]| {
            format!("{name:first$}  {unit:second$}  {least:>13}  {largest:>13}\n")
        };
        let state = match self.status {
            "running" => ", the run is in progress",
            "broken" => "; the run was interrupted, `ancf resume` resumes it",
            _ => "",
        };
        lines.iter().map(line).collect::<String>() + &format!("{}{state}\n", count(self.rows as u64, "row"))
    }
}
