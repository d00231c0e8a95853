//! Figures 7 to 9.

use ancf_figure::{AxisScale, CurveStyle, DashPattern, Figure, FigureSeries, LegendPlacement};

use super::common::{DIM, NONDIM, RIGID, dim, nondim, pale, stack};
use super::paper_figure::PaperFigure;
use crate::cases::models::{DIAMETER, GRAVITY, LENGTH};
use crate::cases::{CompoundPendulum, MAX_ITERATIONS, PaperRuns, TimedRun, TipState};
use crate::page::number::{fixed, scientific};
use crate::results::{Figure7, PaperResults, StepCounts};

/// Returns Figures 7, 8a, 8b and 9.
pub fn all(runs: &PaperRuns, results: &PaperResults) -> Vec<PaperFigure> {
    let motion = Motion::new(runs);
    vec![figure7(&results.fig7), motion.figure8a(), motion.figure8b(), motion.figure9()]
}

/// Returns the iterations per step of both forms.
fn counts(label: &str, counts: &StepCounts) -> Figure {
    let numbers = |counts: &[u32]| counts.iter().copied().map(f64::from).collect();
    // Dashes are not visible where counts alternate.
    let solid = nondim().dashed(DashPattern::Solid);
    Figure::new("time (s)", label)
        .with(FigureSeries::new(DIM, counts.t_dim.clone(), numbers(&counts.dim)).style(dim()))
        .with(FigureSeries::new(NONDIM, counts.t_nondim.clone(), numbers(&counts.nondim)).style(solid))
}

fn figure7(figure: &Figure7) -> PaperFigure {
    let most = figure.absolute.dim.iter().copied().max().unwrap_or(0);
    let mut absolute = counts("iterations, absolute rule", &figure.absolute);
    if let Some(t) = figure.stalled_at {
        let top = 2.0 * f64::from(most.max(10));
        let stall = FigureSeries::new("", vec![t, t], vec![0.7, top])
            .style(CurveStyle::nth(0).dashed(DashPattern::Dotted));
        absolute = absolute.with(stall);
    }
    absolute.y.scale = AxisScale::Log;
    absolute.height = 320.0;
    let mut blind = counts("iterations, unit-blind rule", &figure.unit_blind);
    let largest = figure.unit_blind.dim.iter().chain(&figure.unit_blind.nondim).copied().max().unwrap_or(0);
    blind.y.range = Some((0.0, f64::from(largest) + 1.0));
    blind.height = 220.0;
    let end = figure.stalled_at.map_or_else(String::new, |t| {
        format!(
            ", and at {} s (dotted) one that does not converge in {} iterations",
            fixed(t, 3),
            MAX_ITERATIONS
        )
    });
    let largest_nondim = figure.absolute.nondim.iter().copied().max().unwrap_or(0);
    PaperFigure::new(
        "fig7",
        stack([absolute, blind]),
        format!(
            "Newton iterations of each step, revolute pendulum of one element. Above: every step must \
             reach |r| ≤ {} in the units of its form; the dimensional form has steps of up to {most} \
             iterations{end}, the non-dimensional one none above {largest_nondim}. Below: the unit-blind \
             rule, under which both need at most {largest}.",
            scientific(figure.tolerance, 1)
        ),
    )
    .described(format!(
        "Two plots of iterations against time. Under the absolute tolerance the dimensional form reaches \
         {most} iterations, the non-dimensional one {largest_nondim}; under the unit-blind rule both stay \
         at or below {largest}."
    ))
}

/// Motion of the tip: both forms and the rigid body.
struct Motion<'a> {
    dim: &'a TimedRun,
    nondim: &'a TimedRun,
    pendulum: CompoundPendulum,
    rigid: Vec<TipState>,
}

