//! Every table and figure of Kim et al. (2017).
//!
//! ```text
//! cases -> study -> results -> tables -> CSV
//!             \        |   \       \
//!              \       |    figures \  -> SVG, PNG
//!               \      |         \   \
//!                `-----+-> JSON   report -> HTML
//! ```

pub mod cases;
pub mod conditioning;
pub mod figures;
pub mod peers;
pub mod published;
pub mod report;
pub mod results;
pub mod rigid;
pub mod study;
pub mod table;
pub mod tables;

use std::path::Path;
use std::time::{Duration, Instant};

use anyhow::Result;
use indicatif::{ProgressBar, ProgressStyle};

use crate::report::Output;
use crate::speech::say;
use figures::Drawing;

use results::Results;
use study::Study;
use tables::Tables;

/// Runs everything and writes the report into a folder.
///
/// # Errors
/// If the folder cannot be written, or a run of the paper does not reach its end.
pub fn reproduce(out: &Path, repeats: usize) -> Result<()> {
    let output = Output::create(out)?;
    let clock = Instant::now();
    let study = study(repeats)?;
    let results = Results::new(&study, clock.elapsed().as_secs_f64());
    let drawings = figures::all(&study, &results);
    write(&output, &results, &drawings)?;
    let verdict = &results.verdict;
    say(&format!("{} of {} printed numbers reproduced", verdict.within(), verdict.numbers()));
    say(&format!("report in {}", out.join("index.html").display()));
    Ok(())
}

/// All runs, with a word on what is going on where a terminal shows it.
fn study(repeats: usize) -> Result<Study> {
    say("running the problems of the paper: about half a minute");
    let style = ProgressStyle::with_template("{spinner} {msg}  [{elapsed_precise}]");
    let spinner =
        ProgressBar::new_spinner().with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    spinner.enable_steady_tick(Duration::from_millis(200));
    let study = Study::run(repeats, |next| spinner.set_message(next.to_owned()));
    spinner.finish_and_clear();
    study
}

fn write(output: &Output, results: &Results, drawings: &[Drawing]) -> Result<()> {
    let tables = Tables::new(results);
    for table in tables.iter() {
        output.write(&format!("{}.csv", table.file), table.csv()?)?;
    }
    for drawing in drawings {
        output.write(&format!("{}.svg", drawing.file), drawing.svg())?;
        output.write(&format!("{}.png", drawing.file), drawing.png()?)?;
    }
    output.write("results.json", serde_json::to_string_pretty(results)?)?;
    output.write("index.html", report::page(results, &tables, drawings))
}
