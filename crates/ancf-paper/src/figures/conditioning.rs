//! Condition numbers against the step. The paper has no such figure.

use ancf_figure::{AxisScale, CurveStyle, Figure, FigureSeries, LegendPlacement, MarkerShape};

use super::paper_figure::PaperFigure;
use crate::cases::MatrixForm;
use crate::results::PaperResults;

/// Returns the condition numbers of the largest mesh, E = 193e9 Pa.
pub fn figure(results: &PaperResults) -> PaperFigure {
    let rows = &results.conditioning.stiff;
    let n = rows.iter().map(|row| row.n).max().unwrap_or(0);
    let rows: Vec<_> = rows.iter().filter(|row| row.n == n).collect();
    let markers = [
        MarkerShape::Circle,
        MarkerShape::Triangle,
        MarkerShape::Square,
        MarkerShape::Diamond,
        MarkerShape::Cross,
        MarkerShape::None,
        MarkerShape::Circle,
    ];
    let series = |(i, (form, marker)): (usize, (MatrixForm, MarkerShape))| {
        let h = rows.iter().map(|row| row.h).collect();
        let condition = rows.iter().map(|row| row.condition[i]).collect();
        FigureSeries::new(name(form), h, condition).style(CurveStyle::nth(i).marked(marker, 1))
    };
    // The form of Bottasso et al. has the condition numbers of the symmetric form: one curve for both.
    let shown =
        MatrixForm::ALL.into_iter().zip(markers).enumerate().filter(|(_, (w, _))| *w != MatrixForm::Bottasso);
    let mut figure = Figure::new("physical step h (s)", "condition number");
    figure.series = shown.map(series).collect();
    (figure.x.scale, figure.y.scale) = (AxisScale::Log, AxisScale::Log);
    (figure.legend, figure.height) = (LegendPlacement::Below, 500.0);
    PaperFigure::new(
        "conditioning",
        figure,
        format!(
            "Condition number of the iteration matrix against the physical step, {n} elements, E = 193×10⁹ \
             Pa. Units shift the curve of eq. (37) without changing its slope. Division of the constraint rows by βh² \
             and equilibration change the slope."
        ),
    )
    .described(
        "Log-log plot. The displacement form rises most steeply as h falls, the three forms of eq. (37) \
         rise like h to the power −2, the symmetric and the equilibrated ones stay bounded.",
    )
}

/// Returns the name in the legend.
const fn name(form: MatrixForm) -> &'static str {
    match form {
        MatrixForm::Dimensional => "eq. (37), DIM",
        MatrixForm::LengthSlopes => "eq. (37), DIM, slopes × l",
        MatrixForm::Paper => "eq. (37), Non-DIM",
        MatrixForm::Symmetric => "symmetric, Bottasso",
        MatrixForm::Displacement => "displacement form",
        MatrixForm::Bottasso => "Bottasso",
        MatrixForm::Equilibrated => "equilibrated",
    }
}