impl<'a> Motion<'a> {
    fn new(runs: &'a PaperRuns) -> Self {
        let pendulum = CompoundPendulum::new(LENGTH, DIAMETER, GRAVITY);
        let (dim, nondim) = (&runs.revolute.dim, &runs.revolute.nondim);
        let rigid = dim.column("t").iter().map(|&t| pendulum.tip(t)).collect();
        Self { dim, nondim, pendulum, rigid }
    }

    fn history(&self, label: &str, column: &str, rigid: impl Fn(&TipState) -> f64) -> Figure {
        let t = |run: &TimedRun| run.column("t").to_vec();
        let values = self.rigid.iter().map(rigid).collect();
        let mut figure = Figure::new("time (s)", label)
            .with(FigureSeries::new(RIGID, t(self.dim), values).style(pale()))
            .with(FigureSeries::new(DIM, t(self.dim), self.dim.column(column).to_vec()).style(dim()))
            .with(
                FigureSeries::new(NONDIM, t(self.nondim), self.nondim.column(column).to_vec())
                    .style(nondim()),
            );
        figure.height = 230.0;
        figure
    }

    /// Returns the largest distance of the tip of a run from the tip of the rigid body, mm.
    fn distance(&self, run: &TimedRun) -> f64 {
        let (t, x, y) = (run.column("t"), run.column("tip.x"), run.column("tip.y"));
        let distances = t.iter().zip(x).zip(y).map(|((&t, x), y)| {
            let rigid = self.pendulum.tip(t).position;
            (x - rigid[0]).hypot(y - rigid[1])
        });
        1e3 * distances.fold(0.0, f64::max)
    }

    fn figure8a(&self) -> PaperFigure {
        let x = self.history("tip x (m)", "tip.x", |tip| tip.position[0]);
        let y = self.history("tip y (m)", "tip.y", |tip| tip.position[1]);
        PaperFigure::new(
            "fig8a",
            stack([x, y]),
            format!(
                "TipState of the revolute pendulum against time. The beam moves like the rigid body: the difference \
                 of its tip is at most {} mm (DIM) and {} mm (Non-DIM), less with the shorter step.",
                fixed(self.distance(self.dim), 1),
                fixed(self.distance(self.nondim), 1)
            ),
        )
        .described(
            "x swings between 1 m and −1 m, y between 0 and −1 m; the three curves coincide on this \
                    scale.",
        )
    }

    fn figure8b(&self) -> PaperFigure {
        let path = |run: &TimedRun| [run.column("tip.x").to_vec(), run.column("tip.y").to_vec()];
        let rigid = |axis: usize| self.rigid.iter().map(|tip| tip.position[axis]).collect();
        let ([x1, y1], [x2, y2]) = (path(self.dim), path(self.nondim));
        let mut figure = Figure::new("tip x (m)", "tip y (m)")
            .with(FigureSeries::new(RIGID, rigid(0), rigid(1)).style(pale()))
            .with(FigureSeries::new(DIM, x1, y1).style(dim()))
            .with(FigureSeries::new(NONDIM, x2, y2).style(nondim()));
        (figure.equal_aspect, figure.legend) = (true, LegendPlacement::Below);
        PaperFigure::new(
            "fig8b",
            figure,
            "Path of the tip of the revolute pendulum: a half circle of radius 1 m.",
        )
        .described("Three coinciding half circles below the hinge.")
    }

    fn figure9(&self) -> PaperFigure {
        let x = self.history("tip acceleration x (m/s²)", "tip.ax", |tip| tip.acceleration[0]);
        let y = self.history("tip acceleration y (m/s²)", "tip.ay", |tip| tip.acceleration[1]);
        PaperFigure::new(
            "fig9",
            stack([x, y]),
            "TipState acceleration of the revolute pendulum. After the release the flexible beam vibrates about the \
             rigid motion; the numerical damping of the scheme reduces the vibration. The shorter step of the \
             non-dimensional form at one element damps it less.",
        )
        .described(
            "The accelerations of both flexible models ring for a fraction of a second about those \
                    of the rigid body.",
        )
    }
}
