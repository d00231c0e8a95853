//! Storage of states.

use std::collections::TryReserveError;

use ancf::solver::equations::State;

use super::keep::Keep;

/// States in contiguous memory: time and load factor of each, and its coordinates or all its numbers.
#[derive(Clone, Debug)]
pub(crate) struct Frames {
    pub(crate) keep: Keep,
    /// Time and load factor of each state.
    pub(crate) at: Vec<[f64; 2]>,
    /// Coordinates of each state, followed by velocities, accelerations and multipliers of complete states.
    pub(crate) numbers: Vec<f64>,
}

impl Frames {
    pub(crate) const fn new(keep: Keep) -> Self {
        Self { keep, at: Vec::new(), numbers: Vec::new() }
    }

    /// Number of states.
    pub(crate) fn len(&self) -> usize {
        self.at.len()
    }

    /// Appends a state.
    ///
    /// # Errors
    /// If it does not fit into memory.
    pub(crate) fn push(&mut self, s: &State) -> Result<(), TryReserveError> {
        let kept: &[&[f64]] = match self.keep {
            Keep::All => &[&s.q, &s.v, &s.a, &s.lambda],
            Keep::Positions => &[&s.q],
            Keep::Nothing => return Ok(()),
        };
        self.at.try_reserve(1)?;
        self.numbers.try_reserve(kept.iter().map(|numbers| numbers.len()).sum())?;
        self.at.push([s.t, s.load]);
        kept.iter().for_each(|numbers| self.numbers.extend_from_slice(numbers));
        Ok(())
    }

    /// Removes the last state.
    pub(crate) fn pop(&mut self) {
        if let Some(width) = self.numbers.len().checked_div(self.at.len()) {
            self.numbers.truncate(self.numbers.len() - width);
            self.at.pop();
        }
    }

    /// Returns the count of numbers of a state.
    pub(crate) fn width(keep: Keep, s: &State) -> usize {
        match keep {
            Keep::All => 3 * s.q.len() + s.lambda.len(),
            Keep::Positions => s.q.len(),
            Keep::Nothing => 0,
        }
    }

    /// Calls `see` with the states of the given numbers until it returns false. `s` is a state of the same model.
    pub(crate) fn each(&self, frames: &[usize], mut s: State, mut see: impl FnMut(&State) -> bool) {
        let width = Self::width(self.keep, &s);
        for &frame in frames {
            let mut numbers = &self.numbers[frame * width..][..width];
            [s.t, s.load] = self.at[frame];
            for part in [&mut s.q, &mut s.v, &mut s.a, &mut s.lambda] {
                let Some((own, rest)) = numbers.split_at_checked(part.len()) else { break };
                part.copy_from_slice(own);
                numbers = rest;
            }
            if !see(&s) {
                return;
            }
        }
    }
}
