//! Accelerations that alternate from step to step. They become a warning.

use ancf_solver::equations::State;
use serde::{Deserialize, Serialize};

use crate::errors::short;
use crate::model::Model;
use crate::units::Scales;

/// Number of consecutive alternations that is reported. Fewer may follow an impact.
const PERSISTENT: u32 = 6;
/// Largest cosine of the angle between successive changes of alternating accelerations.
const OPPOSITE: f64 = -0.8;
/// Displacement h² Δa of an alternation that is reported, relative to the length of the model. Those of rounding errors are 1e-15.
const SIGNIFICANT: f64 = 1e-9;

/// Monitor of alternating accelerations in a dynamic analysis.
///
/// Average acceleration does not damp an error of the accelerations: a₁ = −a₀ for motions with ω h ≫ 1, and for the multipliers of
/// index-3 equations. Positions remain accurate, but accelerations, reactions and section forces do not.
///
/// Source: Cardona & Géradin (1989).
#[derive(Debug)]
pub(crate) struct AlternationMonitor {
    /// Length of the model; `None` for schemes that damp alternations.
    length: Option<f64>,
    history: AlternationHistory,
}

/// Alternations so far.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct AlternationHistory {
    /// Time of the last state.
    t: f64,
    /// Last accelerations, and their last change.
    last: Vec<f64>,
    change: Vec<f64>,
    /// Number of consecutive alternations.
    count: u32,
    /// Time of the first report.
    found: Option<f64>,
}

impl AlternationMonitor {
    /// Monitor of a dynamic analysis of `coordinates` coordinates.
    pub(crate) fn new(model: &Model, coordinates: usize) -> Self {
        let scheme = model.analysis.dynamics().map(|settings| settings.scheme.numbers());
        let undamped = scheme.filter(|scheme| scheme.is_newmark() && scheme.gamma <= 0.5);
        let zeros = vec![0.0; if undamped.is_some() { coordinates } else { 0 }];
        let history =
            AlternationHistory { last: zeros.clone(), change: zeros, ..AlternationHistory::default() };
        Self { length: undamped.map(|_| model.length()), history }
    }

    /// Examines the state at the end of a step.
    pub(crate) fn examine(&mut self, s: &State) {
        let Some(length) = self.length else { return };
        let AlternationHistory { t, last, change, count, found } = &mut self.history;
        let h = s.t - *t;
        let [mut product, mut square, mut square_before, mut mean] = [0.0; 4];
        for ((a, last), change) in s.a.iter().zip(&mut *last).zip(&mut *change) {
            let step = a - *last;
            product += step * *change;
            square += step * step;
            square_before += *change * *change;
            mean += (a + *last) * (a + *last);
            (*last, *change) = (*a, step);
        }
        let is_opposite = product < OPPOSITE * (square * square_before).sqrt();
        let is_alternation = is_opposite && square > mean && h * h * square.sqrt() > SIGNIFICANT * length;
        *count = if is_alternation { *count + 1 } else { 0 };
        if *count == PERSISTENT && found.is_none() {
            *found = Some(s.t);
        }
        *t = s.t;
    }

    /// Warning of the first persistent alternation.
    pub(crate) fn warning(&self, scales: Scales) -> Option<String> {
        let t = short(self.history.found? * scales.time);
        Some(format!(
            "at t = {t} the accelerations alternate from step to step, since this scheme does not damp motions that the steps do not \
             resolve: accelerations, forces of joints and section forces are wrong, positions are not; use smaller steps, or a scheme with numerical \
             damping such as `scheme = {{ spectral_radius = 0.8 }}`"
        ))
    }

    pub(crate) fn history(&self) -> &AlternationHistory {
        &self.history
    }

    /// Restores the history. Returns false if it belongs to another model.
    pub(crate) fn restore(&mut self, history: &AlternationHistory) -> bool {
        let AlternationHistory { t, last, change, .. } = history;
        let own = self.history.last.len();
        let is_finite = t.is_finite() && last.iter().chain(change).all(|x| x.is_finite());
        let fits = last.len() == own && change.len() == own && is_finite;
        if fits {
            self.history.clone_from(history);
        }
        fits
    }
}
