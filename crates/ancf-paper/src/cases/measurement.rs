//! Runs of the report and their measurements.

use std::time::Instant;

use ancf::Model;
use ancf::model::Stop;
use ancf::record::Series;
use ancf::{Outcome, Summary, simulate};
use anyhow::{Context, Result, ensure};
use serde::Serialize;

use super::conditioning::{ConditionRow, condition_row};
use super::models::{ELEMENTS, EquationForm, LENGTH, PaperCase, STEP, YOUNG, time_unit};
use crate::page::MachineInfo;

/// All measurements of the report.
#[derive(Debug)]
pub struct PaperRuns {
    /// Machine of the measurements.
    pub machine: MachineInfo,
    /// Repetitions per median time.
    pub repeats: usize,
    /// Cantilever for each number of elements (Tables 4, 5).
    pub cantilever: Vec<CaseRuns>,
    /// Spherical pendulum for each number of elements (Table 7).
    pub spherical: Vec<CaseRuns>,
    /// Revolute pendulum of one element (Table 6).
    pub revolute: CaseRuns,
    /// Iterations of the revolute pendulum under absolute tolerances (Figure 7).
    pub tolerances: Vec<ToleranceRuns>,
    /// Mean tip deflection of the cantilever with g = 9.81, mm, for each number of elements: both forms.
    pub mean_with_standard_gravity: Vec<[f64; 2]>,
    /// Condition numbers, E = 193e9.
    pub stiff: Vec<ConditionRow>,
    /// Condition numbers, E/1000.
    pub soft: Vec<ConditionRow>,
}

/// Runs of one problem and mesh.
#[derive(Clone, Debug)]
pub struct CaseRuns {
    /// Number of elements.
    pub n: u32,
    /// Dimensional form, step 1 ms.
    pub dim: TimedRun,
    /// Non-dimensional form, step 0.001 T_ND.
    pub nondim: TimedRun,
    /// Non-dimensional form, physical step 1 ms.
    pub same_step: TimedRun,
}

/// Run with its time.
#[derive(Clone, Debug)]
pub struct TimedRun {
    /// Physical step, s.
    pub step: f64,
    /// Median wall-clock time of the simulation, s, one thread, without files.
    pub seconds: f64,
    /// Summary of the run.
    pub summary: Summary,
    /// Recorded columns.
    pub series: Series,
}

impl TimedRun {
    /// Returns a column that every run of the paper has.
    pub fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap_or_default()
    }

    /// Returns the number of instants, including the first.
    pub fn instants(&self) -> u64 {
        self.summary.steps + 1
    }

    /// Returns the Newton iterations per step.
    pub fn iterations_per_step(&self) -> f64 {
        self.summary.iterations as f64 / self.summary.steps as f64
    }

    /// Returns the mean tip deflection over all instants, mm.
    pub fn mean_deflection(&self) -> f64 {
        let tip = self.column("tip.y");
        1e3 * tip.iter().sum::<f64>() / tip.len() as f64
    }
}

/// Revolute pendulum under an absolute tolerance of the residual.
#[derive(Clone, Debug, Serialize)]
pub struct ToleranceRuns {
    /// Bound on |r|₂ in the units of each form.
    pub tolerance: f64,
    /// Iterations per step, dimensional form.
    pub dim: IterationCounts,
    /// Iterations per step, non-dimensional form.
    pub nondim: IterationCounts,
}

/// Newton iterations per step of a run.
#[derive(Clone, Debug, Default, Serialize)]
pub struct IterationCounts {
    /// Time of each step, s.
    pub t: Vec<f64>,
    /// Iterations of each step.
    pub iterations: Vec<u32>,
    /// Time of a step that did not converge within [`MAX_ITERATIONS`], if any.
    pub stalled_at: Option<f64>,
}

/// Maximum number of iterations of a step under an absolute tolerance.
pub const MAX_ITERATIONS: u32 = 1000;
/// Absolute tolerances of the residual, from large to below the rounding error.
pub const TOLERANCES: [f64; 9] = [1e-6, 1e-7, 3e-8, 2e-8, 1e-8, 9e-9, 8e-9, 6e-9, 5e-9];
/// Usual acceleration of gravity, in addition to the recovered one, m/s².
pub const STANDARD_GRAVITY: f64 = 9.81;
/// Steps of the table of condition numbers, s.
const STEPS: [f64; 5] = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6];

