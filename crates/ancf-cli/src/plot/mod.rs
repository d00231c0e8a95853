//! `ancf plot`: columns of a run as a chart of characters or a figure.
//!
//! ```text
//! folder -> source, names -> columns -> panels, one per unit -> charts of characters
//!                                                \-> SVG, PNG
//! ```

mod canvas;
mod chart;
mod command;
#[cfg(feature = "figures")]
mod decimate;
#[cfg(feature = "figures")]
mod figure_file;
mod figure_format;
mod listing;
mod panel;
mod selection;
mod source;
mod tick;

pub use command::{PLOT_EXAMPLES, PlotArguments};
