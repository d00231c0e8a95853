//! Progress bars of runs and studies.

use std::io;
use std::ops::ControlFlow;
use std::time::Duration;

use ancf::record::Sink;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::output_mode::is_quiet;

/// Progress bar of a motion: time and Newton iterations of the last step.
pub struct RunProgress {
    bar: ProgressBar,
    duration: f64,
    iterations: Option<usize>,
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
/// Resolution of the bar.
const TICKS: u64 = 1000;

impl RunProgress {
    /// Creates a bar up to time `duration`. It is hidden without a terminal.
    pub fn until(duration: f64) -> Self {
        let bar = bar(TICKS, "{bar:30} {percent:>3} %  {msg}  [{elapsed_precise}]");
        Self { bar, duration, iterations: None }
    }

    /// Creates a hidden bar.
    pub fn hidden() -> Self {
        Self { bar: ProgressBar::hidden(), duration: 1.0, iterations: None }
    }
}

impl Sink for RunProgress {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.iterations = columns.iter().position(|name| name == "iterations");
        Ok(())
    }

    fn record(&mut self, row: &[f64]) -> io::Result<ControlFlow<()>> {
        if self.bar.is_hidden() {
            return Ok(ControlFlow::Continue(()));
        }
        let t = row.first().copied().unwrap_or(0.0);
        let position = (t / self.duration * TICKS as f64) as u64;
        if position != self.bar.position() {
            let iterations = self.iterations.and_then(|column| row.get(column)).copied().unwrap_or(0.0);
            self.bar.set_message(format!("t = {t:.4}, {iterations} iterations"));
            self.bar.set_position(position);
        }
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        self.bar.finish_and_clear();
        Ok(())
    }
}
