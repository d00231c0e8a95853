use ancf::record::Series;
use ancf_results::{Results, RunStatus};
use serde::Serialize;

use super::selection::Quantity;
use crate::conclusion::{count, short};

/// What there is to plot.
#[derive(Debug, Serialize)]
pub struct Listing {
    folder: String,
    status: &'static str,
    rows: usize,
    columns: Vec<Entry>,
}

/// A column; least and largest value of its numbers, null if it has none.
#[derive(Debug, Serialize)]
struct Entry {
    name: String,
    /// Empty of what has none.
    unit: String,
    least: Option<f64>,
    largest: Option<f64>,
}

impl Listing {
    /// Of a run.
    pub fn of(results: &Results, series: &Series) -> Self {
        let entry = |quantity: Quantity| {
            let values = series.column(&quantity.name).unwrap_or_default();
            let bound = |better: fn(f64, f64) -> f64| {
                values.iter().copied().filter(|value| !value.is_nan()).reduce(better)
            };
            let (least, largest) = (bound(f64::min), bound(f64::max));
            Entry { name: quantity.name, unit: quantity.unit, least, largest }
        };
        Self {
            folder: results.folder().path().display().to_string(),
            status: match results.status() {
                RunStatus::Running => "running",
                RunStatus::Ended => "ended",
                RunStatus::Broken => "broken",
            },
            rows: series.columns().next().map_or(0, |(_, values)| values.len()),
            columns: Quantity::all(results).into_iter().map(entry).collect(),
        }
    }

    /// Aligned lines.
    pub fn text(&self) -> String {
        let shown = |x: Option<f64>| x.map_or_else(|| "-".to_owned(), short);
        let mut lines = vec![["column", "unit", "least", "largest"].map(str::to_owned)];
        lines.extend(self.columns.iter().map(|Entry { name, unit, least, largest }| {
            [name.clone(), unit.clone(), shown(*least), shown(*largest)]
        }));
        let width = |k: usize| lines.iter().map(|line| line[k].chars().count()).max().unwrap_or(0);
        let (first, second) = (width(0), width(1));
        let line = |[name, unit, least, largest]: &[String; 4]| {
            format!("{name:first$}  {unit:second$}  {least:>13}  {largest:>13}\n")
        };
        let state = match self.status {
            "running" => ", and the run goes on",
            "broken" => "; the run broke off: `ancf resume` goes on",
            _ => "",
        };
        lines.iter().map(line).collect::<String>() + &format!("{}{state}\n", count(self.rows as u64, "row"))
    }
}