impl PaperRuns {
    /// Runs all models. `report` receives the name of the next part.
    ///
    /// # Errors
    /// If a run of the paper does not finish.
    pub fn run(repeats: usize, mut report: impl FnMut(&str)) -> Result<Self> {
        let mut compare_all = |case, name: &str| -> Result<Vec<CaseRuns>> {
            let compare = |&n: &u32| {
                report(&format!("{name}, {n} elements"));
                compare(case, n, repeats)
            };
            ELEMENTS.iter().map(compare).collect()
        };
        let cantilever = compare_all(PaperCase::Cantilever, "cantilever")?;
        let spherical = compare_all(PaperCase::Spherical, "spherical pendulum")?;
        report("revolute pendulum");
        let revolute = compare(PaperCase::Revolute, 1, repeats)?;
        let tolerances =
            TOLERANCES.iter().map(|&tolerance| ToleranceRuns::run(tolerance)).collect::<Result<_>>()?;
        report("cantilever with g = 9.81");
        let mean_with_standard_gravity =
            ELEMENTS.iter().map(|&n| standard_gravity(n)).collect::<Result<_>>()?;
        report("condition numbers");
        let rows = |young: f64| -> Result<Vec<ConditionRow>> {
            let pairs = [1, 10, 20].into_iter().flat_map(|n| STEPS.map(|h| (n, h)));
            pairs.map(|(n, h)| condition_row(young, n, h)).collect()
        };
        Ok(Self {
            machine: MachineInfo::current(),
            repeats,
            cantilever,
            spherical,
            revolute,
            tolerances,
            mean_with_standard_gravity,
            stiff: rows(YOUNG)?,
            soft: rows(YOUNG / 1000.0)?,
        })
    }
}

/// Runs one problem in three ways. The runs alternate: a drift of the machine affects all of them equally.
fn compare(case: PaperCase, n: u32, repeats: usize) -> Result<CaseRuns> {
    let scaled_step = STEP * time_unit(n);
    let models = [
        (EquationForm::Dimensional, STEP),
        (EquationForm::NonDimensional, scaled_step),
        (EquationForm::NonDimensional, STEP),
    ]
    .map(|(form, step)| case.model(form, n, step));
    let mut runs: [Vec<TimedRun>; 3] = [const { Vec::new() }; 3];
    for _ in 0..repeats.max(1) {
        for (model, runs) in models.iter().zip(&mut runs) {
            runs.push(run(model)?);
        }
    }
    let [dim, nondim, same_step] = runs.map(median);
    Ok(CaseRuns { n, dim: dim?, nondim: nondim?, same_step: same_step? })
}

/// Returns the last run with the median time.
fn median(mut runs: Vec<TimedRun>) -> Result<TimedRun> {
    let mut seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let median = seconds[seconds.len() / 2];
    let last = runs.pop().context("at least one run")?;
    Ok(TimedRun { seconds: median, ..last })
}

/// Runs a model to its end.
fn run(model: &Model) -> Result<TimedRun> {
    let mut series = Series::new();
    let clock = Instant::now();
    let summary = simulate(model, &mut series)?;
    let seconds = clock.elapsed().as_secs_f64();
    ensure!(summary.outcome.is_finished(), "a run of the paper ended early: {:?}", summary.outcome);
    let settings = model.analysis.dynamics().context("the problems of the paper are dynamic")?;
    let step = settings.step.fixed().context("the problems of the paper have a fixed step")?;
    Ok(TimedRun { step, seconds, summary, series })
}

impl ToleranceRuns {
    fn run(tolerance: f64) -> Result<Self> {
        let counts = |form, step| {
            let mut model = PaperCase::Revolute.model(form, 1, step);
            let settings = model.analysis.dynamics_mut().context("the problems of the paper are dynamic")?;
            settings.stop = Stop::Residual { tolerance };
            (settings.max_iterations, settings.max_halvings) = (MAX_ITERATIONS, 0);
            IterationCounts::run(&model)
        };
        let dim = counts(EquationForm::Dimensional, STEP)?;
        Ok(Self { tolerance, dim, nondim: counts(EquationForm::NonDimensional, STEP * time_unit(1))? })
    }
}

impl IterationCounts {
    fn run(model: &Model) -> Result<Self> {
        let mut series = Series::new();
        let summary = simulate(model, &mut series)?;
        let stalled_at = match summary.outcome {
            Outcome::Failed { time, .. } => Some(time),
            Outcome::Finished | Outcome::Stopped => None,
        };
        Ok(Self::of(&series, stalled_at))
    }

    /// Returns the counts of a recorded run.
    pub fn of(series: &Series, stalled_at: Option<f64>) -> Self {
        // No step leads to the first instant.
        let column = |name| series.column(name).unwrap_or_default().iter().skip(1).copied();
        Self {
            t: column("t").collect(),
            iterations: column("iterations").map(|x| x as u32).collect(),
            stalled_at,
        }
    }

    /// Returns the maximum number of iterations of a step.
    pub fn max(&self) -> u32 {
        self.iterations.iter().copied().max().unwrap_or(0)
    }
}

/// Returns the mean tip deflection of the cantilever with g = 9.81 in both forms, mm.
fn standard_gravity(n: u32) -> Result<[f64; 2]> {
    let mean = |form, step| -> Result<f64> {
        let mut model = PaperCase::Cantilever.model(form, n, step);
        model.gravity[1] = -STANDARD_GRAVITY;
        Ok(run(&model)?.mean_deflection())
    };
    let unit = (LENGTH * f64::from(n) / STANDARD_GRAVITY).sqrt();
    Ok([mean(EquationForm::Dimensional, STEP)?, mean(EquationForm::NonDimensional, STEP * unit)?])
}
