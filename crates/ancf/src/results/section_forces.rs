use std::sync::Arc;

use ancf_mechanics::bodies::CarriedFrame;
use ancf_mechanics::constraints::Wrench;
use ancf_solver::equations::{State, Term, active_terms};

use crate::assembly::Assembly;

impl Assembly {
    /// Terms of the active contacts in a state.
    pub fn contact_terms(&self, s: &State) -> Vec<Arc<dyn Term>> {
        active_terms(self.system.searches(), s)
    }

    /// Section forces N, Qy, Qz and T, My, Mz of a flexible body at an arc length, in the section frame.
    ///
    /// `contacts` are the [`contact_terms`](Self::contact_terms) of the state. `carried` has the frame of an earlier call
    /// for the same body and state.
    pub fn section_forces(
        &self,
        body: usize,
        s: f64,
        state: &State,
        contacts: &[Arc<dyn Term>],
        carried: &mut CarriedFrame,
    ) -> Option<Wrench> {
        let mesh = self.body_of(body).mesh()?;
        let loads = self.loads_within(body, mesh.element_of(s), contacts);
        let frame = mesh.carried_frame(state, s, carried);
        Some(mesh.resultants(state, s, &loads).seen_from(&frame))
    }

    /// Loads, reactions and `contacts` between the nodes of an element of a flexible body.
    pub(crate) fn loads_within<'a>(
        &'a self,
        body: usize,
        element: usize,
        contacts: &'a [Arc<dyn Term>],
    ) -> Vec<&'a dyn Term> {
        let mesh = self.body_of(body).mesh();
        let is_inside =
            |term: &&Arc<dyn Term>| mesh.is_some_and(|mesh| mesh.acts_within(term.coordinates(), element));
        let fixed =
            self.inner_loads.of(body, element).iter().map(|&index| self.system.terms()[index].as_ref());
        fixed.chain(contacts.iter().filter(is_inside).map(AsRef::as_ref)).collect()
    }
}
