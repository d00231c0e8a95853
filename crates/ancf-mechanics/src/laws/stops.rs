use super::contact_law::ContactLaw;
use super::force_law::{ForceLaw, LawNumber, LawState, LawValue};
use crate::kinematics::Real;

/// Stops of a coordinate: one-sided contact beyond a lower and an upper value.
///
/// The force is that of the [`ContactLaw`] for the gaps x − x_lower and x_upper − x, directed to the interval between the stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stops {
    /// Lower and upper stop, if any.
    pub at: [Option<f64>; 2],
    /// Contact law; its friction has no effect.
    pub law: ContactLaw,
}

impl Stops {
    /// Returns the force in the direction of the coordinate.
    fn force<D: Real>(&self, x: D, v: D) -> D {
        let [lower, upper] = self.at;
        let up = lower.map_or(D::from(0.0), |lower| self.law.normal(x - lower, v));
        let down = upper.map_or(D::from(0.0), |upper| self.law.normal(-x + upper, -v));
        up - down
    }
}

impl ForceLaw for Stops {
    fn at(&self, LawState { x, v, .. }: LawState) -> LawValue {
        let along_x = self.force(LawNumber::new(x, 1.0, 0.0), LawNumber::from_re(v));
        let along_v = self.force(LawNumber::from_re(x), LawNumber::new(v, 1.0, 0.0));
        LawValue { force: along_x.re, by_position: along_x.v1, by_rate: along_v.v1 }
    }

    fn is_autonomous(&self) -> bool {
        true
    }
}
