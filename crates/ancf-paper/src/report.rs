//! Report of the paper: files of tables and figures, `results.json`, HTML page.

use anyhow::Result;

use crate::cases::PaperRuns;
use crate::figures::{PaperFigure, all_figures};
use crate::page::ReportFolder;
use crate::results::PaperResults;
use crate::sections;
use crate::tables::PaperTables;

/// Writes the report of runs that took `seconds` in total, and returns the numbers of the report.
///
/// # Errors
/// If a figure cannot be drawn or a file cannot be written.
pub fn write_paper(folder: &ReportFolder, runs: &PaperRuns, seconds: f64) -> Result<PaperResults> {
    let results = PaperResults::new(runs, seconds);
    let figures = all_figures(runs, &results);
    write(folder, &results, &figures)?;
    Ok(results)
}

fn write(folder: &ReportFolder, results: &PaperResults, figures: &[PaperFigure]) -> Result<()> {
    let tables = PaperTables::new(results);
    for table in tables.iter() {
        folder.write(&format!("{}.csv", table.file), table.csv()?)?;
    }
    for figure in figures {
        folder.write(&format!("{}.svg", figure.file), figure.svg())?;
        folder.write(&format!("{}.png", figure.file), figure.png()?)?;
    }
    folder.write("results.json", serde_json::to_string_pretty(results)?)?;
    folder.write("index.html", sections::page(results, &tables, figures))
}
