//! Line and marker figures for reports: SVG text by `kuva`, PNG and PDF from that SVG by `resvg` and `pdf-writer`.
//!
//! ```text
//! data:     style   types
//! formats:  format (SVG, PNG, PDF)
//! drawing:  polyline -> draw -> legend
//! layout:   axis_layout -> plot
//! figures:  figure (plane, stacked panels), space
//! ```
//!
//! The SVG contains no ids, scripts or style sheets: any number of figures can be inlined in one page.

mod axis_layout;
mod draw;
mod figure;
mod format;
mod legend;
mod plot;
mod polyline;
mod space;
mod style;
#[cfg(test)]
mod tests;
mod types;

pub use format::svg::FigureError;
pub use space::{SpaceCurve, SpaceFigure};
pub use style::{CurveStyle, DashPattern, MarkerShape};
pub use types::{AxisScale, Figure, FigureAxis, FigurePanels, FigureSeries, LegendPlacement};
