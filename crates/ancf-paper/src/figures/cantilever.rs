//! Figures 3 to 5.

use super::{DIM, Drawing, NONDIM, dim, elements, nondim, pale, stack, times};
use crate::figure::{Dash, Figure, Legend, Marker, Series, Style};
use crate::paper::cases::DURATION;
use crate::paper::results::{Forms, Results};
use crate::paper::study::{Run, Study};
use crate::report::number::{fixed, significant};

/// Figures 3, 4 and 5.
pub fn all(study: &Study, results: &Results) -> Vec<Drawing> {
    let mut drawings = vec![figure3(&results.table4)];
    drawings.extend(figure4(study, results));
    drawings.push(figure5(results));
    drawings
}

/// Time of analysis against the number of elements.
pub fn times_of_analysis(label: &str, n: &[u32], of_dim: &[f64], of_nondim: &[f64]) -> Figure {
    let mut figure = Figure::new("number of elements", label)
        .with(Series::new(DIM, elements(n), of_dim.to_vec()).style(dim().marked(Marker::Circle, 1)))
        .with(Series::new(NONDIM, elements(n), of_nondim.to_vec()).style(nondim().marked(Marker::Square, 1)));
    let most = of_dim.iter().chain(of_nondim).copied().fold(0.0, f64::max);
    figure.y.range = Some((0.0, 1.08 * most));
    figure
}

fn figure3(table: &Forms) -> Drawing {
    let ours = times_of_analysis("ours: time (s)", &table.n, &table.dim, &table.nondim);
    let printed = |column: &Option<Vec<f64>>| column.clone().unwrap_or_default();
    let (paper_dim, paper_nondim) = (printed(&table.paper_dim), printed(&table.paper_nondim));
    let paper = times_of_analysis("paper: time (s)", &table.n, &paper_dim, &paper_nondim);
    let last = |column: &[f64]| significant(column.last().copied().unwrap_or(f64::NAN), 3);
    Drawing::new(
        "fig3",
        stack([ours, paper].map(|figure| Figure { height: 250.0, ..figure })),
        "Analysis time of the cantilever against the number of elements: ours above, the paper's below. \
         The non-dimensional form is slower with few elements and faster with many, because its physical \
         step grows like the root of n.",
    )
    .described(format!(
        "Two plots of analysis time against number of elements. At 20 elements ours takes {} s (DIM) and \
         {} s (Non-DIM), the paper {} s and {} s.",
        last(&table.dim),
        last(&table.nondim),
        last(&paper_dim),
        last(&paper_nondim)
    ))
}

fn figure4(study: &Study, results: &Results) -> Option<Drawing> {
    let runs = study.cantilever.last()?;
    let value = results.equation34.value;
    let deflection = |run: &Run| times(1e3, run.column("tip.y"));
    let both = |label: &str, of: &dyn Fn(&Run) -> Vec<f64>| {
        Figure::new("time (s)", label)
            .with(Series::new(DIM, runs.dim.column("t").to_vec(), of(&runs.dim)).style(dim()))
            .with(Series::new(NONDIM, runs.nondim.column("t").to_vec(), of(&runs.nondim)).style(nondim()))
            .with(
                Series::horizontal("static, eq. (34)", value, (0.0, DURATION))
                    .style(Style::nth(0).dashed(Dash::Solid)),
            )
    };
    let tip = Figure { height: 300.0, ..both("tip deflection (mm)", &deflection) };
    let mut means = Figure { height: 200.0, ..both("mean up to then (mm)", &|run| means(&deflection(run))) };
    means.y.range = Some((value - 0.15, value + 0.15));
    let last = |column: &[f64]| fixed(column.last().copied().unwrap_or(f64::NAN), 4);
    let drawing = Drawing::new(
        "fig4",
        stack([tip, means]),
        format!(
            "Tip deflection of the cantilever of {} elements, dropped from straight, and its mean over all \
             instants up to then. The beam has no damping of its own: the oscillation dies by the \
             numerical damping of β = 0.36, γ = 0.70, faster with the longer step of the non-dimensional \
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

/// Mean of all values up to each.
fn means(values: &[f64]) -> Vec<f64> {
    let sums = values.iter().scan(0.0, |sum, x| {
        *sum += x;
        Some(*sum)
    });
    sums.enumerate().map(|(i, sum)| sum / (i + 1) as f64).collect()
}

fn figure5(results: &Results) -> Drawing {
    let Forms { n, dim: of_dim, nondim: of_nondim, paper_dim, .. } = &results.table5;
    let value = results.equation34.value;
    let fine: Vec<f64> = (0..=380).map(|i| 1.0 + 0.05 * f64::from(i)).collect();
    let locked = fine.iter().map(|n| value * (1.0 - 1.0 / (3.0 * n * n))).collect();
    let paper = paper_dim.clone().unwrap_or_default();
    let cross = Style::nth(2).dashed(Dash::None).marked(Marker::Cross, 1);
    let mut figure = Figure::new("number of elements n", "mean tip deflection (mm)")
        .with(
            Series::horizontal("static, eq. (34)", value, (1.0, 20.0))
                .style(Style::nth(0).dashed(Dash::Solid)),
        )
        .with(Series::new("δ (1 − 1/(3n²))", fine, locked).style(pale()))
        .with(
            Series::new("paper, DIM", elements(n), paper)
                .style(Style::nth(0).dashed(Dash::None).marked(Marker::Diamond, 1)),
        )
        .with(
            Series::new(DIM, elements(n), of_dim.clone())
                .style(dim().dashed(Dash::None).marked(Marker::Circle, 1)),
        )
        .with(Series::new(NONDIM, elements(n), of_nondim.clone()).style(cross));
    figure.legend = Legend::Below;
    figure.height = 430.0;
    Drawing::new(
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
