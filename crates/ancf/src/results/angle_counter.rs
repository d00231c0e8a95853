use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ancf_solver::equations::State;
use serde::{Deserialize, Serialize};

use crate::assembly::Assembly;
use crate::joints::RecordedCoordinate;

/// Counter of the turns of recorded angles that are not coordinates of the equations.
///
/// A state determines such an angle up to whole turns. Each accepted step selects the turn nearest to the prediction from the
/// rates at both ends of the step, θₙ + h (θ̇ₙ + θ̇ₙ₊₁)/2. The selection does not depend on the output.
#[derive(Debug)]
pub(crate) struct AngleCounter {
    /// Angles, with the names of their joints.
    angles: Vec<(String, RecordedCoordinate)>,
    history: AngleHistory,
}

/// Angles of the last step on which later angles depend.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct AngleHistory {
    /// Time, load factor or arc length; `None` before the start.
    at: Option<f64>,
    /// Value and rate of each angle.
    angles: Vec<[f64; 2]>,
    /// First step with an ambiguous number of turns: its end, and the index of the angle.
    ambiguous: Option<(f64, usize)>,
}

/// Origin of the rates of angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AngleRates {
    /// Velocities of the state: derivatives with respect to time or to the load factor.
    Velocities,
    /// Differences of the last step.
    Differences,
}

/// Recorded angles that a state determines up to whole turns, with the names of their joints.
fn wrapping(assembly: &Assembly) -> impl Iterator<Item = (&str, &RecordedCoordinate)> {
    assembly.joint_coordinates().filter(|(_, coordinate)| coordinate.wraps())
}

/// Columns of the angles whose turns are counted.
pub(crate) fn counted_angles(assembly: &Assembly) -> Vec<String> {
    wrapping(assembly).map(|(joint, angle)| angle.column(joint)).collect()
}

impl AngleCounter {
    pub(crate) fn new(assembly: &Assembly) -> Self {
        let angles: Vec<_> =
            wrapping(assembly).map(|(joint, angle)| (joint.to_owned(), angle.clone())).collect();
        let history = AngleHistory { angles: vec![[0.0; 2]; angles.len()], ..AngleHistory::default() };
        Self { angles, history }
    }

    /// Sets the angles before the first state, by their columns.
    pub(crate) fn start(&mut self, given: &[(String, f64)]) {
        for ((joint, angle), last) in self.angles.iter().zip(&mut self.history.angles) {
            let column = angle.column(joint);
            if let Some((_, value)) = given.iter().find(|(name, _)| *name == column) {
                *last = [*value, 0.0];
            }
        }
    }

    /// True if there are no such angles.
    pub(crate) fn is_empty(&self) -> bool {
        self.angles.is_empty()
    }

    /// Counts the turns up to a state at the time, load factor or arc length `at`.
    pub(crate) fn count(&mut self, at: f64, s: &State, rates: AngleRates) {
        let step = self.history.at.map(|before| at - before);
        for (i, ((_, angle), last)) in self.angles.iter().zip(&mut self.history.angles).enumerate() {
            let [wrapped, rate_now] = angle.at(s);
            let ([before, rate_before], h) = (*last, step.unwrap_or(0.0));
            let turned = match rates {
                AngleRates::Velocities => [h * rate_before, h * rate_now],
                AngleRates::Differences => [h * rate_before; 2],
            };
            let predicted = before + 0.5 * (turned[0] + turned[1]);
            let value = wrapped + TAU * ((predicted - wrapped) / TAU).round();
            let rate = match rates {
                AngleRates::Velocities => rate_now,
                AngleRates::Differences if h > 0.0 => (value - before) / h,
                AngleRates::Differences => rate_before,
            };
            let is_far = |turned: &f64| (before + turned - value).abs() > PI;
            let is_ambiguous = (predicted - value).abs() > FRAC_PI_2 || turned.iter().any(is_far);
            if is_ambiguous && step.is_some() {
                self.history.ambiguous.get_or_insert((at, i));
            }
            *last = [value, rate];
        }
        self.history.at = Some(at);
    }

    /// Continues from the last angles with another variable than that of the steps so far.
    pub(crate) fn restart(&mut self) {
        self.history.at = None;
    }

    /// Values of the angles, in the order of the joint coordinates.
    pub(crate) fn values(&self) -> impl Iterator<Item = f64> {
        self.history.angles.iter().map(|[value, _]| *value)
    }

    /// First step with an ambiguous number of turns: its end, and the name of the joint.
    pub(crate) fn ambiguous(&self) -> Option<(f64, &str)> {
        let (at, i) = self.history.ambiguous?;
        self.angles.get(i).map(|(joint, _)| (at, joint.as_str()))
    }

    pub(crate) fn history(&self) -> &AngleHistory {
        &self.history
    }

    /// Restores the angles of the last step. Returns false if they belong to other joints.
    pub(crate) fn restore(&mut self, history: &AngleHistory) -> bool {
        let numbers = history.angles.iter().flatten().chain(&history.at);
        let is_index = history.ambiguous.is_none_or(|(_, i)| i < self.angles.len());
        let fits = history.angles.len() == self.angles.len();
        let fits = fits && is_index && numbers.into_iter().all(|x| x.is_finite());
        if fits {
            self.history.clone_from(history);
        }
        fits
    }
}
