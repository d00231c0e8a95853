//! Figures of the report.

mod all;
mod cantilever;
mod common;
mod conditioning;
mod paper_figure;
mod revolute;
mod spherical;

pub use all::all_figures;
pub use paper_figure::PaperFigure;
