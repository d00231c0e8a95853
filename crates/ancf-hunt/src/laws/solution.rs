//! Results do not depend on the procedure of the solution.

use ancf::model::{NewtonMethod, Step};

use super::law::{Check, Law, check_twin};
use crate::compare::{Case, identical, unequal_verdicts};
use crate::random::Random;
use crate::run::{resumed, run_in};

/// New tangents in each iteration, or reused ones.
pub(super) struct Tangents;

impl Law for Tangents {
    fn name(&self) -> &'static str {
        "tangents"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let mut twin = case.model.clone();
        // The tangent of friction is incomplete.
        if twin.contacts.iter().any(|contact| contact.friction > 0.0) {
            return Check::Inapplicable;
        }
        let dynamics =
            twin.analysis.dynamics_mut().filter(|dynamics| matches!(dynamics.step, Step::Fixed(_)));
        let Some(dynamics) = dynamics else { return Check::Inapplicable };
        dynamics.newton = match dynamics.newton {
            NewtonMethod::Full => NewtonMethod::Modified,
            NewtonMethod::Modified => NewtonMethod::Full,
        };
        check_twin(self.name(), case, Some(twin), |_| {}, 1e-5)
    }
}

/// Other numbers of threads: bit-identical.
pub(super) struct Threads;

impl Law for Threads {
    fn name(&self) -> &'static str {
        "threads"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let runs = [1, 3].map(|threads| run_in(&case.model, threads));
        let [one, three] = &runs;
        Check::of(unequal_verdicts(self.name(), one, three).or_else(|| identical(self.name(), one, three)))
    }
}

/// Stopped and resumed from a checkpoint: bit-identical.
pub(super) struct Resumption;

impl Law for Resumption {
    fn name(&self) -> &'static str {
        "resumption"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        if !case.is_dynamic() || !case.base.verdict.is_finished() || case.base.rows() < 4 {
            return Check::Inapplicable;
        }
        let other = resumed(&case.model, 2 + random.index(case.base.rows() - 3));
        let verdict = unequal_verdicts(self.name(), &case.base, &other);
        Check::of(verdict.or_else(|| identical(self.name(), &case.base, &other)))
    }
}
