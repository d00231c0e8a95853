use ancf_solver::equations::{REDUNDANCY_TOLERANCE, State};
use ancf_solver::factor::Dependence;

use super::assembled::Assembly;
use super::redundancy::{APART, Constraints, Redundancy, Redundant};
use crate::joints::JointEquations;

impl Assembly {
    /// Redundant joint equations in the reference state. Multipliers are shared in the least-squares sense, which does not affect
    /// the motion.
    pub fn redundant(&self) -> &[Redundant] {
        &self.redundancy.equations
    }

    /// Joint equations that are redundant in a state within a relative `tolerance`.
    pub fn redundant_in(&self, s: &State, tolerance: f64) -> Vec<Redundant> {
        let constraints = self.constraints();
        constraints.words(&constraints.dependences(s, tolerance))
    }

    /// Joint equations that contradict others in a state.
    pub fn contradicting(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(s, REDUNDANCY_TOLERANCE);
        let wrong = constraints.contradictions(&found, None, std::iter::once(s.clone()));
        wrong.into_iter().filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// Joint equations that depend on others in the reference state and contradict them in a state.
    ///
    /// Equations of driven sections rotate with time. Two that differ are then no longer dependent.
    pub(crate) fn contradicting_since_rest(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(&self.rest(), REDUNDANCY_TOLERANCE);
        let wrong = constraints.contradictions(&found, None, std::iter::once(s.clone()));
        wrong.into_iter().filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// Nonlinear joint equations that separate from the equations on which they depend after a state. Linear ones are found by
    /// [`contradicting`](Self::contradicting). The state is a solution except for its time.
    pub(crate) fn parting(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(s, REDUNDANCY_TOLERANCE);
        let [phi, floor] = constraints.values(s);
        let parts = |dependence: &&Dependence| {
            let sum = |of: &dyn Fn(usize) -> f64| {
                dependence.coefficients.iter().map(|(&i, &c)| of(i) * c).sum::<f64>()
            };
            let size = dependence.coefficients.iter().map(|(&i, &c)| (c * phi[i]).abs()).sum::<f64>();
            let left = sum(&|i| phi[i]).abs();
            let rounding: f64 = dependence.coefficients.iter().map(|(&i, &c)| (c * floor[i]).abs()).sum();
            left > APART * size && left > 1.0 / APART * rounding
        };
        found.iter().filter(parts).filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// Warnings of joints whose friction depends on a reaction that redundant equations do not determine.
    pub(crate) fn undetermined_friction(&self) -> Vec<String> {
        let observes = |joint: &&JointEquations| {
            joint.parts.iter().any(|part| !part.term.observed_multipliers().is_empty())
        };
        let shares = |joint: &&JointEquations| {
            let of =
                |one: &Redundant| !one.coupling && one.joint == joint.name || one.with.contains(&joint.name);
            self.redundancy.equations.iter().any(of)
        };
        let text = |joint: &JointEquations| {
            format!(
                "the friction of joint `{}` depends on its reaction, which redundant constraints do not determine; the result depends on \
                 how the solver divides the constraint force",
                joint.name
            )
        };
        self.joints.iter().filter(observes).filter(shares).map(text).collect()
    }

    /// Number of constraint equations minus their rank in the reference state.
    pub(crate) fn rank_deficiency(&self) -> usize {
        self.redundancy.rank_deficiency
    }

    /// Multipliers that are undetermined because of redundant equations.
    pub(crate) fn undetermined(&self) -> impl Iterator<Item = usize> {
        self.redundancy.undetermined.iter().copied()
    }

    pub(crate) fn constraints(&self) -> Constraints<'_> {
        Constraints::new(self.system.terms().iter().map(AsRef::as_ref), &self.joints, &self.couplings)
    }

    /// Finds redundant equations and shares their multipliers.
    pub(crate) fn sharing(mut self) -> Self {
        let (rest, constraints) = (self.rest(), self.constraints());
        let found = constraints.dependences(&rest, REDUNDANCY_TOLERANCE);
        let undetermined = constraints.undetermined(&found, &rest);
        let equations = constraints.words(&found);
        self.system = self.system.with_shared_multipliers(undetermined.iter().copied());
        self.redundancy = Redundancy { equations, rank_deficiency: found.len(), undetermined };
        self
    }
}
