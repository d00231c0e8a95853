//! Styles, names and conversions that several figures share.

use ancf_figure::{
    CurveStyle, DashPattern, Figure, FigurePanels, FigureSeries, LegendPlacement, MarkerShape,
};

/// Name of the dimensional form in legends.
pub(super) const DIM: &str = "DIM";
/// Name of the non-dimensional form in legends.
pub(super) const NONDIM: &str = "Non-DIM";
/// Name of the rigid body in legends.
pub(super) const RIGID: &str = "rigid body";

/// CurveStyle of the dimensional form: blue, solid.
pub(super) fn dim() -> CurveStyle {
    CurveStyle::nth(1).dashed(DashPattern::Solid)
}

/// CurveStyle of the non-dimensional form: vermilion, dashed, so that curves below remain visible.
pub(super) fn nondim() -> CurveStyle {
    CurveStyle::nth(2).dashed(DashPattern::Dashed)
}

/// CurveStyle of references: wide, pale grey, below other curves.
pub(super) fn pale() -> CurveStyle {
    CurveStyle::nth(7).wide(5.0)
}

/// Stacks panels of the same curves. The first has the legend.
pub(super) fn stack<const N: usize>(figures: [Figure; N]) -> FigurePanels {
    let mut panels = FigurePanels::new(figures.to_vec());
    for figure in panels.figures.iter_mut().skip(1) {
        figure.legend = LegendPlacement::Hidden;
    }
    panels
}

/// Converts a column into another unit.
pub(super) fn scaled(factor: f64, column: &[f64]) -> Vec<f64> {
    column.iter().map(|x| factor * x).collect()
}

/// Returns the numbers of elements as abscissas.
pub(super) fn elements(n: &[u32]) -> Vec<f64> {
    n.iter().copied().map(f64::from).collect()
}

/// Returns the analysis time against the number of elements.
pub(super) fn analysis_times(label: &str, n: &[u32], of_dim: &[f64], of_nondim: &[f64]) -> Figure {
    let mut figure = Figure::new("number of elements", label)
        .with(
            FigureSeries::new(DIM, elements(n), of_dim.to_vec()).style(dim().marked(MarkerShape::Circle, 1)),
        )
        .with(
            FigureSeries::new(NONDIM, elements(n), of_nondim.to_vec())
                .style(nondim().marked(MarkerShape::Square, 1)),
        );
    let most = of_dim.iter().chain(of_nondim).copied().fold(0.0, f64::max);
    figure.y.range = Some((0.0, 1.08 * most));
    figure
}
