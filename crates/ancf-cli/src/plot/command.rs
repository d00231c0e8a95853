//! `ancf plot`: arguments and execution.

use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

use anyhow::Result;
use clap::Args;
use terminal_size::{Width, terminal_size};

use super::chart::{self, ChartStyle};
#[cfg(feature = "figures")]
use super::figure_file;
use super::figure_format::FigureFormat;
use super::listing::ColumnListing;
use super::panel::PlotPanel;
use super::selection::ColumnSelection;
use super::source::PlotSource;
use crate::terminal::{
    Ended, is_stdout_coloured, is_unicode, print, print_json, print_output, print_status,
    report_argument_error,
};

/// Arguments of `ancf plot`.
#[derive(Debug, Args)]
pub struct PlotArguments {
    /// Results folder, also during the run, or folder of a study.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Names of columns, probes or joints (`tip` for tip.x, tip.y and tip.z), or patterns (`*.y`); without names, all columns are listed.
    #[arg(value_name = "COLUMN")]
    columns: Vec<String>,
    /// Column of the horizontal axis; time, load factor, mode number, or the first parameter of a study by default.
    #[arg(short, long, value_name = "COLUMN")]
    against: Option<String>,
    /// Write a figure into this SVG, PNG or PDF file instead of a chart in the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Title above the charts.
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// First time, load factor or mode number.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Last time, load factor or mode number.
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    to: Option<f64>,
    /// Print the list of columns as one JSON object and nothing else.
    #[arg(long, conflicts_with = "columns")]
    pub json: bool,
}

/// Examples of the help.
pub const PLOT_EXAMPLES: &str = "\
Examples:
  ancf plot out                                 columns with unit, smallest and largest value
  ancf plot out tip.y                           a chart in the terminal
  ancf plot out tip 'root.f*'                   one chart per unit
  ancf plot out tip.y --against tip.x           the path of the tip
  ancf plot out kinetic strain --from 0.5 --to 1
  ancf plot out tip.y -o tip.png --title Tip    a figure; also .svg and .pdf
  ancf plot study tip                           an objective of a study over its parameter

Curves are interrupted at values that are not finite. Without colours several curves have different
markers. Exit code 2 for a folder without a run, or an unknown column.";

impl PlotArguments {
    /// Plots, or lists the columns.
    pub fn run(&self) -> Result<Ended> {
        let source = match PlotSource::open(&self.folder)? {
            Ok(source) => source,
            Err(ended) => return Ok(ended),
        };
        if self.columns.is_empty() && self.output.is_none() && self.against.is_none() {
            let listing = ColumnListing::new(&self.folder, &source);
            print(&listing.text());
            print_json(&listing);
            return Ok(Ended::Done);
        }
        let format =
            match self.output.as_ref().map(|file| FigureFormat::from_path(file).map(|format| (file, format)))
            {
                Some(Err(message)) => return Ok(report_argument_error(&message)),
                Some(Ok(chosen)) => Some(chosen),
                None => None,
            };
        let selection = match ColumnSelection::new(&source, &self.columns, self.against.as_deref()) {
            Ok(selection) => selection,
            Err(message) => return Ok(report_argument_error(&message)),
        };
        let range = [self.from.unwrap_or(f64::NEG_INFINITY), self.to.unwrap_or(f64::INFINITY)];
        let panels = selection.panels(&source, range);
        if !panels.iter().any(PlotPanel::has_points) {
            let reason = match source.series.columns().all(|(_, values)| values.is_empty()) {
                true => "no rows to plot; with `output.parquet = false` a run records none",
                false => "no values to plot in this range",
            };
            let message = format!("{}: {reason}", self.folder.display());
            return Ok(report_argument_error(&message));
        }
        match format {
            Some((file, format)) => return self.write_figure(&panels, file, format),
            None => {
                self.title.iter().for_each(|title| print_output(&format!("{title}\n\n")));
                print_output(&chart::text(&panels, chart_style()));
            }
        }
        Ok(Ended::Done)
    }

    /// Writes the panels as a figure.
    #[cfg(feature = "figures")]
    fn write_figure(&self, panels: &[PlotPanel], file: &Path, format: FigureFormat) -> Result<Ended> {
        figure_file::write(panels, self.title.as_deref(), file, format)?;
        print_status(&format!("done: {}", file.display()));
        Ok(Ended::Done)
    }

    /// Rejects the command: this program has no figures.
    #[cfg(not(feature = "figures"))]
    fn write_figure(&self, _: &[PlotPanel], _: &Path, _: FigureFormat) -> Result<Ended> {
        Ok(crate::terminal::reject_figures())
    }
}

/// Returns the chart style of the terminal.
fn chart_style() -> ChartStyle {
    let width = terminal_size().filter(|_| io::stdout().is_terminal()).map_or(80, |(Width(width), _)| width);
    ChartStyle {
        width: usize::from(width).clamp(40, 240),
        is_unicode: is_unicode(),
        is_coloured: is_stdout_coloured(),
    }
}
