//! Rows of single steps and of step control, measured in this process.

use std::io;
use std::ops::ControlFlow;
use std::time::Instant;

use ancf::solver::equations::State;
use ancf::{Model, Observer, Simulation, Stepper};

use super::row::{MeasuredValue, RowSpec, RowUnit};
use crate::Result;
use crate::measure::{clock, median};
use crate::models::{arm, swing};

type Measure = fn() -> Result<MeasuredValue>;

/// All rows.
pub(super) const ROWS: [(RowSpec, Measure); 3] = [
    (RowSpec::new("step of an arm of 20 elements, median", RowUnit::Microseconds, 26.0), || latency(0.5)),
    (RowSpec::new("step of an arm of 20 elements, p99.9", RowUnit::Microseconds, 100.0), || latency(0.999)),
    (RowSpec::new("adaptive against fixed steps, equal error", RowUnit::Factor, 1.3), adaptive_factor),
];

/// Number of steps of the arm and their size.
const ARM: (u32, f64) = (20_000, 5e-4);

/// Measures the wall-clock time of each step of the arm and returns a quantile.
fn latency(quantile: f64) -> Result<MeasuredValue> {
    let (count, step) = ARM;
    let model = Model::parse(&arm(count, step)).map_err(|error| error.to_string())?;
    let mut stepper = Stepper::new(&model).map_err(|error| error.to_string())?;
    let mut times = Vec::with_capacity(count as usize);
    for _ in 0..count {
        let start = Instant::now();
        stepper.step(step).map_err(|error| error.to_string())?;
        times.push(1e6 * start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let place = (quantile * (times.len() - 1) as f64) as usize;
    Ok(MeasuredValue::new(times[place], format!("{count} steps of {step} s, wall-clock time")))
}

/// Tolerance of the run with error control.
const TOLERANCE: &str = "{ tolerance = 1e-4 }";
/// Fixed steps in seconds, and the one of the reference.
const FIXED: [f64; 5] = [2e-3, 1e-3, 5e-4, 2.5e-4, 1.25e-4];
const REFERENCE: f64 = 1e-5;
/// Number of repeated measurements.
const REPEATED: usize = 3;

/// Returns the time with error control, divided by that of fixed steps with the same largest error of the position of the tip.
fn adaptive_factor() -> Result<MeasuredValue> {
    let reference = motion(&swing(&REFERENCE.to_string()))?.0;
    let cost = |step: &str| -> Result<[f64; 2]> {
        let runs: Vec<_> = (0..REPEATED).map(|_| motion(&swing(step))).collect::<Result<_>>()?;
        let error = distance(&runs[0].0, &reference);
        Ok([error, median(runs.into_iter().map(|(_, time)| time).collect())].map(f64::ln))
    };
    let fixed = FIXED.iter().map(|step| cost(&step.to_string())).collect::<Result<Vec<_>>>()?;
    let [error, time] = cost(TOLERANCE)?;
    // Between the neighbours in the error, or beyond the smallest and largest of them.
    let first = fixed.windows(2).rposition(|pair| pair[0][0] >= error).unwrap_or(0);
    let ([e0, t0], [e1, t1]) = (fixed[first], fixed[first + 1]);
    let equal = t0 + (t1 - t0) * (error - e0) / (e1 - e0);
    Ok(MeasuredValue::new((time - equal).exp(), format!("error {:.1e} m of the tip", error.exp())))
}

/// Largest distance of two motions of a point.
fn distance(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let between = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
    a.iter().zip(b).map(between).fold(0.0, f64::max)
}

/// Runs a model and returns the positions of the probe `tip`, with the CPU time in seconds.
fn motion(text: &str) -> Result<(Vec<[f64; 3]>, f64)> {
    let model = Model::parse(text).map_err(|error| error.to_string())?;
    let simulation = Simulation::new(&model).map_err(|error| error.to_string())?;
    let (start, mut path) = (clock::own(), TipPath::default());
    let _ = simulation.run(&mut path).map_err(|error| error.to_string())?;
    Ok((path.positions, clock::own() - start))
}

/// Positions of the probe `tip` of each row.
#[derive(Default)]
struct TipPath {
    columns: [usize; 3],
    positions: Vec<[f64; 3]>,
}

impl Observer for TipPath {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        for (place, name) in self.columns.iter_mut().zip(["tip.x", "tip.y", "tip.z"]) {
            *place = columns
                .iter()
                .position(|column| column == name)
                .ok_or_else(|| io::Error::other(format!("no column {name}")))?;
        }
        Ok(())
    }

    fn record(&mut self, row: &[f64], _: &State) -> io::Result<ControlFlow<()>> {
        self.positions.push(self.columns.map(|k| row[k]));
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}
