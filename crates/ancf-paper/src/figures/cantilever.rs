//! Figures 3 to 5.

use ancf_figure::{CurveStyle, DashPattern, Figure, FigureSeries, LegendPlacement, MarkerShape};

use super::common::{DIM, NONDIM, analysis_times, dim, elements, nondim, pale, scaled, stack};
use super::paper_figure::PaperFigure;
use crate::cases::models::DURATION;
use crate::cases::{PaperRuns, TimedRun};
use crate::page::number::{fixed, significant};
use crate::results::{FormValues, PaperResults};

/// Returns Figures 3, 4 and 5.
pub fn all(runs: &PaperRuns, results: &PaperResults) -> Vec<PaperFigure> {
    let mut figures = vec![figure3(&results.table4)];
    figures.extend(figure4(runs, results));
    figures.push(figure5(results));
    figures
}

fn figure3(table: &FormValues) -> PaperFigure {
    let ours = analysis_times("ancf: time (s)", &table.n, &table.dim, &table.nondim);
    let printed = |column: &Option<Vec<f64>>| column.clone().unwrap_or_default();
    let (paper_dim, paper_nondim) = (printed(&table.paper_dim), printed(&table.paper_nondim));
    let paper = analysis_times("paper: time (s)", &table.n, &paper_dim, &paper_nondim);
    let last = |column: &[f64]| significant(column.last().copied().unwrap_or(f64::NAN), 3);
    PaperFigure::new(
        "fig3",
        stack([ours, paper].map(|figure| Figure { height: 250.0, ..figure })),
        "Analysis time of the cantilever against the number of elements: ancf above, the paper's below. \
         The non-dimensional form is slower with few elements and faster with many, because its physical step grows like √n.",
    )
    .described(format!(
        "Two plots of analysis time against number of elements. At 20 elements ancf takes {} s (DIM) and \
         {} s (Non-DIM), the paper {} s and {} s.",
        last(&table.dim),
        last(&table.nondim),
        last(&paper_dim),
        last(&paper_nondim)
    ))
}

fn figure4(runs: &PaperRuns, results: &PaperResults) -> Option<PaperFigure> {
    let runs = runs.cantilever.last()?;
    let value = results.equation34.value;
    let deflection = |run: &TimedRun| scaled(1e3, run.column("tip.y"));
    let both = |label: &str, of: &dyn Fn(&TimedRun) -> Vec<f64>| {
        Figure::new("time (s)", label)
            .with(FigureSeries::new(DIM, runs.dim.column("t").to_vec(), of(&runs.dim)).style(dim()))
            .with(
                FigureSeries::new(NONDIM, runs.nondim.column("t").to_vec(), of(&runs.nondim)).style(nondim()),
            )
            .with(
                FigureSeries::horizontal("static, eq. (34)", value, (0.0, DURATION))
                    .style(CurveStyle::nth(0).dashed(DashPattern::Solid)),
            )
    };
    let tip = Figure { height: 300.0, ..both("tip deflection (mm)", &deflection) };
    let mut means = Figure { height: 200.0, ..both("mean up to then (mm)", &|run| means(&deflection(run))) };
    means.y.range = Some((value - 0.15, value + 0.15));
    let last = |column: &[f64]| fixed(column.last().copied().unwrap_or(f64::NAN), 4);
    let drawing = PaperFigure::new(
        "fig4",
        stack([tip, means]),
        format!(
            "TipState deflection of the cantilever of {} elements, released from the straight state, and its mean \
             over all instants so far. The beam has no material damping: the oscillation decays by the numerical \
             damping of β = 0.36, γ = 0.70, faster with the longer step of the non-dimensional \
             form. After 2 s the means are {} mm (DIM) and {} mm (Non-DIM).",
            runs.n,
            last(&results.table5.dim),
            last(&results.table5.nondim)
        ),
    );
    Some(drawing.described(format!(
        "A decaying oscillation between 0 and −4 mm about the static deflection of {} mm, on which the \
         running means settle.",
        fixed(value, 3)
    )))
}

/// Returns the running means.
fn means(values: &[f64]) -> Vec<f64> {
    let sums = values.iter().scan(0.0, |sum, x| {
        *sum += x;
        Some(*sum)
    });
    sums.enumerate().map(|(i, sum)| sum / (i + 1) as f64).collect()
}

fn figure5(results: &PaperResults) -> PaperFigure {
    let FormValues { n, dim: of_dim, nondim: of_nondim, paper_dim, .. } = &results.table5;
    let value = results.equation34.value;
    let fine: Vec<f64> = (0..=380).map(|i| 1.0 + 0.05 * f64::from(i)).collect();
    let locked = fine.iter().map(|n| value * (1.0 - 1.0 / (3.0 * n * n))).collect();
    let paper = paper_dim.clone().unwrap_or_default();
    let cross = CurveStyle::nth(2).dashed(DashPattern::None).marked(MarkerShape::Cross, 1);
    let mut figure = Figure::new("number of elements n", "mean tip deflection (mm)")
        .with(
            FigureSeries::horizontal("static, eq. (34)", value, (1.0, 20.0))
                .style(CurveStyle::nth(0).dashed(DashPattern::Solid)),
        )
        .with(FigureSeries::new("δ (1 − 1/(3n²))", fine, locked).style(pale()))
        .with(
            FigureSeries::new("paper, DIM", elements(n), paper)
                .style(CurveStyle::nth(0).dashed(DashPattern::None).marked(MarkerShape::Diamond, 1)),
        )
        .with(
            FigureSeries::new(DIM, elements(n), of_dim.clone())
                .style(dim().dashed(DashPattern::None).marked(MarkerShape::Circle, 1)),
        )
        .with(FigureSeries::new(NONDIM, elements(n), of_nondim.clone()).style(cross));
    figure.legend = LegendPlacement::Below;
    figure.height = 430.0;
    PaperFigure::new(
        "fig5",
        figure,
        "Shear locking: mean tip deflection against the number of elements. Without shear, n elements have \
         1 − 1/(3n²) of the exact static deflection; our means and the paper's follow that curve.",
    )
    .described(format!(
        "Mean deflections from {} mm at one element to {} mm at twenty approach the static {} mm.",
        fixed(of_dim.first().copied().unwrap_or(f64::NAN), 3),
        fixed(of_dim.last().copied().unwrap_or(f64::NAN), 3),
        fixed(value, 3)
    ))
}
