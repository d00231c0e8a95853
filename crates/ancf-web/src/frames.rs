//! States of a run for its scene.

use ancf::solver::equations::State;
use ancf_report::Snapshot;

/// States of a run, evenly spaced by rows. Their number stays between half the limit and the limit.
#[derive(Debug)]
pub(crate) struct Frames {
    frames: Vec<Snapshot>,
    limit: usize,
    /// Rows from one frame to the next.
    every: usize,
    rows: usize,
    /// State of the last row, if it is not a frame.
    last: Option<Snapshot>,
}

impl Frames {
    /// Creates an empty list of at most `limit` frames.
    pub(crate) fn new(limit: usize) -> Self {
        Self { frames: Vec::new(), limit: limit.max(2), every: 1, rows: 0, last: None }
    }

    /// Adds the state of the next row.
    pub(crate) fn push(&mut self, value: f64, state: &State) {
        if self.rows.is_multiple_of(self.every) && self.frames.len() == self.limit {
            // Every second frame remains.
            let mut number = 0;
            self.frames.retain(|_| {
                number += 1;
                number % 2 == 1
            });
            self.every *= 2;
        }
        let frame = Snapshot { value, state: state.clone() };
        if self.rows.is_multiple_of(self.every) {
            self.frames.push(frame);
            self.last = None;
        } else {
            self.last = Some(frame);
        }
        self.rows += 1;
    }

    /// Frames so far, and the state of the last row.
    pub(crate) fn all(&self) -> Vec<Snapshot> {
        self.frames.iter().chain(&self.last).cloned().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_evenly_spaced_and_include_the_ends() {
        let mut frames = Frames::new(8);
        for row in 0..1000 {
            frames.push(f64::from(row), &State::rest(0, 0));
        }
        let values: Vec<f64> = frames.all().iter().map(|frame| frame.value).collect();
        assert_eq!(values[0], 0.0);
        assert_eq!(values.last(), Some(&999.0));
        assert!((4..=9).contains(&values.len()), "{}", values.len());
        let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let even = &steps[..steps.len() - 1];
        assert!(even.iter().all(|step| *step == even[0]), "{steps:?}");
    }
}
