use ancf_solver::equations::{Energy, Local, LocalMatrix, LocalStep, State, Term, Weights};

use crate::constraints::Wrench;
use crate::laws::{LawValue, Resistance};

/// Force along one coordinate, such as the angle of a joint, by a general law of the coordinate and its rate.
///
/// U = ∫ N dx at zero rate; the rest of the force dissipates (N(x, v) − N(x, 0)) v. Of a law that also depends on the time, the
/// force at zero rate supplies work.
///
/// Units: N is energy per unit of the coordinate.
#[derive(Clone, Debug)]
pub struct CoordinateForce {
    coordinate: [usize; 1],
    law: Resistance,
}

impl CoordinateForce {
    /// Creates the force.
    pub const fn new(coordinate: usize, law: Resistance) -> Self {
        Self { coordinate: [coordinate], law }
    }

    fn value(&self, at: &Local<'_>) -> LawValue {
        self.law.at(at.t, at.q[0], at.v[0], at.load)
    }

    /// Returns zero: the equation that defines the coordinate has the reaction.
    pub fn reaction(&self, _: &State) -> Wrench {
        Wrench::default()
    }
}

impl Term for CoordinateForce {
    fn coordinates(&self) -> &[usize] {
        &self.coordinate
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += self.value(at).force;
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += self.law.rounding(at.t, [at.q[0], at.v[0]], [0.0; 2], at.load);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let LawValue { by_position, by_rate, .. } = self.value(at);
        k.add(0, 0, w.q * by_position + w.v * by_rate);
    }

    fn has_kinks(&self) -> bool {
        true
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let middle = &step.middle;
        let force = |v| self.law.at(middle.t, middle.q[0], v, middle.load).force;
        r[0] += self.law.of_step([step.from.q[0], step.to.q[0]], step) + force(middle.v[0]) - force(0.0);
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let LawValue { by_position, by_rate, .. } = self.value(&step.middle);
        k.add(0, 0, 2.0 * step.shares()[1] * w.q * by_position + w.v * by_rate);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        Energy { strain: self.law.potential(at.t, at.q[0], at.load), ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        if self.law.is_autonomous() {
            return 0.0;
        }
        -at.v[0] * self.law.at(at.t, at.q[0], 0.0, at.load).force
    }
}
