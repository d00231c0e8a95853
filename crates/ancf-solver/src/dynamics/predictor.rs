use serde::{Deserialize, Serialize};

use crate::equations::{State, Weights};
use crate::factor::Factor;

/// Predictor of accelerations and multipliers for the next step, extrapolated from the last step.
///
/// For a resolved motion, the change z = (v̇ₙ − v̇ₙ₋₁, λₙ − λₙ₋₁) is added to the state with constant acceleration. For
/// an unresolved motion the extrapolation fails. It is therefore applied only if it would have been accurate in the
/// last step. Accuracy is measured in the norm Σ Kᵢᵢ zᵢ² of the iteration matrix, which is independent of units.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Predictor {
    /// Change z and size h of the last step.
    change: Vec<f64>,
    h: Option<f64>,
    is_smooth: bool,
}

/// Largest squared prediction error, relative to the squared change, for which the predictor is used.
const PREDICTION_TOLERANCE: f64 = 0.25;

impl Predictor {
    pub(crate) fn new(size: usize) -> Self {
        Self { change: vec![0.0; size], h: None, is_smooth: false }
    }

    /// Returns true if the predictor has the given number of unknowns and is finite.
    pub(crate) fn is_valid(&self, size: usize) -> bool {
        self.change.len() == size && self.change.iter().chain(&self.h).all(|x| x.is_finite())
    }

    /// Clears the history.
    pub(crate) fn restart(&mut self) {
        (self.h, self.is_smooth) = (None, false);
    }

    /// Adds the predicted change of a step h to a state.
    pub(crate) fn add_to(&self, s: &mut State, w: Weights, h: f64) {
        let Some(last) = self.h.filter(|_| self.is_smooth) else { return };
        let ratio = h / last;
        s.add(&self.change, Weights { q: ratio * w.q, v: ratio * w.v, a: ratio * w.a });
        // `add` applies the full change to the multipliers.
        let multipliers = &self.change[s.q.len()..];
        s.lambda.iter_mut().zip(multipliers).for_each(|(lambda, change)| *lambda += (ratio - 1.0) * change);
    }

    /// Records the change of an accepted step h between two states.
    pub(crate) fn record(&mut self, before: &State, now: &State, h: f64, factor: &Factor) {
        let ratio = self.h.map_or(0.0, |last| h / last);
        let (mut changed, mut missed) = (0.0, 0.0);
        let (of_coordinates, of_multipliers) = self.change.split_at_mut(now.q.len());
        for (i, change) in of_coordinates.iter_mut().enumerate() {
            let now = now.a[i] - before.a[i];
            let by = 1.0 / factor.scale(i);
            changed += (by * now).powi(2);
            missed += (by * (now - ratio * *change)).powi(2);
            *change = now;
        }
        let pairs = now.lambda.iter().zip(&before.lambda);
        of_multipliers.iter_mut().zip(pairs).for_each(|(change, (now, before))| *change = now - before);
        self.is_smooth = self.h.is_some() && missed < PREDICTION_TOLERANCE * changed;
        self.h = Some(h);
    }
}
