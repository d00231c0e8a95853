//! Figures 11 to 13.

use ancf_figure::{
    CurveStyle, DashPattern, Figure, FigurePanels, FigureSeries, LegendPlacement, SpaceCurve, SpaceFigure,
};

use super::common::{DIM, NONDIM, analysis_times, dim, nondim};
use super::paper_figure::PaperFigure;
use crate::cases::{CaseRuns, PaperRuns, TimedRun};
use crate::page::number::scientific;
use crate::results::{PaperResults, Table7};

/// Returns Figures 11, 12a, 12b, 13a and 13b.
pub fn all(runs: &PaperRuns, results: &PaperResults) -> Vec<PaperFigure> {
    let mut figures = vec![figure11(&results.table7)];
    if let Some(runs) = runs.spherical.last() {
        figures.extend([figure12a(runs), figure12b(runs), figure13a(runs), figure13b(runs)]);
    }
    figures
}

fn figure11(table: &Table7) -> PaperFigure {
    let forms = &table.seconds;
    let figure = analysis_times("analysis time (s)", &forms.n, &forms.dim, &forms.nondim);
    PaperFigure::new(
        "fig11",
        figure,
        "Analysis time of the spherical pendulum against the number of elements. The dimensional form has the same \
         number of steps for every n: its time grows like n. The non-dimensional form has fewer steps by the factor \
         √n: its time grows like √n.",
    )
    .described(
        "Both times grow with the number of elements; that of the non-dimensional form grows more \
                slowly.",
    )
}

/// Returns x in one panel, and y and z, which coincide, in another.
fn histories(runs: &CaseRuns, quantity: &str, unit: &str, columns: [&str; 3]) -> FigurePanels {
    let series = |name: &str, run: &TimedRun, column: &str, style: CurveStyle| {
        FigureSeries::new(name, run.column("t").to_vec(), run.column(column).to_vec()).style(style)
    };
    let [x, y, z] = columns;
    let first = Figure::new("time (s)", format!("{quantity} x ({unit})"))
        .with(series(DIM, &runs.dim, x, dim()))
        .with(series(NONDIM, &runs.nondim, x, nondim()));
    let second = Figure::new("time (s)", format!("{quantity} y, z ({unit})"))
        .with(series("DIM y", &runs.dim, y, dim().wide(4.0)))
        .with(series("DIM z", &runs.dim, z, dim()))
        .with(series("Non-DIM y", &runs.nondim, y, nondim()))
        .with(series("Non-DIM z", &runs.nondim, z, CurveStyle::nth(0).dashed(DashPattern::Dotted)));
    FigurePanels::new([first, second].map(|figure| Figure { height: 260.0, ..figure }).to_vec())
}

/// Returns the largest |y − z| of both forms.
fn asymmetry(runs: &CaseRuns, y: &str, z: &str) -> f64 {
    let of = |run: &TimedRun| {
        run.column(y).iter().zip(run.column(z)).map(|(y, z)| (y - z).abs()).fold(0.0, f64::max)
    };
    of(&runs.dim).max(of(&runs.nondim))
}

fn figure12a(runs: &CaseRuns) -> PaperFigure {
    PaperFigure::new(
        "fig12a",
        histories(runs, "tip", "m", ["tip.x", "tip.y", "tip.z"]),
        format!(
            "TipState of the spherical pendulum of {} elements against time. Gravity acts along −y and as much \
             along −z, so y and z must coincide; they do to {} m.",
            runs.n,
            scientific(asymmetry(runs, "tip.y", "tip.z"), 1)
        ),
    )
    .described(
        "x swings from 1 m to about −1 m and back; y and z fall together, rise and fall again; both \
                forms nearly coincide.",
    )
}

fn figure12b(runs: &CaseRuns) -> PaperFigure {
    let path = |run: &TimedRun| -> Vec<[f64; 3]> {
        let (x, y, z) = (run.column("tip.x"), run.column("tip.y"), run.column("tip.z"));
        x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z]).collect()
    };
    let figure = SpaceFigure {
        labels: ["x (m)", "y (m)", "z (m)"].map(str::to_owned),
        curves: vec![
            SpaceCurve::new(DIM, path(&runs.dim), dim()),
            SpaceCurve::new(NONDIM, path(&runs.nondim), nondim()),
        ],
        legend: LegendPlacement::Below,
        height: 410.0,
        ..SpaceFigure::default()
    };
    PaperFigure::new(
        "fig12b",
        figure,
        "Path of the tip of the spherical pendulum in space, with its projection on the floor.",
    )
    .described("An arc in the plane y = z, from the horizontal down through the lowest point and up again.")
}

fn figure13a(runs: &CaseRuns) -> PaperFigure {
    PaperFigure::new(
        "fig13a",
        histories(runs, "acceleration", "m/s²", ["tip.ax", "tip.ay", "tip.az"]),
        format!(
            "TipState acceleration of the spherical pendulum; y and z coincide to {} m/s². The ripple is due to the \
             beam, which is a thousand times softer than steel.",
            scientific(asymmetry(runs, "tip.ay", "tip.az"), 1)
        ),
    )
    .described(
        "Accelerations of some ten m/s² with a ripple; both forms and both directions nearly \
                coincide.",
    )
}

fn figure13b(runs: &CaseRuns) -> PaperFigure {
    PaperFigure::new(
        "fig13b",
        histories(runs, "reaction", "N", ["joint.fx", "joint.fy", "joint.fz"]),
        format!(
            "Force of the spherical joint on the beam; y and z coincide to {} N.",
            scientific(asymmetry(runs, "joint.fy", "joint.fz"), 1)
        ),
    )
    .described(
        "Reaction forces of some hundred newtons with a ripple; both forms and both directions \
                nearly coincide.",
    )
}
