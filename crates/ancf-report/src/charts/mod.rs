//! Charts of the columns of a run.

mod abscissa;
mod chart;
mod chart_groups;
mod charts_of_run;
mod decimate;

pub use abscissa::Abscissa;
pub(crate) use abscissa::positions_on_abscissa;
pub use chart::{Chart, ChartColumn};
pub use chart_groups::ChartGroup;
pub use charts_of_run::Charts;
