//! Results, tables and figures of the page.

use maud::{Markup, html};

use crate::cases::PaperCase;
use crate::figures::PaperFigure;
use crate::page::figure;
use crate::results::{Gain, PaperResults};
use crate::tables::PaperTables;

/// Content of the page.
pub(super) struct PageContext<'a> {
    pub(super) results: &'a PaperResults,
    pub(super) tables: &'a PaperTables,
    pub(super) figures: &'a [PaperFigure],
}

impl PageContext<'_> {
    /// Returns a figure with its number.
    pub(super) fn figure(&self, file: &str, number: &str) -> Markup {
        let Some(found) = self.figures.iter().find(|figure| figure.file == file) else {
            return html! {};
        };
        let caption = html! {
            strong { (number) ". " } (found.caption) " "
            span.files { a href={ (file) ".svg" } { "SVG" } " " a href={ (file) ".png" } { "PNG" } }
        };
        figure(file, found.svg(), &caption)
    }

    /// Returns the gain of a problem with the largest mesh.
    pub(super) fn largest(&self, problem: PaperCase) -> &Gain {
        let of_problem = self.results.gain.iter().filter(|gain| gain.problem == problem);
        // Every problem has a gain; the first one is never used.
        of_problem.max_by_key(|gain| gain.n).unwrap_or(&self.results.gain[0])
    }
}
