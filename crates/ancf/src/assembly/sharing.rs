use ancf_solver::equations::{Dependence, REDUNDANCY_TOLERANCE, State};

use super::assembled::Assembly;
use super::redundant::{APART, Constraints, Redundant};

impl Assembly {
    /// The joint equations that follow from others in the reference state, by name: forces are shared between them in least
    /// squares, and none of the motion depends on how.
    pub fn redundant(&self) -> &[Redundant] {
        &self.redundant
    }

    /// The joint equations that follow from others in a state, or nearly do, and by how much they miss it: less than
    /// `tolerance`, relative to what they tie.
    pub fn redundant_in(&self, s: &State, tolerance: f64) -> Vec<Redundant> {
        let constraints = self.constraints();
        constraints.words(&constraints.dependences(s, tolerance))
    }

    /// The joint equations that contradict others in a state, by name.
    pub fn contradicting(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(s, REDUNDANCY_TOLERANCE);
        let wrong = constraints.contradictions(&found, None, std::iter::once(s.clone()));
        wrong.into_iter().filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// The joint equations that part from those they depend on when time goes on from a state, by name: of equations that are
    /// not linear, where [`contradicting`](Self::contradicting) does not judge. The state is that of a solution but for its time.
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

    /// By how much the constraint equations exceed their rank in the reference state.
    pub(crate) fn rank_deficiency(&self) -> usize {
        self.constraints().dependences(&self.rest(), REDUNDANCY_TOLERANCE).len()
    }

    /// Multipliers that redundant equations leave undetermined.
    pub(crate) fn undetermined(&self) -> impl Iterator<Item = usize> {
        self.undetermined.iter().copied()
    }

    pub(crate) fn constraints(&self) -> Constraints<'_> {
        Constraints::new(self.system.terms().iter().map(AsRef::as_ref), &self.joints, &self.couplings)
    }

    /// Finds out what is redundant, and has its multipliers shared.
    pub(crate) fn sharing(mut self) -> Self {
        let (rest, constraints) = (self.rest(), self.constraints());
        let found = constraints.dependences(&rest, REDUNDANCY_TOLERANCE);
        let undetermined = constraints.undetermined(&found, &rest);
        self.redundant = constraints.words(&found);
        self.system = self.system.with_shared_multipliers(undetermined.iter().copied());
        self.undetermined = undetermined;
        self
    }
}
