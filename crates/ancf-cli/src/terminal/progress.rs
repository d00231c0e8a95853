//! Progress bars of runs and studies.

use std::io;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use ancf::Model;
use ancf::errors::short;
use ancf::model::Origin;
use ancf::record::Sink;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::output_mode::is_quiet;

/// Progress bar of a motion: time, step size, Newton iterations of the last step, steps per second, remaining time.
pub struct RunProgress {
    bar: ProgressBar,
    /// Time at the start.
    start: f64,
    duration: f64,
    /// True if each row is a step.
    has_steps: bool,
    iterations: Option<usize>,
    /// Time of the last row.
    time: f64,
    /// Number of rows.
    rows: u64,
    begun: Instant,
    shown: Instant,
}

/// Creates a bar of `count` cases. It is hidden in quiet mode and without a terminal.
pub fn case_bar(count: u64) -> ProgressBar {
    if is_quiet() {
        return ProgressBar::hidden();
    }
    bar(count, "{bar:30} {pos}/{len} cases  {msg}  [{elapsed_precise}, {eta} left]")
}

/// Creates a spinner with a message. It is hidden without a terminal.
#[cfg(feature = "figures")]
pub fn spinner() -> ProgressBar {
    let style = ProgressStyle::with_template("{spinner} {msg}  [{elapsed_precise}]");
    let spinner =
        ProgressBar::new_spinner().with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    spinner.enable_steady_tick(TICK);
    spinner
}

fn bar(length: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar =
        ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr_with_hz(10)).with_style(style);
    bar.enable_steady_tick(TICK);
    bar
}

/// Interval between two redraws of a spinner or a clock.
const TICK: Duration = Duration::from_millis(200);
/// Interval between two messages of a run.
const REDRAW: Duration = Duration::from_millis(100);
/// Resolution of the bar.
const TICKS: u64 = 1000;

impl RunProgress {
    /// Creates a bar of a motion. It is hidden without a terminal.
    pub fn of(model: &Model) -> Self {
        let Some(settings) = model.analysis.dynamics().filter(|_| !is_quiet()) else {
            return Self::with(ProgressBar::hidden(), [0.0, 1.0], false);
        };
        let bar = bar(TICKS, "{bar:30} {percent:>3} %  {msg}  [{elapsed_precise}, {eta} left]");
        if model.initial.from == Origin::Equilibrium {
            bar.set_message("equilibrium at the start");
        }
        Self::with(bar, [model.initial.start_time, settings.duration], model.output.interval.is_none())
    }

    fn with(bar: ProgressBar, [start, duration]: [f64; 2], has_steps: bool) -> Self {
        let now = Instant::now();
        Self {
            bar,
            start,
            duration,
            has_steps,
            iterations: None,
            time: start,
            rows: 0,
            begun: now,
            shown: now,
        }
    }

    /// Message of a row at time `t`.
    fn message(&self, t: f64, iterations: f64) -> String {
        if !self.has_steps {
            return format!("t = {}, {iterations} iterations", short(t));
        }
        let rate = self.rows as f64 / self.begun.elapsed().as_secs_f64();
        let step = short(t - self.time);
        format!("t = {}, step {step}, {iterations} iterations, {rate:.0} steps/s", short(t))
    }
}

impl Sink for RunProgress {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.iterations = columns.iter().position(|name| name == "iterations");
        self.begun = Instant::now();
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        if self.bar.is_hidden() {
            return Ok(ControlFlow::Continue(()));
        }
        let t = row.first().copied().unwrap_or(0.0);
        self.rows += 1;
        if self.shown.elapsed() >= REDRAW {
            let iterations = self.iterations.and_then(|column| row.get(column)).copied().unwrap_or(0.0);
            self.bar.set_message(self.message(t, iterations));
            self.bar.set_position(((t - self.start) / self.duration * TICKS as f64) as u64);
            self.shown = Instant::now();
        }
        self.time = t;
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        self.bar.finish_and_clear();
        Ok(())
    }
}
