//! All figures of the report.

use super::paper_figure::PaperFigure;
use super::{cantilever, conditioning, revolute, spherical};
use crate::cases::PaperRuns;
use crate::results::PaperResults;

/// Returns all figures, in the order of the paper.
pub fn all_figures(runs: &PaperRuns, results: &PaperResults) -> Vec<PaperFigure> {
    let mut figures = cantilever::all(runs, results);
    figures.extend(revolute::all(runs, results));
    figures.extend(spherical::all(runs, results));
    figures.push(conditioning::figure(results));
    figures
}
