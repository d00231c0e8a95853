//! Line and marker figures for reports: SVG text by `kuva`, PNG from that SVG by `resvg`.
//!
//! ```text
//! data:     style   types
//! drawing:  svg -> polyline -> draw -> legend
//! layout:   axis_layout -> plot
//! figures:  figure (plane, stacked panels), space
//! ```
//!
//! The SVG contains no ids, scripts or style sheets: any number of figures can be inlined in one page.

mod axis_layout;
mod draw;
mod figure;
mod legend;
mod plot;
mod polyline;
mod space;
mod style;
mod svg;
#[cfg(test)]
mod tests;
mod types;

pub use space::{SpaceCurve, SpaceFigure};
pub use style::{CurveStyle, DashPattern, MarkerShape};
pub use svg::FigureError;
pub use types::{AxisScale, Figure, FigureAxis, FigurePanels, FigureSeries, LegendPlacement};
