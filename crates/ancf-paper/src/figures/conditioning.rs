//! Condition numbers against the step; the paper has no such figure.

use super::Drawing;
use crate::figure::{Figure, Legend, Marker, Scale, Series, Style};
use crate::paper::conditioning::Writing;
use crate::paper::results::Results;

/// Condition numbers of the largest mesh, stiff.
pub fn figure(results: &Results) -> Drawing {
    let rows = &results.conditioning.stiff;
    let n = rows.iter().map(|row| row.n).max().unwrap_or(0);
    let rows: Vec<_> = rows.iter().filter(|row| row.n == n).collect();
    let markers = [
        Marker::Circle,
        Marker::Triangle,
        Marker::Square,
        Marker::Diamond,
        Marker::Cross,
        Marker::None,
        Marker::Circle,
    ];
    let series = |(i, (writing, marker)): (usize, (Writing, Marker))| {
        let h = rows.iter().map(|row| row.h).collect();
        let condition = rows.iter().map(|row| row.condition[i]).collect();
        Series::new(name(writing), h, condition).style(Style::nth(i).marked(marker, 1))
    };
    // Bottasso's scaling is the symmetric writing in other unknowns: one curve for both.
    let shown =
        Writing::ALL.into_iter().zip(markers).enumerate().filter(|(_, (w, _))| *w != Writing::Bottasso);
    let mut figure = Figure::new("physical step h (s)", "condition number");
    figure.series = shown.map(series).collect();
    (figure.x.scale, figure.y.scale) = (Scale::Log, Scale::Log);
    (figure.legend, figure.height) = (Legend::Below, 500.0);
    Drawing::new(
        "conditioning",
        figure,
        format!(
            "Condition number of the iteration matrix against the physical step, {n} elements, E = 193×10⁹ \
             Pa. Units shift the curve of eq. (37), they do not bend it. Dividing the constraint rows by \
             βh² and equilibration do."
        ),
    )
    .described(
        "Log-log plot. The displacement form rises most steeply as h falls, the three writings of eq. (37) \
         rise like h to the power −2, the symmetric and the equilibrated ones stay bounded.",
    )
}

/// Name in the legend.
const fn name(writing: Writing) -> &'static str {
    match writing {
        Writing::Dimensional => "eq. (37), DIM",
        Writing::LengthSlopes => "eq. (37), DIM, slopes × l",
        Writing::Paper => "eq. (37), Non-DIM",
        Writing::Symmetric => "symmetric, Bottasso",
        Writing::Displacement => "displacement form",
        Writing::Bottasso => "Bottasso",
        Writing::Equilibrated => "equilibrated",
    }
}
