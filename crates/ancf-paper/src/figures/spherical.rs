//! Figures 11 to 13.

use super::{DIM, Drawing, NONDIM, cantilever, dim, nondim};
use crate::figure::{Dash, Figure, Legend, Panels, Series, SpaceFigure, SpaceSeries, Style};
use crate::paper::results::{Results, Table7};
use crate::paper::study::{Comparison, Run, Study};
use crate::report::number::scientific;

/// Figures 11, 12a, 12b, 13a and 13b.
pub fn all(study: &Study, results: &Results) -> Vec<Drawing> {
    let mut drawings = vec![figure11(&results.table7)];
    if let Some(runs) = study.spherical.last() {
        drawings.extend([figure12a(runs), figure12b(runs), figure13a(runs), figure13b(runs)]);
    }
    drawings
}

fn figure11(table: &Table7) -> Drawing {
    let forms = &table.seconds;
    let figure = cantilever::times_of_analysis("analysis time (s)", &forms.n, &forms.dim, &forms.nondim);
    Drawing::new(
        "fig11",
        figure,
        "Analysis time of the spherical pendulum against the number of elements. The dimensional form has \
         as many steps for every n, so its time grows like n; the non-dimensional one has fewer by the \
         root of n, so its time grows like the root of n.",
    )
    .described(
        "Both times grow with the number of elements; that of the non-dimensional form grows more \
                slowly.",
    )
}

/// x in one panel, y and z, which coincide, in another.
fn histories(runs: &Comparison, quantity: &str, unit: &str, columns: [&str; 3]) -> Panels {
    let series = |name: &str, run: &Run, column: &str, style: Style| {
        Series::new(name, run.column("t").to_vec(), run.column(column).to_vec()).style(style)
    };
    let [x, y, z] = columns;
    let first = Figure::new("time (s)", format!("{quantity} x ({unit})"))
        .with(series(DIM, &runs.dim, x, dim()))
        .with(series(NONDIM, &runs.nondim, x, nondim()));
    let second = Figure::new("time (s)", format!("{quantity} y, z ({unit})"))
        .with(series("DIM y", &runs.dim, y, dim().wide(4.0)))
        .with(series("DIM z", &runs.dim, z, dim()))
        .with(series("Non-DIM y", &runs.nondim, y, nondim()))
        .with(series("Non-DIM z", &runs.nondim, z, Style::nth(0).dashed(Dash::Dotted)));
    Panels::new([first, second].map(|figure| Figure { height: 260.0, ..figure }).to_vec())
}

/// Largest |y − z| of both forms.
fn asymmetry(runs: &Comparison, y: &str, z: &str) -> f64 {
    let of =
        |run: &Run| run.column(y).iter().zip(run.column(z)).map(|(y, z)| (y - z).abs()).fold(0.0, f64::max);
    of(&runs.dim).max(of(&runs.nondim))
}

fn figure12a(runs: &Comparison) -> Drawing {
    Drawing::new(
        "fig12a",
        histories(runs, "tip", "m", ["tip.x", "tip.y", "tip.z"]),
        format!(
            "Tip of the spherical pendulum of {} elements against time. Gravity acts along −y and as much \
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

fn figure12b(runs: &Comparison) -> Drawing {
    let path = |run: &Run| -> Vec<[f64; 3]> {
        let (x, y, z) = (run.column("tip.x"), run.column("tip.y"), run.column("tip.z"));
        x.iter().zip(y).zip(z).map(|((&x, &y), &z)| [x, y, z]).collect()
    };
    let figure = SpaceFigure {
        labels: ["x (m)", "y (m)", "z (m)"].map(str::to_owned),
        series: vec![
            SpaceSeries::new(DIM, path(&runs.dim), dim()),
            SpaceSeries::new(NONDIM, path(&runs.nondim), nondim()),
        ],
        legend: Legend::Below,
        height: 410.0,
        ..SpaceFigure::default()
    };
    Drawing::new(
        "fig12b",
        figure,
        "Path of the tip of the spherical pendulum in space, with its shadow on the floor.",
    )
    .described("An arc in the plane y = z, from the horizontal down through the lowest point and up again.")
}

fn figure13a(runs: &Comparison) -> Drawing {
    Drawing::new(
        "fig13a",
        histories(runs, "acceleration", "m/s²", ["tip.ax", "tip.ay", "tip.az"]),
        format!(
            "Tip acceleration of the spherical pendulum; y and z coincide to {} m/s². The ripple is that \
             of a beam a thousand times softer than steel.",
            scientific(asymmetry(runs, "tip.ay", "tip.az"), 1)
        ),
    )
    .described(
        "Accelerations of some ten m/s² with a ripple; both forms and both directions nearly \
                coincide.",
    )
}

fn figure13b(runs: &Comparison) -> Drawing {
    Drawing::new(
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
