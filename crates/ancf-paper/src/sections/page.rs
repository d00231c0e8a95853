//! Page of the report.

use maud::{Markup, html};

use super::context::PageContext;
use super::{cantilever, conditioning, gain, iterations, pendulums, recovered, sources, summary};
use crate::figures::PaperFigure;
use crate::page::{HtmlPage, PageSection};
use crate::results::PaperResults;
use crate::tables::PaperTables;

/// Returns the page as HTML.
pub fn page(results: &PaperResults, tables: &PaperTables, figures: &[PaperFigure]) -> String {
    let sections = sections(&PageContext { results, tables, figures });
    HtmlPage { title: "Kim et al. (2017), reproduced", subtitle: subtitle(), sections }.into_text()
}

fn subtitle() -> Markup {
    html! {
        "Every table and figure of K.-W. Kim, J.-W. Lee, J.-S. Jang, J.-Y. Oh, J.-H. Kang, H.-R. Kim, \
        W.-S. Yoo, "
        cite { "Efficiency of non-dimensional analysis for absolute nodal coordinate formulation" }
        ", Nonlinear Dynamics 87 (2017), computed anew and set beside the printed numbers."
    }
}

fn sections(context: &PageContext<'_>) -> Vec<PageSection> {
    vec![
        PageSection::new("summary", "Summary", summary::section(context)),
        PageSection::new("cantilever", "Cantilever", cantilever::section(context)),
        PageSection::new("revolute", "Pendulum on a revolute joint", pendulums::revolute(context)),
        PageSection::new("spherical", "Pendulum on a spherical joint", pendulums::spherical(context)),
        PageSection::new("gain", "Factors of the gain", gain::section(context)),
        PageSection::new("iterations", "Meaning of the iteration counts", iterations::section(context)),
        PageSection::new("condition-numbers", "Conditioning", conditioning::section(context)),
        PageSection::new("gravity", "Acceleration of gravity", recovered::gravity(context)),
        PageSection::new("recovered", "Other recovered values and misprints", recovered::recovered()),
        PageSection::new("sources", "Measurement, files, sources", sources::section(context)),
    ]
}
