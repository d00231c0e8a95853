//! Factors of couplings in other units.

use crate::joints::{Coupled, Coupling, Freed};
use crate::model::Model;
use crate::units::{Dimension, Scales, number};

impl Model {
    /// Couplings in other units. The unit of a factor depends on the coordinate of the joint.
    pub(crate) fn scaled_couplings(&self, s: &Scales) -> Vec<Coupling> {
        let part = |part: &Coupled| {
            let of = match self.coupled(part) {
                Some((_, Freed::Displacement)) => Dimension::new(-1, 0, 0),
                _ => Dimension::NUMBER,
            };
            Coupled { factor: number(part.factor, of, s), ..part.clone() }
        };
        let joints = |coupling: &Coupling| coupling.joints.iter().map(part).collect();
        self.couplings.iter().map(|c| Coupling { name: c.name.clone(), joints: joints(c) }).collect()
    }
}
