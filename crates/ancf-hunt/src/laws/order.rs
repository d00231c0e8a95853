//! Results do not depend on the order of bodies, joints and loads.

use super::law::{Check, EQUAL, Law, check_twin};
use crate::compare::Case;
use crate::random::Random;

/// Random order of bodies, joints, couplings, loads, contacts and probes.
pub(super) struct Order;

impl Law for Order {
    fn name(&self) -> &'static str {
        "order"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let mut twin = case.model.clone();
        twin.bodies.reverse();
        random.shuffle(&mut twin.bodies);
        twin.joints.reverse();
        random.shuffle(&mut twin.joints);
        random.shuffle(&mut twin.loads);
        random.shuffle(&mut twin.couplings);
        random.shuffle(&mut twin.contacts);
        random.shuffle(&mut twin.probes);
        let is_other = twin != case.model;
        check_twin(self.name(), case, is_other.then_some(twin), |_| {}, EQUAL)
    }
}
