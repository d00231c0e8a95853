use crate::model::Model;
use crate::units::{ScaleChoice, Scaled, Scales};

impl Model {
    /// Converts the model to other units. The result is a model in its own units, without a choice of scales.
    ///
    /// Tolerances of absolute convergence criteria are not converted, because they refer to the units of the solver.
    #[must_use]
    pub fn scaled(&self, scales: &Scales) -> Self {
        let couplings = self.scaled_couplings(scales);
        let converted = <Self as Scaled>::scaled(self.clone(), scales);
        Self { units: None, couplings, scales: ScaleChoice::None, ..converted }
    }
}
