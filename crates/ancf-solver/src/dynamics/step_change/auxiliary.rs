use serde::{Deserialize, Serialize};

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

    /// Writes the change y before its filter. A growth from a reference sets the auxiliary values to its mean values, to which the change
    /// is then added.
    ///
    /// `ratio` is the size of the step relative to that of a recent reference, or else to the last step.
    pub(super) fn start(
        &mut self,
        longer: Option<&AuxiliaryReference>,
        (ratio, is_recent): (f64, bool),
        y: &mut [f64],
    ) {
        y.fill(0.0);
        for (i, (auxiliary, actual)) in self.auxiliary.iter_mut().zip(self.actual).enumerate() {
            let own = *auxiliary - actual;
            match longer {
                Some(longer) => {
                    *auxiliary = longer.mean[i];
                    let lead = if is_recent { longer.lead[i] } else { own };
                    y[i] = actual + ratio * lead - *auxiliary;
                }
                None => y[i] = (ratio - 1.0) * own,
            }
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

    /// Returns the mean value and the difference.
    pub(super) fn vectors(&self) -> [&Vec<f64>; 2] {
        [&self.mean, &self.lead]
    }
}
