//! What the user sees while a run goes on.

use std::io;
use std::ops::ControlFlow;
use std::time::Duration;

use ancf::record::Sink;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar with the time reached and the Newton iterations of the last step.
pub struct Progress {
    bar: ProgressBar,
    duration: f64,
    iterations: Option<usize>,
}

/// A bar that is full after so many cases; it appears on terminals only.
pub fn cases(count: u64) -> ProgressBar {
    bar(count, "{bar:30} {pos}/{len} cases  {msg}  [{elapsed_precise}, {eta} left]")
}

/// No bar.
pub fn no_bar() -> ProgressBar {
    ProgressBar::hidden()
}

fn bar(length: u64, template: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar =
        ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr_with_hz(10)).with_style(style);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

/// Resolution of the bar.
const TICKS: u64 = 1000;

impl Progress {
    /// A bar that is full at time `duration`; it appears on terminals only.
    pub fn until(duration: f64) -> Self {
        let bar = bar(TICKS, "{bar:30} {percent:>3} %  {msg}  [{elapsed_precise}]");
        Self { bar, duration, iterations: None }
    }

    /// No bar.
    pub fn hidden() -> Self {
        Self { bar: ProgressBar::hidden(), duration: 1.0, iterations: None }
    }
}

impl Sink for Progress {
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
