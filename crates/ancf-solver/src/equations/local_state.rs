use super::state::{State, StepStates};
use super::term::{LOCAL, Local, LocalStep, Term};

/// State variables of one term, gathered from a global state.
pub(super) struct LocalState {
    q: [f64; LOCAL],
    v: [f64; LOCAL],
    a: [f64; LOCAL],
    lambda: [f64; LOCAL],
}

impl LocalState {
    pub(super) const EMPTY: Self =
        Self { q: [0.0; LOCAL], v: [0.0; LOCAL], a: [0.0; LOCAL], lambda: [0.0; LOCAL] };

    pub(super) fn gather<'a>(&'a mut self, s: &State, term: &dyn Term) -> Local<'a> {
        let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
        for (i, &c) in coordinates.iter().enumerate() {
            self.q[i] = s.q[c];
            self.v[i] = s.v[c];
            self.a[i] = s.a[c];
        }
        let (n, m) = (coordinates.len(), multipliers.len());
        self.lambda[..m].copy_from_slice(&s.lambda[multipliers]);
        Local {
            q: &self.q[..n],
            v: &self.v[..n],
            a: &self.a[..n],
            lambda: &self.lambda[..m],
            t: s.t,
            load: s.load,
        }
    }
}

/// State variables of one term at both ends of a step.
pub(super) struct LocalEnds([LocalState; 2]);

impl LocalEnds {
    pub(super) const EMPTY: Self = Self([LocalState::EMPTY, LocalState::EMPTY]);

    pub(super) fn gather<'a>(
        &'a mut self,
        step: &StepStates<'_>,
        middle: Local<'a>,
        term: &dyn Term,
    ) -> LocalStep<'a> {
        let [from, to] = &mut self.0;
        LocalStep {
            from: from.gather(step.from, term),
            middle,
            to: to.gather(step.to, term),
            damping: step.damping,
        }
    }
}
