use serde::{Deserialize, Serialize};

use crate::equations::{State, Weights};
use crate::factor::Factor;

/// How accelerations and multipliers change from step to step, for the first guess of the next step.
///
/// A motion that the steps resolve goes on as it did: z = (v̇ₙ − v̇ₙ₋₁, λₙ − λₙ₋₁) is added to the state that keeps the
/// acceleration. One that they do not resolve, does not; hence the guess is made only if it would have been a good one
/// in the last step, in the norm Σ Kᵢᵢ zᵢ² of the iteration matrix, which is free of units.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Trend {
    /// z of the last step, and its size.
    change: Vec<f64>,
    h: Option<f64>,
    is_smooth: bool,
}

/// A guess is good if it leaves less than this part of the change, squared.
const GOOD: f64 = 0.25;

impl Trend {
    pub(crate) fn new(size: usize) -> Self {
        Self { change: vec![0.0; size], h: None, is_smooth: false }
    }

    /// Whether it is of so many unknowns, and finite.
    pub(crate) fn is_sound(&self, size: usize) -> bool {
        self.change.len() == size && self.change.iter().chain(&self.h).all(|x| x.is_finite())
    }

    /// Forgets what was before.
    pub(crate) fn restart(&mut self) {
        (self.h, self.is_smooth) = (None, false);
    }

    /// Moves a predicted state on by what a step h is likely to change.
    pub(crate) fn add_to(&self, s: &mut State, w: Weights, h: f64) {
        let Some(last) = self.h.filter(|_| self.is_smooth) else { return };
        let ratio = h / last;
        s.add(&self.change, Weights { q: ratio * w.q, v: ratio * w.v, a: ratio * w.a });
        // `add` moves multipliers by the whole change.
        let multipliers = &self.change[s.q.len()..];
        s.lambda.iter_mut().zip(multipliers).for_each(|(lambda, change)| *lambda += (ratio - 1.0) * change);
    }

    /// Takes note of a step h that led from one state to another.
    pub(crate) fn note(&mut self, before: &State, now: &State, h: f64, factor: &Factor) {
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
        self.is_smooth = self.h.is_some() && missed < GOOD * changed;
        self.h = Some(h);
    }
}
