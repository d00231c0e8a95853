//! All runs of the report, and what they measured.

use std::time::Instant;

use ancf::model::{Model, Stop};
use ancf::record::Series;
use ancf::{Outcome, Summary, simulate};
use anyhow::{Context, Result, ensure};
use serde::Serialize;

use super::cases::{Case, ELEMENTS, Form, STEP, time_unit};
use super::conditioning::{self, Row};
use crate::report::Machine;

/// Everything that the report shows.
#[derive(Debug)]
pub struct Study {
    /// Where it was measured.
    pub machine: Machine,
    /// Repetitions behind each median time.
    pub repeats: usize,
    /// The cantilever for each number of elements (Tables 4, 5).
    pub cantilever: Vec<Comparison>,
    /// The spherical pendulum for each number of elements (Table 7).
    pub spherical: Vec<Comparison>,
    /// The revolute pendulum of one element (Table 6).
    pub revolute: Comparison,
    /// Its iterations under absolute tolerances (Figure 7).
    pub tolerances: Vec<Tolerance>,
    /// The cantilever's mean tip deflection with g = 9.81, mm, for each number of elements: the two forms.
    pub mean_with_standard_gravity: Vec<[f64; 2]>,
    /// Condition numbers, E = 193e9.
    pub stiff: Vec<Row>,
    /// Condition numbers, E/1000.
    pub soft: Vec<Row>,
}

/// One problem and mesh in three ways.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// Number of elements.
    pub n: u32,
    /// Dimensional form, step 1 ms.
    pub dim: Run,
    /// Non-dimensional form, step 0.001 T_ND.
    pub nondim: Run,
    /// Non-dimensional form, step 1 ms of physical time as well.
    pub same_step: Run,
}

/// One run.
#[derive(Clone, Debug)]
pub struct Run {
    /// Physical step, s.
    pub step: f64,
    /// Median time of the simulation, s, one thread, without files.
    pub seconds: f64,
    /// How it went.
    pub summary: Summary,
    /// Everything recorded.
    pub series: Series,
}

impl Run {
    /// A column that every run of the paper has.
    pub fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap_or_default()
    }

    /// Number of instants, the first included.
    pub fn instants(&self) -> u64 {
        self.summary.steps + 1
    }

    /// Newton iterations per step.
    pub fn iterations_per_step(&self) -> f64 {
        self.summary.iterations as f64 / self.summary.steps as f64
    }

    /// Mean over all instants of the tip deflection, mm.
    pub fn mean_deflection(&self) -> f64 {
        let tip = self.column("tip.y");
        1e3 * tip.iter().sum::<f64>() / tip.len() as f64
    }
}

/// The revolute pendulum under an absolute tolerance of the residual.
#[derive(Clone, Debug, Serialize)]
pub struct Tolerance {
    /// Bound on |r|₂ in the numbers of each form.
    pub tolerance: f64,
    /// Iterations of each step, dimensional form.
    pub dim: Counts,
    /// Iterations of each step, non-dimensional form.
    pub nondim: Counts,
}

/// Newton iterations of each step of a run.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Counts {
    /// Time of each step, s.
    pub t: Vec<f64>,
    /// Iterations of each step.
    pub iterations: Vec<u32>,
    /// Time at which an iteration did not end within [`MOST_ITERATIONS`], if any.
    pub stalled_at: Option<f64>,
}

/// Iterations after which a step under an absolute tolerance is given up.
pub const MOST_ITERATIONS: u32 = 1000;
/// Absolute tolerances of the residual, from comfortable to below the rounding floor.
pub const TOLERANCES: [f64; 9] = [1e-6, 1e-7, 3e-8, 2e-8, 1e-8, 9e-9, 8e-9, 6e-9, 5e-9];
/// The usual acceleration of gravity, beside the recovered one, m/s².
pub const STANDARD_GRAVITY: f64 = 9.81;
/// Steps of the conditioning table, s.
const STEPS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

