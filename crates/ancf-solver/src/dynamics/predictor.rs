use serde::{Deserialize, Serialize};

use crate::equations::{EquationsOfMotion, State, Weights};
use crate::newton::Newton;

/// Predictor of the state at the end of a step.
///
/// For a resolved motion, the change z = (v̇ₙ − v̇ₙ₋₁, λₙ − λₙ₋₁) of the last step is added to the state with constant acceleration. For
/// an unresolved motion this fails. It is therefore applied only if it would have been accurate in the last step. Accuracy is
/// measured in the norm Σ Kᵢᵢ zᵢ² of the iteration matrix, which is independent of units.
///
/// In an unresolved motion constant accelerations also fail: after a sudden load or in a fine mesh, accelerations of stiff vibrations are
/// large and change their signs. Extrapolated positions then have far more strain energy than the motion has energy, and Newton's
/// method diverges. The next step starts from the [`Guess`] that was the best one in the last step, in the energy zᵀ K z of its
/// error. A guess with a small error is kept. The first step starts from constant accelerations if these add less strain energy than they
/// have kinetic energy, and from constant velocities otherwise.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Predictor {
    /// Change z and size h of the last step.
    change: Vec<f64>,
    h: Option<f64>,
    is_smooth: bool,
    /// Best guess in the last step.
    guess: Option<Guess>,
}

/// Guess of the positions at the end of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Guess {
    /// Constant accelerations.
    Accelerations,
    /// Constant velocities.
    Velocities,
    /// Positions at the start of the step.
    Positions,
}

/// Largest squared prediction error, relative to the squared change, for which the predictor is used.
const PREDICTION_TOLERANCE: f64 = 0.25;
/// Largest energy of the error of another guess, relative to that of constant accelerations, for which it replaces them. Old tangents
/// reduce errors in stiff directions faster than those of the motion, so that a small advantage is none.
const ADVANTAGE: f64 = 0.05;
/// Energy of the error of a guess, relative to that of the motion, up to which no other one is considered.
const GOOD: f64 = 1e-2;

impl Predictor {
    pub(crate) fn new(size: usize) -> Self {
        Self { change: vec![0.0; size], h: None, is_smooth: false, guess: None }
    }

    /// Returns true if the predictor has the given number of unknowns and is finite.
    pub(crate) fn is_valid(&self, size: usize) -> bool {
        self.change.len() == size && self.change.iter().chain(&self.h).all(|x| x.is_finite())
    }

    /// Clears the history.
    pub(crate) fn restart(&mut self) {
        (self.h, self.is_smooth, self.guess) = (None, false, None);
    }

    /// Adds the predicted change of a step h from a state to its end `s` with constant accelerations.
    ///
    /// `is_extrapolated` permits the changes of the last step, also of the multipliers.
    pub(crate) fn add_to(
        &self,
        eom: &dyn EquationsOfMotion,
        (from, s): (&State, &mut State),
        (h, w): (f64, Weights),
        is_extrapolated: bool,
    ) {
        let Some(last) = self.h.filter(|_| self.is_smooth) else {
            let guess = self.guess.unwrap_or_else(|| Guess::first(eom, from, s));
            return guess.replace_accelerations(s, from, (h, w));
        };
        if !is_extrapolated {
            return;
        }
        let ratio = h / last;
        s.add(&self.change, Weights { q: ratio * w.q, v: ratio * w.v, a: ratio * w.a });
        // `add` applies the full change to the multipliers.
        let multipliers = &self.change[s.q.len()..];
        s.lambda.iter_mut().zip(multipliers).for_each(|(lambda, change)| *lambda += (ratio - 1.0) * change);
    }

    /// Records the change of an accepted step h between two states.
    pub(crate) fn record(&mut self, [before, now]: [&State; 2], (h, w): (f64, Weights), newton: &mut Newton) {
        let ratio = self.h.map_or(0.0, |last| h / last);
        let (mut changed, mut missed) = (0.0, 0.0);
        let (of_coordinates, of_multipliers) = self.change.split_at_mut(now.q.len());
        for (i, change) in of_coordinates.iter_mut().enumerate() {
            let now = now.a[i] - before.a[i];
            let by = 1.0 / newton.tangent.factor.scale(i);
            changed += (by * now).powi(2);
            missed += (by * (now - ratio * *change)).powi(2);
            *change = now;
        }
        let pairs = now.lambda.iter().zip(&before.lambda);
        of_multipliers.iter_mut().zip(pairs).for_each(|(change, (now, before))| *change = now - before);
        self.is_smooth = self.h.is_some() && missed < PREDICTION_TOLERANCE * changed;
        self.h = Some(h);
        let is_poor = self.guess.is_none() || newton.start_error() > GOOD;
        if !self.is_smooth && is_poor {
            self.guess = Some(Guess::best([before, now], (h, w), newton));
        }
    }
}

impl Guess {
    /// Returns the guess of a first step, whose end with constant accelerations is `to`.
    fn first(eom: &dyn EquationsOfMotion, from: &State, to: &State) -> Self {
        let (before, after) = (eom.energy(from), eom.energy(to));
        if after.strain - before.strain <= after.kinetic { Self::Accelerations } else { Self::Velocities }
    }

    /// Replaces constant accelerations in the end `s` of a step from a state.
    fn replace_accelerations(self, s: &mut State, from: &State, (h, w): (f64, Weights)) {
        let time = match self {
            Self::Accelerations => return,
            Self::Velocities => h,
            Self::Positions => 0.0,
        };
        for i in 0..s.q.len() {
            let z = (from.q[i] + time * from.v[i] - s.q[i]) / w.q;
            s.q[i] += w.q * z;
            s.v[i] += w.v * z;
            s.a[i] += w.a * z;
        }
    }

    /// Returns the guess whose error had the smallest energy in a step.
    fn best([before, now]: [&State; 2], (h, w): (f64, Weights), newton: &mut Newton) -> Self {
        let mut energy = |guess| match guess {
            Self::Accelerations => newton.energy_of(now.q.len(), |i| now.a[i] - before.a[i]),
            Self::Velocities => {
                newton.energy_of(now.q.len(), |i| (now.q[i] - before.q[i] - h * before.v[i]) / w.q)
            }
            Self::Positions => newton.energy_of(now.q.len(), |i| (now.q[i] - before.q[i]) / w.q),
        };
        let [constant, unchanged, uniform] =
            [Self::Accelerations, Self::Positions, Self::Velocities].map(|guess| energy(guess).abs());
        if unchanged.min(uniform) > ADVANTAGE * constant {
            Self::Accelerations
        } else if uniform < unchanged {
            Self::Velocities
        } else {
            Self::Positions
        }
    }
}
