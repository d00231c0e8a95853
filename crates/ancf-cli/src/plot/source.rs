//! Data of plots: the rows of a run, or the cases of a study.

use std::io;
use std::path::Path;

use ancf::Column;
use ancf::record::{Series, Sink};
use ancf_results::{Results, RunStatus};
use ancf_study::{RecordedColumn, StudyRecord};
use anyhow::Result;

use crate::results::open_run;
use crate::terminal::Ended;

/// Columns with their units and values.
#[derive(Debug)]
pub struct PlotSource {
    /// Columns in the order of the files.
    pub quantities: Vec<PlotQuantity>,
    /// Values.
    pub series: Series,
    /// State of the run or the study: `running`, `ended` or `broken`.
    pub status: &'static str,
    /// Column of the horizontal axis by default.
    pub abscissa: String,
    /// True if consecutive rows are points of a curve.
    pub is_connected: bool,
    /// True if columns of the same unit share a panel.
    pub shares_panels: bool,
}

/// Column with its unit, which may be empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlotQuantity {
    /// Name of the column.
    pub name: String,
    /// Unit.
    pub unit: String,
}

impl PlotQuantity {
    /// Returns name and unit.
    pub fn label(&self) -> String {
        if self.unit.is_empty() { self.name.clone() } else { format!("{} ({})", self.name, self.unit) }
    }
}

impl PlotSource {
    /// Reads the run or the study in a folder. Reports a folder without either.
    ///
    /// # Errors
    /// If a file cannot be read or is damaged.
    pub fn open(folder: &Path) -> Result<Result<Self, Ended>> {
        if let Some(study) = StudyRecord::read(folder)? {
            return Ok(Ok(Self::of_study(&study.finished())?));
        }
        match open_run(folder)? {
            Ok(results) => Ok(Ok(Self::of_run(&results)?)),
            Err(ended) => Ok(Err(ended)),
        }
    }

    fn of_run(results: &Results) -> Result<Self> {
        let units = results.model().unit_names();
        let unit = |column: &Column| column.unit(&units).filter(|unit| unit != "1").unwrap_or_default();
        let columns = results.simulation().columns();
        let quantity = |column: Column| PlotQuantity { unit: unit(&column), name: column.name };
        let quantities: Vec<PlotQuantity> = columns.into_iter().map(quantity).collect();
        let first = quantities.first().map(|quantity| quantity.name.clone()).unwrap_or_default();
        Ok(Self {
            quantities,
            series: results.columns()?,
            status: match results.status() {
                RunStatus::Running => "running",
                RunStatus::Ended => "ended",
                RunStatus::Broken => "broken",
            },
            is_connected: first != "mode",
            abscissa: first,
            shares_panels: true,
        })
    }

    /// Numeric columns of the finished cases, in the order of the first parameter that varies.
    fn of_study(record: &StudyRecord) -> io::Result<Self> {
        let is_numeric = |column: &&RecordedColumn| column.numbers.iter().any(|x| x.is_finite());
        let columns: Vec<&RecordedColumn> =
            record.parameters.iter().chain(&record.objectives).filter(is_numeric).collect();
        let varying = record.varying();
        let mut names = vec!["case".to_owned()];
        names.extend(columns.iter().map(|column| column.name.clone()));
        names.push("seconds".to_owned());
        let mut order: Vec<usize> = (0..record.cases.len()).collect();
        if let Some(first) = varying.first() {
            order.sort_by(|&a, &b| first.numbers[a].total_cmp(&first.numbers[b]));
        }
        let mut series = Series::new();
        series.begin(&names)?;
        for &case in &order {
            let values = columns.iter().map(|column| column.numbers[case]);
            let row: Vec<f64> =
                [record.cases[case] as f64].into_iter().chain(values).chain([record.seconds[case]]).collect();
            let _ = series.record(&row)?;
        }
        let is_curve = varying.len() == 1 && varying[0].distinct().len() == record.cases.len();
        let quantity = |name: String| {
            let unit = if name == "seconds" { "s" } else { "" };
            PlotQuantity { name, unit: unit.to_owned() }
        };
        Ok(Self {
            quantities: names.into_iter().map(quantity).collect(),
            series,
            status: "ended",
            abscissa: varying.first().map_or_else(|| "case".to_owned(), |first| first.name.clone()),
            is_connected: is_curve,
            shares_panels: false,
        })
    }
}
