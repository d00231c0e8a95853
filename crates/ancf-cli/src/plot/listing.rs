//! List of the columns of a run.

use ancf::errors::short;
use ancf::record::Series;
use ancf_results::{Results, RunStatus};
use serde::Serialize;

use super::selection::PlotQuantity;
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
    /// Lists the columns of a run.
    pub fn new(results: &Results, series: &Series) -> Self {
        let entry = |quantity: PlotQuantity| {
            let values = series.column(&quantity.name).unwrap_or_default();
            let bound = |better: fn(f64, f64) -> f64| {
                values.iter().copied().filter(|value| !value.is_nan()).reduce(better)
            };
            let (least, largest) = (bound(f64::min), bound(f64::max));
            ColumnEntry { name: quantity.name, unit: quantity.unit, least, largest }
        };
        Self {
            folder: results.folder().path().display().to_string(),
            status: match results.status() {
                RunStatus::Running => "running",
                RunStatus::Ended => "ended",
                RunStatus::Broken => "broken",
            },
            rows: series.columns().next().map_or(0, |(_, values)| values.len()),
            columns: PlotQuantity::all(results).into_iter().map(entry).collect(),
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