impl Study {
    /// Runs everything; `report` is told what comes next.
    ///
    /// # Errors
    /// If a run of the paper does not reach its end.
    pub fn run(repeats: usize, mut report: impl FnMut(&str)) -> Result<Self> {
        let mut compare_all = |case, name: &str| -> Result<Vec<Comparison>> {
            let compare = |&n: &u32| {
                report(&format!("{name}, {n} elements"));
                compare(case, n, repeats)
            };
            ELEMENTS.iter().map(compare).collect()
        };
        let cantilever = compare_all(Case::Cantilever, "cantilever")?;
        let spherical = compare_all(Case::Spherical, "spherical pendulum")?;
        report("revolute pendulum");
        let revolute = compare(Case::Revolute, 1, repeats)?;
        let tolerances =
            TOLERANCES.iter().map(|&tolerance| Tolerance::run(tolerance)).collect::<Result<_>>()?;
        report("cantilever with g = 9.81");
        let mean_with_standard_gravity =
            ELEMENTS.iter().map(|&n| standard_gravity(n)).collect::<Result<_>>()?;
        report("condition numbers");
        let rows = |young: f64| -> Result<Vec<Row>> {
            let pairs = [1, 10, 20].into_iter().flat_map(|n| STEPS.map(|h| (n, h)));
            pairs.map(|(n, h)| conditioning::row(young, n, h)).collect()
        };
        Ok(Self {
            machine: Machine::this(),
            repeats,
            cantilever,
            spherical,
            revolute,
            tolerances,
            mean_with_standard_gravity,
            stiff: rows(super::cases::YOUNG)?,
            soft: rows(super::cases::YOUNG / 1000.0)?,
        })
    }
}

/// The three ways of one problem, timed in turn so that a drift of the machine touches all alike.
fn compare(case: Case, n: u32, repeats: usize) -> Result<Comparison> {
    let scaled_step = STEP * time_unit(n);
    let models =
        [(Form::Dimensional, STEP), (Form::NonDimensional, scaled_step), (Form::NonDimensional, STEP)]
            .map(|(form, step)| case.model(form, n, step));
    let mut runs: [Vec<Run>; 3] = [const { Vec::new() }; 3];
    for _ in 0..repeats.max(1) {
        for (model, runs) in models.iter().zip(&mut runs) {
            runs.push(run(model)?);
        }
    }
    let [dim, nondim, same_step] = runs.map(median);
    Ok(Comparison { n, dim: dim?, nondim: nondim?, same_step: same_step? })
}

/// The last run with the median time of all.
fn median(mut runs: Vec<Run>) -> Result<Run> {
    let mut seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let median = seconds[seconds.len() / 2];
    let last = runs.pop().context("at least one run")?;
    Ok(Run { seconds: median, ..last })
}

/// One run to its end.
fn run(model: &Model) -> Result<Run> {
    let mut series = Series::new();
    let clock = Instant::now();
    let summary = simulate(model, &mut series)?;
    let seconds = clock.elapsed().as_secs_f64();
    ensure!(summary.outcome.is_finished(), "a run of the paper ended early: {:?}", summary.outcome);
    let settings = model.analysis.dynamics().context("the paper is about motion")?;
    let step = settings.step.fixed().context("the paper has steps of one size")?;
    Ok(Run { step, seconds, summary, series })
}

impl Tolerance {
    fn run(tolerance: f64) -> Result<Self> {
        let counts = |form, step| {
            let mut model = Case::Revolute.model(form, 1, step);
            let settings = model.analysis.dynamics_mut().context("the paper is about motion")?;
            settings.stop = Stop::Residual { tolerance };
            (settings.max_iterations, settings.max_halvings) = (MOST_ITERATIONS, 0);
            Counts::run(&model)
        };
        let dim = counts(Form::Dimensional, STEP)?;
        Ok(Self { tolerance, dim, nondim: counts(Form::NonDimensional, STEP * time_unit(1))? })
    }
}

impl Counts {
    fn run(model: &Model) -> Result<Self> {
        let mut series = Series::new();
        let summary = simulate(model, &mut series)?;
        let stalled_at = match summary.outcome {
            Outcome::Failed { time, .. } => Some(time),
            Outcome::Finished | Outcome::Stopped => None,
        };
        Ok(Self::of(&series, stalled_at))
    }

    /// The counts of a recorded run.
    pub fn of(series: &Series, stalled_at: Option<f64>) -> Self {
        // The first instant is the start, to which no step leads.
        let column = |name| series.column(name).unwrap_or_default().iter().skip(1).copied();
        Self {
            t: column("t").collect(),
            iterations: column("iterations").map(|x| x as u32).collect(),
            stalled_at,
        }
    }

    /// The most iterations of one step.
    pub fn most(&self) -> u32 {
        self.iterations.iter().copied().max().unwrap_or(0)
    }
}

/// Mean tip deflection of the cantilever with the usual gravity in the two forms, mm.
fn standard_gravity(n: u32) -> Result<[f64; 2]> {
    let mean = |form, step| -> Result<f64> {
        let mut model = Case::Cantilever.model(form, n, step);
        model.gravity[1] = -STANDARD_GRAVITY;
        Ok(run(&model)?.mean_deflection())
    };
    let unit = (super::cases::LENGTH * f64::from(n) / STANDARD_GRAVITY).sqrt();
    Ok([mean(Form::Dimensional, STEP)?, mean(Form::NonDimensional, STEP * unit)?])
}
