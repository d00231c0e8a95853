//! `ancf plot`: columns of a run as a chart of characters or a figure.
//!
//! ```text
//! folder, names -> columns -> panels, one for each unit -> charts of characters
//!                                                     \-> SVG, PNG
//! ```
//!
//! The chart is our own: the crates there are put the numbers of an axis beside their places (ratatui) or at its ends only
//! (textplots), and tell curves apart by colours alone.

mod canvas;
mod chart;
mod listing;
mod panel;
mod picture;
mod selection;
mod thin;
mod tick;

use std::env;
use std::io::{self, IsTerminal};
use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use terminal_size::{Width, terminal_size};

use crate::colour;
use crate::command::{Ended, reject};
use crate::past;
use crate::speech::{answer, deliver, print, say};
use chart::Look;
use listing::Listing;
use panel::Panel;
use picture::Format;
use selection::Selection;

/// What `ancf plot` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The folder of a run, which may still go on.
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// Columns: names, names of probes or joints (`tip` for tip.x, tip.y and tip.z), patterns (`*.y`); without one, they are listed.
    #[arg(value_name = "COLUMN")]
    columns: Vec<String>,
    /// The column along the horizontal axis; by default the first: time, load factor or number of the mode.
    #[arg(short, long, value_name = "COLUMN")]
    against: Option<String>,
    /// Write a figure into this file, by its ending SVG or PNG, instead of a chart in the terminal.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Leave out what is before this time (load factor, mode).
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    from: Option<f64>,
    /// Leave out what is after this time (load factor, mode).
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    to: Option<f64>,
    /// Print the list of columns as one JSON object and nothing else.
    #[arg(long, conflicts_with = "columns")]
    pub json: bool,
}

pub const EXAMPLES: &str = "\
Examples:
  ancf plot out                                 the columns with unit, least and largest value
  ancf plot out tip.y                           a chart in the terminal
  ancf plot out tip 'root.f*'                   several: one chart for each unit
  ancf plot out tip.y --against tip.x           the path of the tip
  ancf plot out kinetic strain --from 0.5 --to 1
  ancf plot out tip.y -o tip.png                a figure; also .svg

Curves break where a value is not a number. Without colours several curves are drawn in signs.
Exit code 2 for a folder without a run, or a column that it has not.";

impl Arguments {
    /// Plots, or lists the columns.
    pub fn run(&self) -> Result<Ended> {
        let results = match past::open(&self.folder)? {
            Ok(results) => results,
            Err(ended) => return Ok(ended),
        };
        let series = results.columns()?;
        if self.columns.is_empty() && self.output.is_none() && self.against.is_none() {
            let listing = Listing::of(&results, &series);
            print(&listing.text());
            answer(&listing);
            return Ok(Ended::Done);
        }
        let format = match self.output.as_ref().map(|file| Format::of(file).map(|format| (file, format))) {
            Some(Err(message)) => return Ok(reject(&message)),
            Some(Ok(chosen)) => Some(chosen),
            None => None,
        };
        let selection = match Selection::of(&results, &self.columns, self.against.as_deref()) {
            Ok(selection) => selection,
            Err(message) => return Ok(reject(&message)),
        };
        let range = [self.from.unwrap_or(f64::NEG_INFINITY), self.to.unwrap_or(f64::INFINITY)];
        let panels = selection.panels(&series, range);
        if !panels.iter().any(Panel::has_points) {
            let what = format!("{}: there is no number to plot in this range", self.folder.display());
            return Ok(reject(&what));
        }
        match format {
            Some((file, format)) => {
                picture::write(&panels, file, format)?;
                say(&format!("done: {}", file.display()));
            }
            None => deliver(&chart::text(&panels, look())),
        }
        Ok(Ended::Done)
    }
}

/// What the terminal can show.
fn look() -> Look {
    let width = terminal_size().filter(|_| io::stdout().is_terminal()).map_or(80, |(Width(width), _)| width);
    Look {
        width: usize::from(width).clamp(40, 240),
        is_unicode: is_unicode(|name| env::var(name).ok()),
        is_colourful: colour::on_stdout(),
    }
}

/// Whether the locale has all characters.
fn is_unicode(variable: impl Fn(&str) -> Option<String>) -> bool {
    let set = |name: &&str| variable(name).filter(|value| !value.is_empty());
    let locale = ["LC_ALL", "LC_CTYPE", "LANG"].iter().find_map(set).unwrap_or_default().to_lowercase();
    cfg!(windows) || locale.contains("utf-8") || locale.contains("utf8")
}

#[cfg(test)]
mod tests {
    use super::is_unicode;

    #[test]
    fn the_first_locale_that_is_set_counts() {
        let locale = |set: &'static [(&str, &str)]| {
            is_unicode(|name| set.iter().find(|(n, _)| *n == name).map(|(_, value)| (*value).to_owned()))
        };
        assert!(locale(&[("LANG", "de_DE.UTF-8")]));
        assert!(locale(&[("LC_ALL", ""), ("LC_CTYPE", "C.utf8"), ("LANG", "C")]));
        assert!(cfg!(windows) || !locale(&[("LC_ALL", "C"), ("LANG", "en_GB.UTF-8")]));
        assert!(cfg!(windows) || !locale(&[]));
    }
}
