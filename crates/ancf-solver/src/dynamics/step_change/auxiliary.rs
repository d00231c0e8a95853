use serde::{Deserialize, Serialize};

use super::LARGEST_RATIO;

/// Auxiliary values of a scheme and the actual ones.
pub(crate) struct Auxiliary<'a> {
    pub(crate) auxiliary: &'a mut [f64],
    pub(crate) actual: &'a [f64],
}

/// Reference of the auxiliary accelerations a of a scheme, or of its auxiliary damping forces.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct AuxiliaryReference {
    /// Value of that step. In the shorter steps it is a mean value over the duration H.
    mean: Vec<f64>,
    /// Difference a − v̇ from the true value, which is proportional to the step.
    lead: Vec<f64>,
}

impl Auxiliary<'_> {
    /// Scales a − v̇ with the step.
    pub(super) fn scale(&mut self, growth: f64) {
        self.auxiliary.iter_mut().zip(self.actual).for_each(|(a, v)| *a = v + growth * (*a - v));
    }

    /// Writes the change y and sets the auxiliary values to those to which it is added when it is filtered.
    pub(super) fn start(&mut self, longer: Option<(&AuxiliaryReference, f64)>, growth: f64, y: &mut [f64]) {
        y.fill(0.0);
        for (i, (auxiliary, actual)) in self.auxiliary.iter_mut().zip(self.actual).enumerate() {
            y[i] = match longer {
                Some((longer, ratio)) => longer.start(i, auxiliary, *actual, ratio),
                None => (growth.min(LARGEST_RATIO) - 1.0) * (*auxiliary - actual),
            };
        }
    }

    /// Adds a change.
    pub(super) fn add(&mut self, x: &[f64]) {
        self.auxiliary.iter_mut().zip(x).for_each(|(a, x)| *a += x);
    }
}

impl AuxiliaryReference {
    pub(super) fn new(own: &Auxiliary<'_>) -> Self {
        let lead = own.auxiliary.iter().zip(own.actual).map(|(a, v)| a - v).collect();
        Self { mean: own.auxiliary.to_vec(), lead }
    }

    /// Includes a step in the mean value with the given share.
    pub(super) fn record(&mut self, share: f64, auxiliary: &[f64]) {
        self.mean.iter_mut().zip(auxiliary).for_each(|(mean, a)| *mean += share * (a - *mean));
    }

    /// Sets an auxiliary value to the mean, and returns its change v̇ + (h/H) (a − v̇) − ā.
    fn start(&self, i: usize, auxiliary: &mut f64, actual: f64, ratio: f64) -> f64 {
        *auxiliary = self.mean[i];
        actual + ratio * self.lead[i] - *auxiliary
    }

    /// Returns the mean value and the difference.
    pub(super) fn vectors(&self) -> [&Vec<f64>; 2] {
        [&self.mean, &self.lead]
    }
}
