//! Loads of a model as terms.

use ancf_mechanics::bodies::BodyTerms;
use ancf_solver::equations::Term;

use crate::loads::{Load, LoadBuilder};
use crate::model::{Model, Place, TimeMode};

impl Model {
    /// Terms of all loads, in the order of the model.
    pub(crate) fn load_terms(
        &self,
        bodies: &[(String, BodyTerms)],
        time_mode: TimeMode,
    ) -> Vec<Box<dyn Term>> {
        let attach = |place: &Place| self.attachment(bodies, place);
        let terms = |load: &Load| {
            let mut builder = LoadBuilder::new(self, bodies, &attach, time_mode);
            load.kind().build(&mut builder);
            builder.finish()
        };
        self.loads.iter().flat_map(terms).collect()
    }
}
